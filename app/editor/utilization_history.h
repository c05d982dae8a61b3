#pragma once

#include <deque>
#include <vector>

#include "sim/world/frame.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

/// What the utilization of every node was in the last steps, so that the past of a node is known when it is chosen.
/// Keeps as many steps as fit into `max_values` numbers.
class UtilizationHistory {
 public:
  explicit UtilizationHistory(std::size_t max_values = 8'000'000) : max_values_(max_values) {}

  void clear();
  /// Drops what was recorded from `time` [s] on.
  void forget_from(double time);
  /// Takes over the utilizations of a step.
  void record(const Frame& frame);
  /// The past of the piece of material at a node, oldest first. A node that a crack made has that of the node it was
  /// part of; where it broke, the load that broke it stands.
  std::vector<ui::UtilizationSample> samples(const Frame& frame, NodeId node) const;

 private:
  struct Step {
    double time = 0;  ///< [s]
    std::vector<float> utilizations;
  };
  std::size_t max_values_, values_ = 0;
  std::deque<Step> steps_;
};

/// Writes a node's past into its curve, where that is one of the plotted ones.
void fill_utilization(ui::RunCurves& curves, const std::vector<ui::UtilizationSample>& samples);

}  // namespace griffith::app
