#pragma once

#include <chrono>

namespace griffith {

/// Calls work() and adds its milliseconds to a phase; for display only. Returns what the work returns.
template <class Work>
auto timed(double& milliseconds, const Work& work) {
  using Clock = std::chrono::steady_clock;
  struct Timer {
    double& milliseconds;
    Clock::time_point start = Clock::now();
    ~Timer() { milliseconds += std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }
  } timer{milliseconds};
  return work();
}

}  // namespace griffith
