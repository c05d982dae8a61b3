#include <algorithm>
#include <cmath>

#include "sim/explicit/microstep_contacts.h"

namespace griffith::explicit_dynamics {

/// Lists the points of movable obstacles that may reach the ground before the candidates are listed again. The bottom
/// of a sphere is found when it is needed.
void MicrostepContacts::list_grounded() {
  grounded_.clear();
  const auto ground = std::ranges::find_if(obstacles_, &Obstacle::is_ground);
  if (ground == obstacles_.end()) return;
  for (int i = 0; i < static_cast<int>(obstacles_.size()); ++i) {
    const Obstacle& obstacle = obstacles_[i];
    if (obstacle.inverse_mass == 0 || candidates_[i].empty()) continue;
    if (ground->gap_of(obstacle.state.pose.translation) > obstacle.radius + margin_) continue;
    if (obstacle.is_sphere()) grounded_.push_back({i, Vec3::Zero()});
    for (const ConvexSolid& part : obstacle.solids)
      for (const Vec3& sample : part.samples)
        if (ground->gap_of(obstacle.state.pose.to_world(sample)) < margin_) grounded_.push_back({i, sample});
  }
}

/// Stops obstacles that the bodies push into the ground: a piece that lies on it carries what strikes it from above.
/// Returns true if any was stopped.
bool MicrostepContacts::stop_at_ground(double dt) {
  const auto ground = std::ranges::find_if(obstacles_, &Obstacle::is_ground);
  bool any = false;
  for (const GroundedPoint& point : grounded_) {
    Obstacle& obstacle = obstacles_[point.obstacle];
    const Vec3 normal = ground->solids.front().faces.front().normal;
    const Vec3 place = obstacle.is_sphere() ? Vec3(obstacle.state.pose.translation - obstacle.radius * normal)
                                            : obstacle.state.pose.to_world(point.sample);
    const double depth = -ground->gap_of(place);
    if (depth > 0) any |= stop(obstacle, place, normal, depth, std::sqrt(obstacle.friction * ground->friction), dt);
  }
  return any;
}

/// Stops the approach of a point of an obstacle to what does not move, and reverts the overlap as far as the last
/// motion at that speed caused it. False if it does not approach.
bool MicrostepContacts::stop(Obstacle& obstacle, const Vec3& place, const Vec3& normal, double depth, double friction,
                             double dt) {
  const Vec3 velocity = obstacle.velocity_at(place);
  const double speed = -velocity.dot(normal);
  if (speed <= kNegligibleSpeed) return false;
  const double pressing = speed / obstacle.mobility(place, normal);
  Vec3 impulse = pressing * normal;
  const Vec3 sliding = velocity + speed * normal;
  if (const double slip = sliding.norm(); slip > 0)
    impulse -= std::min(friction * pressing, slip / obstacle.mobility(place, sliding / slip)) / slip * sliding;
  obstacle.push(place, impulse);
  const Vec3 after = obstacle.velocity_at(place);
  if (const double work = 0.5 * impulse.dot(velocity + after); work > 0) {  // by the lever arm of friction
    const double share = impulse.dot(velocity) / impulse.dot(velocity - after);
    obstacle.push(place, (share - 1) * impulse);
    impulse *= share;
  }
  lost_ -= 0.5 * impulse.dot(velocity + obstacle.velocity_at(place));
  obstacle.shift(place, impulse, std::min(dt, depth / speed));
  return true;
}

}  // namespace griffith::explicit_dynamics
