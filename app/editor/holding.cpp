#include "app/editor/holding.h"

#include <algorithm>

namespace griffith::app {
namespace {

/// What resists opening, times a factor.
Material stronger(Material material, double factor) {
  material.tensile_strength *= factor;
  material.fracture_toughness *= factor;
  material.separation_toughness *= factor;
  return material;
}

}  // namespace

HoldingFactor holding_factor(const std::function<bool(double)>& holds, double largest) {
  constexpr double kClose = 1.01;
  HoldingFactor found;
  found.runs = 1;
  found.breaks_at_one = !holds(1);
  while (found.breaks_at_one && !found.found && found.breaks < largest) {
    found.holds = std::min(2 * found.breaks, largest);
    ++found.runs;
    if (holds(found.holds)) {
      found.found = true;
    } else {
      found.breaks = found.holds;
    }
  }
  while (found.found && found.holds > kClose * found.breaks) {
    const double middle = (found.breaks + found.holds) / 2;
    ++found.runs;
    (holds(middle) ? found.holds : found.breaks) = middle;
  }
  return found;
}

HoldingFactor strength_that_holds(const World& before, int scene_body, NodeId node) {
  const Material material = before.frame().materials[scene_body];
  const Vec3 place = before.frame().nodes.rest_positions[node];
  return holding_factor([&](double factor) {
    World world = before;
    const std::size_t cracks = world.frame().crack_events.size();
    world.set_material(scene_body, stronger(material, factor));
    world.step();
    const auto events = world.frame().crack_events.subspan(cracks);
    return std::ranges::none_of(events, [&](const CrackEvent& event) { return event.rest_position == place; });
  });
}

}  // namespace griffith::app
