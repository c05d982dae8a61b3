#pragma once

#include <deque>
#include <vector>

#include "sim/world/frame.h"
#include "ui/editor_state.h"

namespace griffith::app {

/// What the margin of every node was in the last steps, so that the past of a node is known when it is chosen. Keeps as
/// many steps as fit into `most_values` numbers.
class MarginHistory {
 public:
  explicit MarginHistory(std::size_t most_values = 8'000'000) : most_values_(most_values) {}

  void clear();
  /// Takes over the margins of a step.
  void record(const Frame& frame);
  /// The past of the piece of material at a node, oldest first. A node that a crack made has that of the node it was
  /// part of; where it broke, the load that broke it stands.
  std::vector<ui::MarginSample> samples(const Frame& frame, NodeId node) const;

 private:
  struct Step {
    double time = 0;  ///< [s]
    std::vector<float> margins;
  };
  std::size_t most_values_, values_ = 0;
  std::deque<Step> steps_;
};

}  // namespace griffith::app
