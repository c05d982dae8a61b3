#include <utility>

#include "sim/shock/impacts.h"

namespace griffith::shock {

void Impacts::push_node(Solid& solid, int node, const Vec3& impulse) {
  solid.push(node, impulse);
  if (pushed_at_.size() < static_cast<std::size_t>(solid.node_count())) pushed_at_.resize(solid.node_count(), -1);
  if (pushed_at_[node] < 0) {
    pushed_at_[node] = static_cast<int>(pushed_.size());
    pushed_.push_back({node});
  }
  pushed_[pushed_at_[node]].impulse += impulse;
}

void Impacts::note_pushed(const Solid& solid) {
  for (Pushed& pushed : pushed_) pushed.velocity = solid.velocity(pushed.node);
}

/// A push and the forces after it move a node together: it works at the mean of the velocities before and after both.
void Impacts::settle_pushed(const Solid& solid) {
  for (const Pushed& pushed : pushed_) {
    lost_ -= 0.5 * pushed.impulse.dot(solid.velocity(pushed.node) - pushed.velocity);
    pushed_at_[pushed.node] = -1;
  }
  pushed_.clear();
}

double Impacts::take_lost(const Solid& solid, double dt) {
  for (const Pushed& pushed : pushed_) {
    lost_ -= 0.5 * dt * pushed.impulse.dot(solid.acceleration(pushed.node));
    pushed_at_[pushed.node] = -1;
  }
  pushed_.clear();
  return std::exchange(lost_, 0);
}

}  // namespace griffith::shock
