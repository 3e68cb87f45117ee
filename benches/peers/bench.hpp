// The manner of every benchmark program: PROGRAM MODEL OPERATION MODE NUMBERS
//   time BATCHES REPETITIONS   one line per batch: nanoseconds per repetition
//   count REPETITIONS          one batch without a clock, for an instruction counter
//   check REPETITIONS          the result after that many repetitions, one number per line
// A batch starts from the fixed state and repeats the operation.
#pragma once

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace bench {

// keeps the compiler from moving work out of the loop; costs no instruction
inline void barrier() { asm volatile("" ::: "memory"); }

template <typename Reset, typename Operation, typename Result>
int run(int argc, char **argv, Reset reset, Operation operation, Result result) {
  const std::string mode = argc > 4 ? argv[3] : "";
  auto batch = [&](long repetitions) {
    for (long i = 0; i < repetitions; ++i) {
      operation();
      barrier();
    }
  };
  if (mode == "time" && argc == 6) {
    const long batches = std::atol(argv[4]), repetitions = std::atol(argv[5]);
    reset();
    batch(repetitions);  // warm-up
    for (long i = 0; i < batches; ++i) {
      reset();
      const auto start = std::chrono::steady_clock::now();
      batch(repetitions);
      const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
      std::printf("%.3f\n", taken.count() / static_cast<double>(repetitions));
    }
    return 0;
  }
  if (mode == "count" && argc == 5) {
    reset();
    batch(std::atol(argv[4]));
    return 0;
  }
  if (mode == "check" && argc == 5) {
    reset();
    batch(std::atol(argv[4]));
    for (double value : result()) std::printf("%.17g\n", value);
    return 0;
  }
  std::fprintf(stderr, "usage: PROGRAM MODEL OPERATION time BATCHES REPETITIONS|count N|check N\n");
  return 2;
}

}  // namespace bench
