#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace griffith::app {

/// A progress line on the terminal; silent if stderr is not a terminal.
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

/// A line on the terminal with the stage of work of unknown length; silent if stderr is not a terminal.
class StageProgress {
 public:
  StageProgress();
  /// Erases the line.
  ~StageProgress();
  StageProgress(const StageProgress&) = delete;
  StageProgress& operator=(const StageProgress&) = delete;

  void enter(std::string_view stage);
  /// Prints a permanent line, even if stderr is no terminal.
  void note(const std::string& line);

 private:
  bool shown_;
};

}  // namespace griffith::app
