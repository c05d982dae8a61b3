#pragma once

#include <deque>
#include <span>
#include <vector>

#include "sim/timeline/timeline.h"
#include "ui/model/run_curves.h"

namespace griffith::app {

/// What can be told in a number of every step, branch by branch: energies, counters, milliseconds, probes. A step keeps
/// the values that it had when it was made first. Holds as many steps as fit into `max_values` numbers of eight bytes
/// (64 MB, some 170,000 steps without probes); beyond that the earliest ones of the branch that has the most are
/// dropped.
class RunHistory {
 public:
  explicit RunHistory(std::size_t max_values = 8'000'000) : max_values_(max_values) {}

  /// Forgets everything; from now on the world of `frame` is recorded.
  void restart(const Frame& frame);
  /// Takes over the step at which the timeline is, unless it is known.
  void record(const Timeline& timeline);

  /// All series, in the order in which lists show them.
  std::span<const ui::RunSeries> series() const { return series_; }
  /// The chosen ones on the way to the end of the timeline's branch.
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
  std::vector<std::deque<Row>> branches_;  ///< by their numbers: steps after the branch's first, of branch 0 that too
};

}  // namespace griffith::app
