#include "app/editor/run_pace.h"

#include <algorithm>
#include <cmath>

namespace griffith::app {
namespace {

constexpr double kRateSeconds = 2;

constexpr double kTimeForSteps = 0.04;  // seconds per picture
constexpr int kMaxSteps = 32;
constexpr double kSmoothing = 0.1;
constexpr double kRoundOff = 1e-9;

}  // namespace

void RateMeter::add(double elapsed, double amount) {
  now_ += std::max(elapsed, 0.0);
  if (amount <= 0) return;
  portions_.push_back({now_, portions_.back().total + amount});
  while (portions_.size() > 2 && portions_[1].time <= now_ - kRateSeconds) portions_.pop_front();
}

double RateMeter::rate() const {
  const Portion &first = portions_.front(), &last = portions_.back();
  if (portions_.size() < 2 || last.time <= first.time) return 0;
  const double newest = last.total - portions_[portions_.size() - 2].total;
  const double made = (last.total - first.total) / (last.time - first.time);
  return now_ > last.time ? std::min(made, (last.total - first.total + newest) / (now_ - first.time)) : made;
}

int StepPacer::steps_due(double elapsed, double speed, double time_step, double step_cost) {
  debt_ += std::max(elapsed, 0.0) * speed;
  const double affordable = step_cost > 0 ? kTimeForSteps / step_cost : kMaxSteps;
  const int maximum = static_cast<int>(std::clamp(affordable, 1.0, static_cast<double>(kMaxSteps)));
  const double due = std::floor(debt_ / time_step + kRoundOff);
  const int steps = static_cast<int>(std::min(due, static_cast<double>(maximum)));
  const bool dropped = due > steps;
  debt_ = dropped ? 0 : std::max(debt_ - steps * time_step, 0.0);
  follow(dropped);
  return steps;
}

void StepPacer::wait(double elapsed, double speed, double time_step) {
  const double due = debt_ + std::max(elapsed, 0.0) * speed;
  debt_ = std::min(due, time_step);
  follow(due > time_step);
}

void StepPacer::follow(bool dropped) { shortage_ += kSmoothing * ((dropped ? 1.0 : 0.0) - shortage_); }

}  // namespace griffith::app
