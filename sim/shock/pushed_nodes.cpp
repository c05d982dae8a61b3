#include "sim/shock/impacts.h"

namespace griffith::shock {
namespace {

Vec3 force_on(const Solid& solid, int node) { return solid.acceleration(node) / solid.node(node).inverse_mass; }

}  // namespace

Impacts::Pushed& Impacts::pushed(const Solid& solid, int node) {
  if (pushed_at_.size() < static_cast<std::size_t>(solid.node_count())) pushed_at_.resize(solid.node_count(), -1);
  if (pushed_at_[node] < 0) {
    pushed_at_[node] = static_cast<int>(pushed_.size());
    pushed_.push_back({node});
  }
  return pushed_[pushed_at_[node]];
}

void Impacts::push_node(Solid& solid, int node, const Vec3& impulse) {
  const Vec3 before = solid.velocity(node);
  solid.push(node, impulse);
  pushed(solid, node).change += solid.velocity(node) - before;
}

void Impacts::shift_node(Solid& solid, int node, const Vec3& displacement) {
  solid.shift(node, displacement);
  pushed(solid, node).displacement += displacement;
}

/// The forces of a microstep worked at the mean of the velocities before and after them. Their work over the way that a
/// node really went is that less their work over what its velocities say beyond its way: half of what pushes changed
/// after the last motion, and half of what was taken back of the next.
void Impacts::record_pushed(const Solid& solid) {
  for (const Pushed& pushed : pushed_)
    if (!pushed.displacement.isZero(0)) lost_ += 0.5 * force_on(solid, pushed.node).dot(pushed.displacement);
}

void Impacts::settle_pushed(const Solid& solid, double dt) {
  for (const Pushed& pushed : pushed_) {
    const Vec3 beside = dt * pushed.change - pushed.displacement;
    if (!beside.isZero(0)) lost_ -= 0.5 * force_on(solid, pushed.node).dot(beside);
    pushed_at_[pushed.node] = -1;
  }
  pushed_.clear();
}

double Impacts::lost(const Solid& solid, double dt) {
  settle_pushed(solid, dt);
  return lost_;
}

}  // namespace griffith::shock
