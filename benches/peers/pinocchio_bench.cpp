// Pinocchio's articulated body algorithm, and one RK4 step on the Lie group made of four of them.
// The model file is plain text: "gravity g(3)", "joint PARENT KIND R(9) p(3)", "body JOINT mass com(3) I(6)", "q ...",
// "v ...", "tau ..."; a body's numbers are in its joint's frame.
#include <pinocchio/fwd.hpp>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "bench.hpp"

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct Case {
  pinocchio::Model model;
  VectorXd q, v, tau;
};

static void read_row_major(std::istream &line, Matrix3d &matrix) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) line >> matrix(i, j);
}

static void read_vector(std::istream &line, VectorXd &vector) {
  std::vector<double> values;
  for (double value; line >> value;) values.push_back(value);
  vector = Eigen::Map<VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

static pinocchio::JointModel joint_model(const std::string &kind) {
  if (kind == "free_flyer") return pinocchio::JointModelFreeFlyer();
  if (kind == "revolute_x") return pinocchio::JointModelRX();
  if (kind == "revolute_y") return pinocchio::JointModelRY();
  if (kind == "revolute_z") return pinocchio::JointModelRZ();
  throw std::runtime_error("unknown joint kind " + kind);
}

static void read_joint(std::istream &line, pinocchio::Model &model) {
  std::size_t parent = 0;
  std::string kind;
  Matrix3d rotation;
  Vector3d position;
  line >> parent >> kind;
  read_row_major(line, rotation);
  line >> position[0] >> position[1] >> position[2];
  model.addJoint(parent, joint_model(kind), pinocchio::SE3(rotation, position),
                 "joint_" + std::to_string(model.njoints));
}

static void read_body(std::istream &line, pinocchio::Model &model) {
  std::size_t joint = 0;
  double mass = 0.0, i[6];
  Vector3d centre;
  line >> joint >> mass >> centre[0] >> centre[1] >> centre[2];
  for (double &entry : i) line >> entry;
  Matrix3d inertia;
  inertia << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  model.appendBodyToJoint(joint, pinocchio::Inertia(mass, centre, inertia), pinocchio::SE3::Identity());
}

static Case read_case(const char *path) {
  Case result;
  VectorXd gravity;
  std::ifstream file(path);
  for (std::string text; std::getline(file, text);) {
    std::istringstream line(text);
    std::string what;
    line >> what;
    if (what == "gravity") read_vector(line, gravity);
    if (what == "joint") read_joint(line, result.model);
    if (what == "body") read_body(line, result.model);
    if (what == "q") read_vector(line, result.q);
    if (what == "v") read_vector(line, result.v);
    if (what == "tau") read_vector(line, result.tau);
  }
  if (gravity.size() != 3) throw std::runtime_error("gravity is not given");
  result.model.gravity.linear() = gravity;
  result.model.gravity.angular().setZero();
  if (result.q.size() != result.model.nq) throw std::runtime_error("q does not fit the model");
  return result;
}

// Classical RK4: stage configurations and the new one each by one move from the old one.
struct RungeKutta {
  const Case &task;
  pinocchio::Data &data;
  VectorXd q, v, a1, a2, a3, a4, v2, v3, v4, moved;
  static constexpr double h = 1e-3;

  RungeKutta(const Case &task, pinocchio::Data &data) : task(task), data(data) {
    for (VectorXd *vector : {&v, &a1, &a2, &a3, &a4, &v2, &v3, &v4}) vector->resize(task.model.nv);
    moved.resize(task.model.nq);
    reset();
  }

  void reset() {
    q = task.q;
    v = task.v;
  }

  void step() {
    const auto &model = task.model;
    a1 = pinocchio::aba(model, data, q, v, task.tau);
    v2.noalias() = v + h / 2 * a1;
    pinocchio::integrate(model, q, h / 2 * v, moved);
    a2 = pinocchio::aba(model, data, moved, v2, task.tau);
    v3.noalias() = v + h / 2 * a2;
    pinocchio::integrate(model, q, h / 2 * v2, moved);
    a3 = pinocchio::aba(model, data, moved, v3, task.tau);
    v4.noalias() = v + h * a3;
    pinocchio::integrate(model, q, h * v3, moved);
    a4 = pinocchio::aba(model, data, moved, v4, task.tau);
    pinocchio::integrate(model, q, h / 6 * (v + 2 * v2 + 2 * v3 + v4), moved);
    q = moved;
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
};

static std::vector<double> values(const VectorXd &vector) {
  return std::vector<double>(vector.data(), vector.data() + vector.size());
}

int main(int argc, char **argv) {
  if (argc < 3) return bench::run(argc, argv, [] {}, [] {}, [] { return std::vector<double>(); });
  const Case task = read_case(argv[1]);
  pinocchio::Data data(task.model);
  RungeKutta scheme(task, data);
  const std::string operation = argv[2];
  if (operation == "forward")
    return bench::run(
        argc, argv, [] {}, [&] { pinocchio::aba(task.model, data, task.q, task.v, task.tau); },
        [&] { return values(data.ddq); });
  if (operation == "rk4_step")
    return bench::run(
        argc, argv, [&] { scheme.reset(); }, [&] { scheme.step(); },
        [&] {
          auto all = values(scheme.q);
          for (double value : values(scheme.v)) all.push_back(value);
          return all;
        });
  std::fprintf(stderr, "unknown operation %s\n", argv[2]);
  return 2;
}
