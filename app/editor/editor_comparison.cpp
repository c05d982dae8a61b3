#include <cstdint>

#include "app/editor/editor.h"
#include "app/picture/picture_options.h"

namespace griffith::app {

void Editor::toggle_comparison() {
  std::optional<int>& branch = state_.comparison.branch;
  if (branch) return branch.reset();
  const int parent = timeline_.branches()[timeline_.branch()].parent;
  branch = parent >= 0 ? parent : static_cast<int>(timeline_.branches().size()) - 1;
}

void Editor::follow_comparison() {
  std::optional<int>& branch = state_.comparison.branch;
  const int branches = static_cast<int>(timeline_.branches().size());
  if (branch && (*branch == timeline_.branch() || *branch >= branches)) branch.reset();
  if (!branch) return compared_.reset();
  if (!compared_ || compared_->branch() != *branch)
    compared_ = std::make_unique<ComparedBranch>(timeline_, *branch, display_);
  compared_->follow(timeline_);
}

void Editor::draw_comparison(const PictureKey& key, std::optional<int> samples) {
  if (!compared_) return;
  compared_->draw(built_, state_.view, range_.range(), hidden_bodies(), picture_camera(),
                  picture_options(key.width, key.height, samples, state_.view));
  difference_ = compared_->difference(timeline_, built_);
}

std::optional<ui::ComparisonView> Editor::comparison_view() const {
  if (!compared_) return std::nullopt;
  ui::ComparisonView view{compared_->branch(),
                          reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(compared_->color_texture())),
                          difference_,
                          {}};
  if (state_.plots.shown) view.curves = run_history_.curves(compared_->timeline(), state_.preferences.plotted);
  return view;
}

}  // namespace griffith::app
