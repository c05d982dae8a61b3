#include "sim/world/conditions/grab.h"

#include <algorithm>
#include <numbers>

#include "sim/core/error.h"
#include "sim/world/conditions/material_point.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

auto find_held(auto& loads) {
  return std::ranges::find_if(loads, [](const PlacedLoad& placed) { return placed.spring.has_value(); });
}

void require_finite(const Vec3& target) {
  if (!target.allFinite()) throw InputError("grab", "has a target that is not finite", "use finite coordinates");
}

}  // namespace

PlacedLoad* present_grab(WorldState& world) {
  const auto placed = find_held(world.loads);
  return placed == world.loads.end() ? nullptr : &*placed;
}

SpringConstants spring_constants(const WorldState& world, const PlacedLoad& grab) {
  constexpr double kStandardGravity = 9.80665;  // [m/s²]
  constexpr double kMaxPhase = 0.3;             // of a period in a time step [rad]: 20 steps and more
  const GrabSpring& spring = grab.spring->constants;
  const double mass = body_at(world, *grab.point).motion.mass;
  const double frequency =
      std::min(2 * std::numbers::pi * spring.frequency, kMaxPhase / world.model->scene.simulation.time_step);
  return {mass * frequency * frequency, 2 * spring.damping_ratio * mass * frequency,
          spring.strength * mass * kStandardGravity};
}

void begin_grab(WorldState& world, const Grab& grab) {
  const MaterialPoint point = place_point(world, "grab", grab.tet, grab.weights);
  require_finite(grab.target);
  end_grab(world);
  wake_at(world, point);
  PlacedLoad placed{{}, {}, {}, {}, {}, {}};
  placed.load.kind = LoadKind::point_force;
  placed.load.force = Vec3::Zero();
  placed.load.start = world.time;
  placed.point = point;
  placed.spring =
      HeldSpring{grab.target, grab.spring, position_of(world, point), velocity_of(world, point), world.time};
  world.loads.push_back(std::move(placed));
}

void move_grab(WorldState& world, const Vec3& target) {
  PlacedLoad* placed = present_grab(world);
  if (!placed) throw InputError("grab", "cannot move: nothing is grabbed", "grab a piece first");
  require_finite(target);
  placed->spring->target = target;
}

void end_grab(WorldState& world) {
  const auto placed = find_held(world.loads);
  if (placed != world.loads.end()) world.loads.erase(placed);
}

std::optional<GrabView> grab_view(const WorldState& world) {
  const auto placed = find_held(world.loads);
  if (placed == world.loads.end()) return std::nullopt;
  return GrabView{body_at(world, *placed->point).id, position_of(world, *placed->point), placed->spring->target,
                  placed->load.force, spring_constants(world, *placed).max_force};
}

}  // namespace griffith
