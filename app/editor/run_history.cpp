#include "app/editor/run_history.h"

#include <algorithm>
#include <limits>
#include <string>

#include "sim/world/output/step_counters.h"

namespace griffith::app {
namespace {

/// A number of a frame that is neither an energy nor a counter.
struct FrameNumber {
  const char *key, *label, *unit;
  double (*value)(const Frame& frame);
};

constexpr FrameNumber kFrameNumbers[] = {
    {"pieces", "Pieces", "", [](const Frame& frame) { return static_cast<double>(frame.bodies.size()); }},
    {"cracks", "Cracks", "", [](const Frame& frame) -> double { return frame.report.cracks; }},
    {"crack_area", "Crack area", "m²", [](const Frame& frame) { return frame.energy.crack_area; }},
    {"peak_utilization", "Highest utilization", "-", [](const Frame& frame) { return frame.report.peak_utilization; }},
    {ui::kNodeUtilization, "Utilization of the node", "-",  // known in the utilization history
     [](const Frame&) { return std::numeric_limits<double>::quiet_NaN(); }},
    {"milliseconds", "Step time", "ms", [](const Frame& frame) { return frame.report.milliseconds.step; }},
    {"milliseconds.contact", "Contact time", "ms",
     [](const Frame& frame) { return frame.report.milliseconds.contact; }},
    {"milliseconds.elasticity", "Elasticity time", "ms",
     [](const Frame& frame) { return frame.report.milliseconds.elasticity; }},
    {"milliseconds.explicit", "Explicit dynamics time", "ms",
     [](const Frame& frame) { return frame.report.milliseconds.explicit_dynamics; }},
    {"milliseconds.separation", "Separation time", "ms",
     [](const Frame& frame) { return frame.report.milliseconds.separation; }},
    {"milliseconds.fracture", "Fracture time", "ms",
     [](const Frame& frame) { return frame.report.milliseconds.fracture; }},
};

/// Makes a series of a column of the probe table: "tip.velocity.x [m/s]".
ui::RunSeries probe_series(const std::string& column) {
  const std::size_t bracket = column.rfind(" [");
  const std::string name = column.substr(0, bracket);
  const std::string unit = bracket == std::string::npos ? "" : column.substr(bracket + 2, column.size() - bracket - 3);
  return {"probe." + name, "Probes", name, unit};
}

std::vector<ui::RunSeries> series_of(const Frame& frame) {
  std::vector<ui::RunSeries> series;
  for (const FrameNumber& number : kFrameNumbers) series.push_back({number.key, "Step", number.label, number.unit});
  for (const EnergyEntry& entry : energy_entries())
    series.push_back({"energy." + std::string(entry.key), "Energy", std::string(entry.label), "J"});
  series.push_back({"energy.unaccounted", "Energy", "Unaccounted", "J"});
  for (const StepCounter& counter : step_counters())
    series.push_back({std::string(counter.key), "Counters", std::string(counter.label), std::string(counter.unit)});
  for (const std::string& column : probe_columns(frame.probes)) series.push_back(probe_series(column));
  return series;
}

/// Returns the values in the order of series_of().
std::vector<double> values_in(const Frame& frame) {
  std::vector<double> values;
  for (const FrameNumber& number : kFrameNumbers) values.push_back(number.value(frame));
  for (const EnergyEntry& entry : energy_entries()) values.push_back(frame.energy.*entry.value);
  values.push_back(frame.energy.unaccounted());
  for (const StepCounter& counter : step_counters())
    values.push_back(std::visit([&](auto value) -> double { return frame.report.*value; }, counter.value));
  const std::vector<double> probed = probe_values(frame.probes, frame);
  values.insert(values.end(), probed.begin(), probed.end());
  return values;
}

/// A branch on the path to another, with its last step on that path.
struct BranchSpan {
  int branch = 0;
  std::int64_t last_step = 0;
};

/// Returns the path from the oldest ancestor to the branch itself.
std::vector<BranchSpan> way_to(std::span<const Branch> branches, int branch) {
  std::vector<BranchSpan> way;
  for (std::int64_t last = branches[branch].last_step; branch >= 0; branch = branches[branch].parent) {
    way.push_back({branch, last});
    last = std::min(last, branches[branch].first_step);
  }
  std::ranges::reverse(way);
  return way;
}

/// Returns the branch in which a step on the path to another branch was made.
int maker_of(std::span<const Branch> branches, int branch, std::int64_t step) {
  while (branches[branch].parent >= 0 && step <= branches[branch].first_step) branch = branches[branch].parent;
  return branch;
}

}  // namespace

void RunHistory::restart(const Frame& frame) {
  series_ = series_of(frame);
  branches_.clear();
  values_ = 0;
}

void RunHistory::record(const Timeline& timeline) {
  const Frame frame = timeline.world().frame();
  const auto maker = static_cast<std::size_t>(maker_of(timeline.branches(), timeline.branch(), frame.step));
  if (branches_.size() <= maker) branches_.resize(maker + 1);
  std::deque<Row>& rows = branches_[maker];
  if (!rows.empty() && rows.back().step >= frame.step) return;
  rows.push_back({frame.step, frame.time, values_in(frame)});
  values_ += series_.size();
  thin_out();
}

void RunHistory::thin_out() {
  for (; values_ > max_values_; values_ -= series_.size()) {
    const auto longest =
        std::ranges::max_element(branches_, {}, [](const std::deque<Row>& rows) { return rows.size(); });
    if (longest->size() < 2) return;
    longest->pop_front();
  }
}

ui::RunCurves RunHistory::curves(const Timeline& timeline, const ui::PlotChoice& chosen) const {
  ui::RunCurves curves;
  std::vector<std::size_t> columns;
  for (std::size_t slot = 0; slot < chosen.size(); ++slot) {
    const auto series = std::ranges::find(series_, chosen[slot], &ui::RunSeries::key);
    if (series == series_.end()) continue;
    columns.push_back(static_cast<std::size_t>(series - series_.begin()));
    curves.curves.push_back({*series, slot, {}});
  }
  for (const BranchSpan& span : way_to(timeline.branches(), timeline.branch())) {
    if (static_cast<std::size_t>(span.branch) >= branches_.size()) continue;
    for (const Row& row : branches_[span.branch]) {
      if (row.step > span.last_step) break;
      curves.steps.push_back(row.step);
      curves.times.push_back(row.time);
      for (std::size_t i = 0; i < columns.size(); ++i) curves.curves[i].values.push_back(row.values[columns[i]]);
    }
  }
  return curves;
}

}  // namespace griffith::app
