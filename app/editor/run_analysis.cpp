#include "app/editor/run_analysis.h"

#include <cstdint>
#include <utility>

#include "app/editor/holding_report.h"
#include "app/picture/picture_options.h"

namespace griffith::app {

void RunAnalysis::explain_holding() {
  if (!state_.stop || !state_.stop->node.valid()) return;
  state_.running = false;
  holding_ = std::make_unique<HoldingSearch>(run_.timeline(), state_.stop->node);
  state_.work = holding_->stage();
}

void RunAnalysis::go_on() {
  if (!holding_) return;
  if (std::exchange(state_.cancel_work, false)) holding_->cancel();
  std::optional<HoldingAnswer> answer = holding_->take();
  if (!answer) return;
  found_ = HoldingFound{std::move(*answer), holding_->run()};
  state_.report = holding_report(found_->answer, found_->run);
  holding_.reset();
}

void RunAnalysis::toggle_comparison() {
  std::optional<int>& branch = state_.comparison.branch;
  if (branch) return branch.reset();
  const Timeline& timeline = run_.timeline();
  const int parent = timeline.branches()[timeline.branch()].parent;
  branch = parent >= 0 ? parent : static_cast<int>(timeline.branches().size()) - 1;
}

void RunAnalysis::follow_comparison() {
  std::optional<int>& branch = state_.comparison.branch;
  const Timeline& timeline = run_.timeline();
  if (branch && (*branch == timeline.branch() || *branch >= static_cast<int>(timeline.branches().size())))
    branch.reset();
  if (!branch) return compared_.reset();
  const std::int64_t world = run_.shown().version.world;
  const bool is_new = std::exchange(compared_world_, world) != world;
  if (!compared_ || compared_->branch() != *branch || is_new)
    compared_ = std::make_unique<ComparedBranch>(timeline, *branch, viewport_.display());
  compared_->follow(timeline);
  state_.comparison.step = compared_->timeline().step();
}

bool RunAnalysis::computes_comparison() const { return compared_ && compared_->is_behind(run_.timeline()); }

void RunAnalysis::draw_comparison(std::optional<int> samples) {
  if (!compared_) return;
  const ExportedView view = viewport_.exported_view(run_.built());
  ViewSettings drawn = view.view;
  drawn.quality = viewport_.drawn_quality();
  compared_->draw(run_.built(), view.view, viewport_.range(), view.hidden, view.camera,
                  picture_options(view.width, view.height, samples, drawn));
  difference_ = compared_->difference(run_.timeline(), run_.built());
}

std::optional<ui::ComparisonView> RunAnalysis::comparison_view() const {
  if (!compared_) return std::nullopt;
  ui::ComparisonView view{compared_->branch(),
                          reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(compared_->color_texture())),
                          difference_,
                          {}};
  if (state_.plots.shown) view.curves = run_.history().curves(compared_->timeline(), state_.preferences.plotted);
  return view;
}

ui::RunCurves RunAnalysis::plotted_curves() const {
  ui::RunCurves curves = run_.history().curves(run_.timeline(), state_.preferences.plotted);
  fill_utilization(curves, run_.utilizations());
  return curves;
}

}  // namespace griffith::app
