#include "app/editor/compared_branch.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "ui/model/units.h"

namespace griffith::app {
namespace {

std::string length_text(double length) { return ui::format_quantity(length, "m", 3); }

/// Describes the place of a gap: `at (0.1, 1.2, 0) m of "wall"`.
std::string place_text(const Gap& gap, const Scene& scene) {
  std::string text = "at (";
  for (int i = 0; i < 3; ++i) text += (i > 0 ? ", " : "") + ui::format_quantity(gap.place[i], "", 3);
  return text + ") m of \"" + scene.bodies[static_cast<std::size_t>(gap.scene_body)].name + "\"";
}

/// Goes to a step of the branch. Steps beyond its end are computed, at least one, for a limited time.
void run_on(Timeline& timeline, std::int64_t step) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kFractionOfFrame(30);
  const Clock::time_point deadline = Clock::now() + kFractionOfFrame;
  timeline.go_to(step);
  while (timeline.step() < step) {
    timeline.advance();
    if (Clock::now() >= deadline) return;
  }
}

}  // namespace

Gap largest_gap(const Frame& a, const Frame& b) {
  Gap gap;
  const std::size_t nodes = std::min(a.nodes.positions.size(), b.nodes.positions.size());
  for (std::size_t node = 0; node < nodes; ++node) {
    if (a.nodes.rest_positions[node] != b.nodes.rest_positions[node]) continue;  // made by different cracks
    const double distance = (a.nodes.positions[node] - b.nodes.positions[node]).norm();
    if (!(distance > gap.distance)) continue;
    const BodyId body = a.elements.bodies[a.nodes.stars[node].front()];
    gap = {distance, a.bodies[body].scene_body, a.nodes.positions[node]};
  }
  return gap;
}

std::optional<Divergence> first_divergence(const Timeline& a, const Timeline& b) {
  const std::vector<StateHashes> left = a.hashes(), right = b.hashes();
  const auto [first, other_first] = std::ranges::mismatch(left, right);
  if (first == left.end() || other_first == right.end()) return std::nullopt;
  const std::int64_t step = a.first_step() + (first - left.begin());
  Timeline one = a, other = b;
  one.go_to(step);
  other.go_to(step);
  return Divergence{step, one.world().frame().time, largest_gap(one.world().frame(), other.world().frame())};
}

ComparedBranch::ComparedBranch(Timeline timeline, int branch, EmbeddedDisplay display)
    : timeline_(std::move(timeline)), display_(std::move(display)) {
  timeline_.go_to(branch, timeline_.step());
}

void ComparedBranch::follow(const Timeline& shown) {
  run_on(timeline_, shown.step());
  if (std::exchange(shown_branch_, shown.branch()) != shown.branch()) divergence_.reset(), compared_to_ = -1;
  const std::int64_t common = std::min(shown.last_step(), timeline_.last_step());
  if (divergence_ || common == compared_to_) return;
  divergence_ = first_divergence(shown, timeline_);
  compared_to_ = common;
}

std::string ComparedBranch::difference(const Timeline& shown, const Scene& scene) const {
  const std::string name = "Branch " + std::to_string(branch());
  std::string text =
      is_behind(shown) ? name + " is computed up to step " + std::to_string(timeline_.step()) + " so far. " : "";
  if (!divergence_) return text + name + " is the same as far as both go.";
  text += name + " differs from step " + std::to_string(divergence_->step) + " (" +
          ui::format_quantity(divergence_->time, "s", 3) + ") on";
  if (divergence_->gap.scene_body >= 0) text += ", most " + place_text(divergence_->gap, scene);
  text += ".";
  if (is_behind(shown)) return text;
  const Gap now = largest_gap(shown.world().frame(), frame());
  if (now.scene_body < 0) return text + " Now all nodes are in the same places.";
  return text + " Now up to " + length_text(now.distance) + " apart, " + place_text(now, scene) + ".";
}

void ComparedBranch::draw(const Scene& scene, const ViewSettings& view, const std::optional<Vec2>& range,
                          const HiddenBodies& hidden, const render::Camera& camera,
                          const render::RenderOptions& options) {
  follow_first_cracks(display_, frame(), scene);
  renderer_.render(draw_scene_from_frame(frame(), display_, scene, view, {}, range, hidden), camera, options);
}

}  // namespace griffith::app
