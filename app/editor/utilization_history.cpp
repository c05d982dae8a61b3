#include "app/editor/utilization_history.h"

#include <algorithm>

namespace griffith::app {
namespace {

/// Returns the first node at each copy's rest position, from the latest to the oldest: the one that existed at an
/// earlier step is the copy's origin.
std::vector<NodeId> ancestors(const Frame& frame, NodeId node) {
  std::vector<NodeId> nodes = {node};
  for (std::int32_t i = node.index() - 1; i >= 0; --i)
    if (frame.nodes.rest_positions[i] == frame.nodes.rest_positions[node]) nodes.emplace_back(i);
  return nodes;
}

}  // namespace

void UtilizationHistory::clear() {
  steps_.clear();
  values_ = 0;
}

void UtilizationHistory::forget_from(double time) {
  for (; !steps_.empty() && steps_.back().time >= time; steps_.pop_back()) values_ -= steps_.back().utilizations.size();
}

void UtilizationHistory::record(const Frame& frame) {
  Step step{frame.time, {}};
  step.utilizations.reserve(frame.nodes.separations.size());
  for (const NodeSeparation& separation : frame.nodes.separations)
    step.utilizations.push_back(static_cast<float>(separation.utilization));
  values_ += step.utilizations.size();
  steps_.push_back(std::move(step));
  while (values_ > max_values_ && steps_.size() > 1) {
    values_ -= steps_.front().utilizations.size();
    steps_.pop_front();
  }
}

std::vector<ui::UtilizationSample> UtilizationHistory::samples(const Frame& frame, NodeId node) const {
  const std::vector<NodeId> nodes = ancestors(frame, node);
  std::vector<ui::UtilizationSample> samples;
  for (const Step& step : steps_) {
    const auto known = std::ranges::find_if(
        nodes, [&](NodeId candidate) { return static_cast<std::size_t>(candidate) < step.utilizations.size(); });
    if (known != nodes.end()) samples.push_back({step.time, step.utilizations[*known], false});
  }
  for (const CrackEvent& event : frame.crack_events) {
    const bool recorded = !steps_.empty() && event.time >= steps_.front().time;
    if (recorded && event.rest_position == frame.nodes.rest_positions[node])
      samples.push_back({event.time, static_cast<float>(event.load / event.resistance), true});
  }
  std::ranges::stable_sort(samples, {}, &ui::UtilizationSample::time);
  return samples;
}

void fill_utilization(ui::RunCurves& curves, const std::vector<ui::UtilizationSample>& samples) {
  const auto curve = std::ranges::find(curves.curves, std::string(ui::kNodeUtilization),
                                       [](const ui::RunCurve& other) { return other.series.key; });
  if (curve == curves.curves.end()) return;
  for (const ui::UtilizationSample& sample : samples) {
    const auto row = std::ranges::lower_bound(curves.times, sample.time);
    if (row != curves.times.end() && *row == sample.time && !sample.broke)
      curve->values[static_cast<std::size_t>(row - curves.times.begin())] = static_cast<double>(sample.utilization);
  }
}

}  // namespace griffith::app
