#include "app/editor/holding.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/editor/thickness.h"
#include "app/shared/flip_search.h"
#include "sim/core/number_text.h"
#include "sim/world/setup/starting_overlaps.h"

namespace griffith::app {
namespace {

/// Makes a step and returns its cracks, with that at a place of a body. A change of thickness moves nodes by rounding
/// errors.
StepCracks step_to_cracks(World& world, int scene_body, const Vec3& place, const Monitor& monitor) {
  constexpr double kRounding = 1e-9;
  if (monitor.is_cancelled()) throw Cancelled();
  const std::size_t known = world.frame().crack_events.size();
  world.step();
  const std::span<const CrackEvent> events = world.frame().crack_events.subspan(known);
  StepCracks cracks;
  cracks.all = static_cast<int>(events.size());
  const Frame frame = world.frame();
  const auto here = std::ranges::find_if(events, [&](const CrackEvent& event) {
    return frame.bodies[event.body].scene_body == scene_body &&
           (event.rest_position - place).norm() <= kRounding * (1 + place.norm());
  });
  if (here == events.end()) return cracks;
  cracks.utilization = here->load / here->resistance;
  cracks.before = static_cast<int>(here - events.begin());
  return cracks;
}

bool steps_whole(World& world, int scene_body, const Vec3& place, const Monitor& monitor) {
  return !step_to_cracks(world, scene_body, place, monitor).utilization;
}

bool node_holds(World world, const RunToCrack& run, const Monitor& monitor) {
  std::vector<WorldInput> inputs = run.inputs;
  auto next = inputs.begin();
  const std::int64_t after = std::llround(kTimeToHold / run.scene.simulation.time_step);
  for (std::int64_t step = 0; step <= run.steps + after; ++step) {
    for (; next != inputs.end() && next->step <= step; ++next) apply(world, *next);
    if (!steps_whole(world, run.scene_body, run.place, monitor)) return false;
  }
  return true;
}

bool anything_flies(const RunToCrack& run) {
  return bodies_fly(run) ||
         std::ranges::any_of(shots_of(run), [](const ProjectileBurst& shot) { return shot.speed > 0; });
}

/// Builds the scene's world without a progress report.
World build(const Scene& scene, const Monitor& monitor) { return World(scene, Monitor{{}, monitor.cancelled}); }

std::size_t overlaps_in(const World& world) { return starting_overlaps(world.scene(), world.frame()).size(); }

}  // namespace

Material stronger(Material material, double factor) {
  material.tensile_strength *= factor;
  if (material.compressive_strength) *material.compressive_strength *= factor;
  material.fracture_toughness *= factor;
  material.separation_toughness *= factor;
  return material;
}

CriticalFactor critical_factor(const std::function<bool(double)>& holds, double largest) {
  const StateAt state = states_of(holds);
  std::vector<double> factors = {1};
  while (state({factors.back()})[0][0] == 0 && factors.back() < largest)
    factors.push_back(std::min(2 * factors.back(), largest));
  const std::map<double, State> tried = search_flips({.geometric = true}, factors, state);
  CriticalFactor found{.breaks = factors.back(), .holds = factors.back()};
  found.runs = static_cast<int>(tried.size());
  found.breaks_at_one = tried.at(1)[0] == 0;
  if (const std::vector<Bracket> flips = flips_among(tried); !flips.empty()) {
    found.found = true;
    found.breaks = flips.front().below, found.holds = flips.front().above;
  }
  return found;
}

StepCracks cracks_of_step(World before, int scene_body, NodeId node, double factor, const Monitor& monitor) {
  const Vec3 place = before.frame().nodes.rest_positions[node];
  before.set_material(scene_body, stronger(before.frame().materials[scene_body], factor));
  return step_to_cracks(before, scene_body, place, monitor);
}

CriticalFactor critical_strength_factor(const World& before, int scene_body, NodeId node, const Monitor& monitor) {
  return critical_factor([&](double factor) {
    monitor.enter(rounded_text(factor, 3) + " times the strength");
    return !cracks_of_step(before, scene_body, node, factor, monitor).utilization;
  });
}

RunToCrack run_to_crack(const Timeline& timeline, NodeId node) {
  const Frame frame = timeline.world().frame();
  const BodyId body = frame.elements.bodies[frame.nodes.stars[node].front()];
  const int scene_body = frame.bodies[body].scene_body;
  RunToCrack run{timeline.world().scene(),         timeline.inputs(),          timeline.step(), node, scene_body,
                 frame.nodes.rest_positions[node], frame.materials[scene_body]};
  std::erase_if(run.inputs, [&](const WorldInput& input) { return input.step > timeline.step(); });
  return run;
}

std::vector<ProjectileBurst> shots_of(const RunToCrack& run) {
  std::vector<ProjectileBurst> shots = run.scene.projectiles;
  for (const WorldInput& input : run.inputs)
    if (const auto* shot = std::get_if<ProjectileBurst>(&input.action)) shots.push_back(*shot);
  return shots;
}

bool bodies_fly(const RunToCrack& run) {
  return std::ranges::any_of(run.scene.bodies, [](const BodyDescription& body) {
    return !body.velocity.isZero(0) || !body.angular_velocity.isZero(0);
  });
}

RunToCrack slowed(RunToCrack run, double factor) {
  for (ProjectileBurst& burst : run.scene.projectiles) burst.speed /= factor;
  for (WorldInput& input : run.inputs)
    if (auto* burst = std::get_if<ProjectileBurst>(&input.action)) burst->speed /= factor;
  for (BodyDescription& body : run.scene.bodies) {
    body.velocity /= factor;
    body.angular_velocity /= factor;
  }
  run.steps = std::llround(std::ceil(static_cast<double>(run.steps) * factor));
  return run;
}

RunToCrack thickened(RunToCrack run, double factor) {
  BodyDescription& body = run.scene.bodies[run.scene_body];
  run.place = thickened_place(body, factor, run.scene.gravity, run.place);
  body = thickened(body, factor, run.scene.gravity);
  return run;
}

bool node_holds(const RunToCrack& run, const Monitor& monitor) {
  return node_holds(build(run.scene, monitor), run, monitor);
}

std::optional<CriticalFactor> critical_speed_factor(const RunToCrack& run, const Monitor& monitor) {
  if (!anything_flies(run)) return std::nullopt;
  return critical_factor(
      [&](double factor) {
        monitor.enter(rounded_text(1 / factor, 3) + " times the speed");
        return node_holds(slowed(run, factor), monitor);
      },
      kLargestFactor);
}

namespace {

/// Throws InputError if pieces were grabbed or pushed: their points are those of the present mesh.
void require_no_points(const RunToCrack& run) {
  for (const WorldInput& input : run.inputs) {
    const bool is_push = std::holds_alternative<Push>(input.action);
    if (is_push || std::holds_alternative<Grab>(input.action))
      throw InputError(is_push ? "the push" : "the grab", "acts on a point of the present mesh",
                       "repeat it by hand with a thicker body");
  }
}

}  // namespace

std::optional<CriticalFactor> critical_thickness_factor(const RunToCrack& run, const Monitor& monitor) {
  const BodyDescription& body = run.scene.bodies[run.scene_body];
  if (!thickness_of(body.shape)) return std::nullopt;
  require_no_points(run);
  const std::size_t overlaps = overlaps_in(build(run.scene, monitor));
  return critical_factor(
      [&](double factor) {
        monitor.enter(rounded_text(factor, 3) + " times the thickness");
        const RunToCrack thicker = thickened(run, factor);
        World world = build(thicker.scene, monitor);
        if (overlaps_in(world) > overlaps)
          throw InputError("body \"" + body.name + "\"", "would penetrate another body", "leave space next to it");
        return node_holds(std::move(world), thicker, monitor);
      },
      kLargestFactor);
}

}  // namespace griffith::app
