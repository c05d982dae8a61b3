#pragma once

#include <deque>
#include <vector>

#include "sim/world/output/frame.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

/// Utilization of every node in the last steps, so that the past of a node is known when it is selected. Keeps as many
/// steps as fit into `max_values` numbers.
class UtilizationHistory {
 public:
  explicit UtilizationHistory(std::size_t max_values = 8'000'000) : max_values_(max_values) {}

  void clear();
  /// Drops the records from `time` [s] on.
  void forget_from(double time);
  /// Records the utilizations of a step.
  void record(const Frame& frame);
  /// Returns the past of the material at a node, oldest first. A node made by a crack has the past of its original
  /// node; at the time of fracture, the load is the one that caused it.
  std::vector<ui::UtilizationSample> samples(const Frame& frame, NodeId node) const;

 private:
  struct Step {
    double time = 0;  ///< [s]
    std::vector<float> utilizations;
  };
  std::size_t max_values_, values_ = 0;
  std::deque<Step> steps_;
};

/// Writes a node's past into its curve, if that is plotted.
void fill_utilization(ui::RunCurves& curves, const std::vector<ui::UtilizationSample>& samples);

}  // namespace griffith::app
