// MuJoCo's forward dynamics and one step of its Euler scheme or RK4. The model is MJCF beside a text file with the lines
// "qpos ...", "qvel ...", "qfrc ..." (MODEL.xml and MODEL.txt). Every stage that this model has no use for
// is switched off as its users can: contacts, constraints, passive forces, actuation, sensors, gravity where
// there is none. A tendon, the rope of a lift, is a passive force.
#include <mujoco/mujoco.h>

#include <cstring>
#include <fstream>
#include <sstream>

#include "bench.hpp"

struct Start {
  std::vector<double> qpos, qvel, qfrc;
};

static Start read_start(const std::string &path) {
  Start start;
  std::ifstream file(path);
  for (std::string text; std::getline(file, text);) {
    std::istringstream line(text);
    std::string what;
    line >> what;
    auto &target = what == "qpos" ? start.qpos : what == "qvel" ? start.qvel : start.qfrc;
    for (double value; line >> value;) target.push_back(value);
  }
  return start;
}

static std::vector<double> values(const mjtNum *first, std::size_t count) {
  return std::vector<double>(first, first + count);
}

static int measure(int argc, char **argv, mjModel *model, mjData *data, const Start &start) {
  const std::string operation = argv[2];
  auto reset = [&] {
    mj_resetData(model, data);
    std::memcpy(data->qpos, start.qpos.data(), start.qpos.size() * sizeof(mjtNum));
    std::memcpy(data->qvel, start.qvel.data(), start.qvel.size() * sizeof(mjtNum));
    std::memcpy(data->qfrc_applied, start.qfrc.data(), start.qfrc.size() * sizeof(mjtNum));
  };
  if (operation == "forward")
    return bench::run(
        argc, argv, reset, [&] { mj_forward(model, data); },
        [&] { return values(data->qacc, start.qvel.size()); });
  model->opt.integrator = operation == "euler_step" ? mjINT_EULER : mjINT_RK4;
  if (operation == "euler_step" || operation == "rk4_step")
    return bench::run(
        argc, argv, reset, [&] { mj_step(model, data); },
        [&] {
          auto all = values(data->qpos, start.qpos.size());
          for (double value : values(data->qvel, start.qvel.size())) all.push_back(value);
          return all;
        });
  std::fprintf(stderr, "unknown operation %s\n", argv[2]);
  return 2;
}

int main(int argc, char **argv) {
  if (argc < 3) return bench::run(argc, argv, [] {}, [] {}, [] { return std::vector<double>(); });
  char error[1000] = "";
  const std::string path = argv[1];
  mjModel *model = mj_loadXML((path + ".xml").c_str(), nullptr, error, sizeof error);
  if (!model) {
    std::fprintf(stderr, "%s\n", error);
    return 2;
  }
  model->opt.disableflags |= mjDSBL_AUTORESET;
  if (model->ntendon == 0) model->opt.disableflags |= mjDSBL_SPRING | mjDSBL_DAMPER;
  if (model->opt.gravity[2] == 0.0) model->opt.disableflags |= mjDSBL_GRAVITY;
  const Start start = read_start(path + ".txt");
  if (static_cast<int>(start.qpos.size()) != model->nq || static_cast<int>(start.qvel.size()) != model->nv) {
    std::fprintf(stderr, "the state does not fit the model\n");
    return 2;
  }
  mjData *data = mj_makeData(model);
  const int code = measure(argc, argv, model, data, start);
  mj_deleteData(data);
  mj_deleteModel(model);
  return code;
}
