#pragma once

#include <chrono>
#include <string>

namespace griffith::app {

/// A line on the terminal that says how far long work is; silent when stderr is not a terminal.
class Progress {
 public:
  /// `label`: "Simulating". `total` >= 1 units of work.
  Progress(std::string label, int total);
  /// Erases the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(int done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string label_;
  int total_;
  bool shown_;
  Clock::time_point start_, last_;
};

}  // namespace griffith::app
