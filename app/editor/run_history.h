#pragma once

#include <deque>
#include <span>
#include <vector>

#include "sim/timeline/timeline.h"
#include "ui/model/run_curves.h"

namespace griffith::app {

/// Values of every step by branch: energies, counters, milliseconds, probes. A step keeps the values of its first
/// computation. Holds `max_values` numbers of eight bytes (64 MB, some 170,000 steps without probes); beyond that, the
/// earliest steps of the longest branch are dropped.
class RunHistory {
 public:
  explicit RunHistory(std::size_t max_values = 8'000'000) : max_values_(max_values) {}

  /// Clears everything and records the world of `frame` from now on.
  void restart(const Frame& frame);
  /// Records the timeline's current step, unless it is known.
  void record(const Timeline& timeline);

  /// Returns all series in the order of lists.
  std::span<const ui::RunSeries> series() const { return series_; }
  /// Returns the chosen series up to the end of the timeline's branch.
  ui::RunCurves curves(const Timeline& timeline, const ui::PlotChoice& chosen) const;

 private:
  struct Row {
    std::int64_t step = 0;
    double time = 0;  ///< [s]
    std::vector<double> values;
  };
  void thin_out();

  std::size_t max_values_, values_ = 0;
  std::vector<ui::RunSeries> series_;
  std::vector<std::deque<Row>> branches_;  ///< by branch: steps after the branch's first one; branch 0 includes it
};

}  // namespace griffith::app
