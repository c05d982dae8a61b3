#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/editor/compared_branch.h"
#include "app/editor/holding_edits.h"
#include "app/editor/holding_search.h"
#include "app/editor/run_controller.h"

namespace griffith::app {

/// Questions about the run: what would have held a node, where branches differ, how values went.
class RunAnalysis {
 public:
  RunAnalysis(ui::EditorState& state, const RunController& run, const Viewport& viewport)
      : state_(state), run_(run), viewport_(viewport) {}

  /// Begins to search the strength, speed and thickness at which the cracking node would hold.
  void explain_holding();
  /// Continues the search; its answer becomes a report. Call it in every drawn frame.
  void go_on();
  /// Describes the progress of the search; empty if there is none.
  std::string stage() const { return holding_ ? holding_->stage() : std::string(); }

  /// Returns the result of the last search; empty before the first.
  const std::optional<HoldingFound>& found() const { return found_; }

  /// Compares with the parent branch or the newest one; or ends the comparison.
  void toggle_comparison();
  /// Brings the compared branch to the shown step.
  void follow_comparison();
  /// True if steps of the compared branch are still to be computed.
  bool computes_comparison() const;
  /// Draws the compared branch as the viewport draws the shown one. `samples`: as in Viewport::draw().
  void draw_comparison(std::optional<int> samples);
  std::optional<ui::ComparisonView> comparison_view() const;

  /// Returns the plotted series of the shown branch.
  ui::RunCurves plotted_curves() const;

 private:
  ui::EditorState& state_;
  const RunController& run_;
  const Viewport& viewport_;
  std::unique_ptr<HoldingSearch> holding_;
  std::optional<HoldingFound> found_;
  std::unique_ptr<ComparedBranch> compared_;
  std::int64_t compared_world_ = -1;  ///< world of the compared branch
  std::string difference_;            ///< text about the compared branch
};

}  // namespace griffith::app
