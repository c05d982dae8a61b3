#include <algorithm>
#include <limits>

#include "sim/explicit/microstep_contacts.h"

namespace griffith::explicit_dynamics {

/// Returns the ground, which must be among the obstacles.
const Obstacle& MicrostepContacts::ground() const { return *std::ranges::find_if(obstacles_, &Obstacle::is_ground); }

/// Lists the points of movable obstacles that may reach the ground before the candidates are listed again. The bottom
/// of a sphere is found when it is needed.
void MicrostepContacts::list_grounded() {
  grounded_.clear();
  if (std::ranges::none_of(obstacles_, &Obstacle::is_ground)) return;
  const Obstacle& ground = this->ground();
  for (int i = 0; i < static_cast<int>(obstacles_.size()); ++i) {
    const Obstacle& obstacle = obstacles_[i];
    if (!obstacle.is_movable() || obstacle.is_soft || candidates_[i].empty()) continue;
    if (ground.gap_of(obstacle.state.pose.translation) > obstacle.radius + margin_) continue;
    if (obstacle.is_sphere()) grounded_.push_back({i, Vec3::Zero()});
    for (const ConvexSolid& part : obstacle.solids)
      for (const Vec3& sample : part.samples)
        if (ground.gap_of(obstacle.state.pose.to_world(sample)) < margin_) grounded_.push_back({i, sample});
  }
}

/// Begins a microstep in which nothing has been pushed into the ground.
void MicrostepContacts::touch_ground() {
  grounded_touches_.clear();
  if (grounded_.empty()) return;
  const Vec3 normal = ground().solids.front().faces.front().normal;
  for (const GroundedPoint& point : grounded_) {
    Touch& touch = grounded_touches_.emplace_back();
    touch.count = 0;  // no body
    touch.obstacle = point.obstacle;
    touch.normal = normal;
  }
}

/// Stops obstacles that the bodies push into the ground: a piece that lies on it carries what strikes it from above.
/// Returns true if any was stopped.
bool MicrostepContacts::stop_at_ground(ExplicitBodies& bodies, double dt) {
  if (grounded_.empty()) return false;
  const Obstacle& ground = this->ground();
  bool any = false;
  for (std::size_t i = 0; i < grounded_.size(); ++i) {
    const Obstacle& obstacle = obstacles_[grounded_[i].obstacle];
    Touch& touch = grounded_touches_[i];
    touch.place = obstacle.is_sphere() ? Vec3(obstacle.state.pose.translation - obstacle.radius * touch.normal)
                                       : obstacle.state.pose.to_world(grounded_[i].sample);
    touch.depth = -ground.gap_of(touch.place);
    if (touch.depth > 0 || touch.pressure > 0) any |= push(bodies, touch, dt);
  }
  return any;
}

}  // namespace griffith::explicit_dynamics
