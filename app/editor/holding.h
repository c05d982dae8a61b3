#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/monitor.h"
#include "sim/timeline/timeline.h"

namespace griffith::app {

/// For how long a node must stand when a run is made again [s], and up to what factor speeds and thicknesses are tried.
inline constexpr double kTimeToStand = 0.1, kLargestFactor = 8;

/// What a factor has to be for something to hold, found by trying.
struct HoldingFactor {
  double breaks = 1, holds = 1;  ///< tried: at the first it does not hold, at the second it does
  bool breaks_at_one = true;     ///< else the crack depends on more than what was changed
  bool found = false;            ///< else nothing up to the largest factor holds
  int runs = 0;
};

/// The least factor of at least 1, to within 1 %, from which `holds` is true, by doubling and halving intervals; up to
/// `largest`. Where it is true now and then, one of the borders is found.
HoldingFactor holding_factor(const std::function<bool(double)>& holds, double largest = 1024);

/// How much stronger (tensile strength, toughness and what else resists) the material of a scene body would have to be
/// for no crack to open at a node in the next step of `before`; found by making the step again and again. Throws
/// Cancelled.
HoldingFactor strength_that_holds(const World& before, int scene_body, NodeId node, const Monitor& monitor = {});

/// A run up to the step in which a node of a body cracks, to be made again from its start with something changed.
struct RunToCrack {
  Scene scene;
  std::vector<WorldInput> inputs;  ///< done before that step, in their order
  std::int64_t steps = 0;          ///< whole ones before it
  NodeId node;                     ///< before that step
  int scene_body = 0;              ///< it belongs to
  Vec3 place = Vec3::Zero();       ///< of it, in the undeformed body [m]
  Material material;               ///< of the body, in force before that step
};

/// The run that led to where a timeline is, just before a node cracks.
RunToCrack run_to_crack(const Timeline& timeline, NodeId node);

/// All that is fired in the run: by the scene, then by hand.
std::vector<ProjectileBurst> shots_of(const RunToCrack& run);
/// Whether bodies have a velocity at the start.
bool bodies_fly(const RunToCrack& run);

/// The run with all that flies from its start on, shots and bodies, `factor` times as slow, and as much longer.
RunToCrack slowed(RunToCrack run, double factor);
/// The run with the body of the node `factor` times as thick, as thickened() has it.
RunToCrack thickened(RunToCrack run, double factor);

/// Whether no crack opens at the place up to a tenth of a second after the step that the run leads to. Throws
/// InputError where the scene cannot be built, Cancelled.
bool stands(const RunToCrack& run, const Monitor& monitor = {});

/// How much slower all that flies would have to be for the node to stand, up to 8 times. None where nothing flies.
std::optional<HoldingFactor> slowness_that_holds(const RunToCrack& run, const Monitor& monitor = {});
/// How much thicker its body would have to be, up to 8 times. None where its shape has no thickness. Throws InputError
/// where it would grow into another body.
std::optional<HoldingFactor> thickness_that_holds(const RunToCrack& run, const Monitor& monitor = {});

}  // namespace griffith::app
