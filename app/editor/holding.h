#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/monitor.h"
#include "sim/timeline/timeline.h"

namespace griffith::app {

/// Time that a node must hold in a repeated run [s], and largest factor of speed and thickness tried.
inline constexpr double kTimeToHold = 0.1, kLargestFactor = 8;

/// Critical factor found by trial.
struct CriticalFactor {
  double breaks = 1, holds = 1;  ///< tested factors: fails at the first, holds at the second
  bool breaks_at_one = true;     ///< else the crack depends on more than the changed quantity
  bool found = false;            ///< else it fails up to the largest factor
  int runs = 0;
};

/// Returns the least factor of at least 1, to within 1 %, from which `holds` is true, by doubling and bisection up to
/// `largest`. If it is not monotone, one of the transitions is found.
CriticalFactor critical_factor(const std::function<bool(double)>& holds, double largest = 1024);

/// Cracks of a step.
struct StepCracks {
  std::optional<double> utilization;  ///< utilization of the first crack at a node; none: it held
  int before = 0;                     ///< cracks that opened before that one
  int all = 0;
};

/// Repeats the next step of `before` with a body `factor` times as strong, and returns its cracks, with that at a node.
/// Throws Cancelled.
StepCracks cracks_of_step(World before, int scene_body, NodeId node, double factor, const Monitor& monitor = {});

/// Returns the factor on the strength (tensile strength, toughness and other resistances) of a scene body from which no
/// crack opens at a node in the next step of `before`, by repeating that step. Throws Cancelled.
CriticalFactor critical_strength_factor(const World& before, int scene_body, NodeId node, const Monitor& monitor = {});

/// Returns a material whose tensile strength, toughness and other resistances are `factor` times as high.
Material stronger(Material material, double factor);

/// A run up to the step in which a node cracks, to be repeated from its start with a change.
struct RunToCrack {
  Scene scene;
  std::vector<WorldInput> inputs;  ///< inputs before that step, in order
  std::int64_t steps = 0;          ///< complete steps before it
  NodeId node;                     ///< numbered as before that step
  int scene_body = 0;              ///< scene body of the node
  Vec3 place = Vec3::Zero();       ///< position of the node in the undeformed body [m]
  Material material;               ///< material of the body in force before that step
};

/// Returns the run that led to the state of a timeline just before a node cracks.
RunToCrack run_to_crack(const Timeline& timeline, NodeId node);

/// Returns all shots of the run: those of the scene, then those of the user.
std::vector<ProjectileBurst> shots_of(const RunToCrack& run);
/// True if bodies have an initial velocity.
bool bodies_fly(const RunToCrack& run);

/// Returns the run with all projectiles and initial velocities slowed by `factor`, and longer by the same factor.
RunToCrack slowed(RunToCrack run, double factor);
/// Returns the run with the node's body `factor` times as thick, see thickened().
RunToCrack thickened(RunToCrack run, double factor);

/// True if no crack opens at the place until a tenth of a second after the step to which the run leads. Throws
/// InputError if the scene cannot be built, Cancelled.
bool node_holds(const RunToCrack& run, const Monitor& monitor = {});

/// Returns the factor, up to 8, by which everything must be slower for the node to hold. Empty if nothing moves at the
/// start.
std::optional<CriticalFactor> critical_speed_factor(const RunToCrack& run, const Monitor& monitor = {});
/// Returns the factor, up to 8, by which the body must be thicker for the node to hold. Empty if its shape has no
/// thickness. Throws InputError if it would penetrate another body.
std::optional<CriticalFactor> critical_thickness_factor(const RunToCrack& run, const Monitor& monitor = {});

}  // namespace griffith::app
