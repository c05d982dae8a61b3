#include "app/editor/rate_meter.h"

#include <algorithm>

namespace griffith::app {
namespace {

constexpr double kSeconds = 2;

}  // namespace

void RateMeter::add(double elapsed, double amount) {
  now_ += std::max(elapsed, 0.0);
  if (amount <= 0) return;
  portions_.push_back({now_, portions_.back().total + amount});
  while (portions_.size() > 2 && portions_[1].time <= now_ - kSeconds) portions_.pop_front();
}

double RateMeter::rate() const {
  const Portion &first = portions_.front(), &last = portions_.back();
  if (portions_.size() < 2 || last.time <= first.time) return 0;
  const double newest = last.total - portions_[portions_.size() - 2].total;
  const double made = (last.total - first.total) / (last.time - first.time);
  return now_ > last.time ? std::min(made, (last.total - first.total + newest) / (now_ - first.time)) : made;
}

}  // namespace griffith::app
