// The part of ExplicitRun that shows the world between microsteps.
#include <utility>

#include "sim/core/rotation.h"
#include "sim/world/explicit/explicit_obstacles.h"
#include "sim/world/explicit/explicit_run.h"
#include "sim/world/fracture/separation_phase.h"
#include "sim/world/output/publish.h"

namespace griffith {
namespace {

/// Returns a state after free motion for a time, which may be negative [s].
RigidState moved(RigidState state, double time) {
  state.pose.translation += time * state.velocity;
  state.pose.rotation = (Quat(rotation_by(time * state.angular_velocity)) * state.pose.rotation).normalized();
  return state;
}

}  // namespace

/// Offers the present microstep to the observer. After remeshing the bodies are in no consistent state until the next
/// one.
void ExplicitRun::show_moment() {
  MicrostepWatch& watch = *world_.watch;
  if (!watch.wants_next() || rebuild_) return;
  watch.take(watch.microsteps, moment());
}

/// Returns the world as it would be if the run ended now, with all objects at the present time.
WorldState ExplicitRun::moment() const {
  WorldState moment = world_;
  moment.watch = nullptr;
  moment.time = time_;
  carry_others(moment);
  for (explicit_dynamics::Obstacle obstacle : contacts_->obstacles()) {
    obstacle.move(0);
    place_obstacle(moment, obstacle);
  }
  finish(moment, opened_, time_ - start_);
  for (const Body& body : moment.bodies)
    if (is_followed(body)) evaluate_separation(moment, body);
  publish(moment);
  for (Body& body : moment.bodies) body.system.reset();  // the largest part of the memory, which frames do not need
  return moment;
}

/// Moves the objects that the run does not move to the present time, as if nothing touched them since.
void ExplicitRun::carry_others(WorldState& moment) const {
  const double time = time_ - others_at_;
  for (Body& body : moment.bodies) {
    if (body.explicit_state || body.asleep || body.supported()) continue;
    const RigidMotion& motion = body.motion;
    place_body(moment, body,
               moved({{motion.center, body.orientation}, motion.velocity, motion.angular_velocity}, time));
  }
  for (const Projectile& projectile : moment.projectiles)
    moment.contact_world.set_state(projectile.object, moved(moment.contact_world.state(projectile.object), time));
}

}  // namespace griffith
