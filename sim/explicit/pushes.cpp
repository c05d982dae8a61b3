#include <algorithm>
#include <cmath>

#include "sim/explicit/microstep_contacts.h"

namespace griffith::explicit_dynamics {
namespace {

/// Slower approaches are rounding errors [m/s].
constexpr double kNegligibleSpeed = 1e-9;

Vec3 force_on(const ExplicitBodies& bodies, int node) {
  return bodies.acceleration(node) / bodies.node(node).inverse_mass;
}

}  // namespace

Vec3 MicrostepContacts::approach_of(const ExplicitBodies& bodies, const Touch& touch) const {
  Vec3 velocity = touch.obstacle >= 0 ? obstacles_[touch.obstacle].velocity_at(touch.place) : Vec3(Vec3::Zero());
  for (int i = 0; i < touch.other_count; ++i)
    velocity += touch.other_weights[i] * bodies.velocity(touch.other_nodes[i]);
  for (int i = 0; i < touch.count; ++i) velocity -= touch.weights[i] * bodies.velocity(touch.nodes[i]);
  return velocity;
}

double MicrostepContacts::mobility_of(const ExplicitBodies& bodies, const Touch& touch, const Vec3& direction) const {
  double sum = touch.obstacle >= 0 ? obstacles_[touch.obstacle].mobility(touch.place, direction) : 0;
  for (int i = 0; i < touch.other_count; ++i)
    sum += touch.other_weights[i] * touch.other_weights[i] * bodies.mobility(touch.other_nodes[i], direction);
  for (int i = 0; i < touch.count; ++i)
    sum += touch.weights[i] * touch.weights[i] * bodies.mobility(touch.nodes[i], direction);
  return sum;
}

double MicrostepContacts::friction_of(const ExplicitBodies& bodies, const Touch& touch) const {
  const double own = touch.count > 0 ? surface_at(bodies, touch.nodes[0]).friction : ground().friction;
  const double other =
      touch.obstacle >= 0 ? obstacles_[touch.obstacle].friction : surface_at(bodies, touch.other_nodes[0]).friction;
  return std::sqrt(own * other);
}

void MicrostepContacts::act(ExplicitBodies& bodies, const Touch& touch, const Vec3& impulse) {
  for (int i = 0; i < touch.count; ++i) push_node(bodies, touch.nodes[i], touch.weights[i] * impulse);
  for (int i = 0; i < touch.other_count; ++i)
    push_node(bodies, touch.other_nodes[i], -touch.other_weights[i] * impulse);
  if (touch.obstacle >= 0) obstacles_[touch.obstacle].push(touch.place, -impulse);
}

void MicrostepContacts::take_back(ExplicitBodies& bodies, const Touch& touch, const Vec3& impulse, double time) {
  const auto shift = [&](int node, const Vec3& part) {
    if (!part.isZero(0)) shift_node(bodies, node, bodies.displacement_by(node, part, time));
  };
  for (int i = 0; i < touch.count; ++i) shift(touch.nodes[i], touch.weights[i] * impulse);
  for (int i = 0; i < touch.other_count; ++i) shift(touch.other_nodes[i], -touch.other_weights[i] * impulse);
  if (touch.obstacle >= 0) obstacles_[touch.obstacle].shift(touch.place, -impulse, time);
}

/// Returns by how much the friction of a touch changes [N·s]: it stops the sliding as far as the normal impulse allows.
Vec3 MicrostepContacts::change_of_friction(const ExplicitBodies& bodies, const Touch& touch, const Vec3& velocity,
                                           double pressure) const {
  const Vec3 sliding = velocity - velocity.dot(touch.normal) * touch.normal;
  const double slip = sliding.norm(), limit = friction_of(bodies, touch) * pressure;
  Vec3 friction = touch.friction;
  if (slip > kNegligibleSpeed) friction += sliding / mobility_of(bodies, touch, sliding / slip);
  const double size = friction.norm();
  if (size > limit) friction *= limit / size;
  return friction - touch.friction;
}

/// Stops the approach and reverts the overlap, as far as the last motion at that speed caused it. Otherwise forces that
/// press two surfaces together would let them creep into each other step by step, and waves lose their energy. What
/// other touches of the microstep have made too large is taken back: nodes pressed into a corner would gain energy.
bool MicrostepContacts::push(ExplicitBodies& bodies, Touch& touch, double dt) {
  const Vec3 velocity = approach_of(bodies, touch);
  const double speed = -velocity.dot(touch.normal);
  if (touch.pressure == 0 && speed <= kNegligibleSpeed) return false;
  const double mobility = mobility_of(bodies, touch, touch.normal);
  if (mobility == 0) return false;
  const double change = std::max(speed / mobility, -touch.pressure);
  const Vec3 friction = change_of_friction(bodies, touch, velocity, touch.pressure + change);
  if (std::max(std::abs(speed), friction.norm() * mobility) <= kNegligibleSpeed) return false;
  const double time = speed > 0 ? std::clamp(touch.depth / speed, 0.0, dt) : touch.reverted / touch.pressure;
  const double fraction = act_within_energy(bodies, touch, friction - change * touch.normal, velocity, time);
  touch.pressure += fraction * change;
  touch.friction += fraction * friction;
  touch.reverted += fraction * time * change;
  touch.deepest = std::max(touch.deepest, touch.depth);
  touch.depth -= time * speed;
  touch.approach = std::max(touch.approach, speed);
  return true;
}

/// Applies an impulse, or the fraction of it that takes the most energy where all of it would give some: friction and
/// the lever arms of light objects may turn it into a gain. Returns that fraction.
double MicrostepContacts::act_within_energy(ExplicitBodies& bodies, const Touch& touch, const Vec3& impulse,
                                            const Vec3& velocity, double time) {
  act(bodies, touch, impulse);
  Vec3 after = approach_of(bodies, touch);
  double fraction = 1;
  if (impulse.dot(velocity) > 0 && impulse.dot(velocity + after) < 0) {
    fraction = impulse.dot(velocity) / impulse.dot(velocity - after);
    act(bodies, touch, (fraction - 1) * impulse);
    after = velocity + fraction * (after - velocity);
  }
  lost_ += 0.5 * fraction * impulse.dot(velocity + after);
  take_back(bodies, touch, fraction * impulse, time);
  return fraction;
}

void MicrostepContacts::record_impacts(double min_speed) {
  for (const Touch& touch : touches_)
    if (touch.approach > min_speed && touch.pressure > 0)
      recorded_impacts_.push_back({touch.nodes[0], touch.obstacle, touch.place, touch.normal,
                                   touch.friction - touch.pressure * touch.normal, touch.approach, touch.deepest});
}

MicrostepContacts::Pushed& MicrostepContacts::pushed(const ExplicitBodies& bodies, int node) {
  if (pushed_at_.size() < static_cast<std::size_t>(bodies.node_count())) pushed_at_.resize(bodies.node_count(), -1);
  if (pushed_at_[node] < 0) {
    pushed_at_[node] = static_cast<int>(pushed_.size());
    pushed_.push_back({node});
  }
  return pushed_[pushed_at_[node]];
}

void MicrostepContacts::push_node(ExplicitBodies& bodies, int node, const Vec3& impulse) {
  const Vec3 before = bodies.velocity(node);
  bodies.push(node, impulse);
  pushed(bodies, node).change += bodies.velocity(node) - before;
}

void MicrostepContacts::shift_node(ExplicitBodies& bodies, int node, const Vec3& displacement) {
  bodies.shift(node, displacement);
  pushed(bodies, node).displacement += displacement;
}

/// The forces of a microstep do work at the mean of the velocities before and after them. Their work over the actual
/// motion of a node is that, less their work over the difference between velocity and motion: half of the velocity
/// changes by impulses after the last motion, and half of the reverted part of the next.
void MicrostepContacts::record_pushed(const ExplicitBodies& bodies) {
  for (const Pushed& pushed : pushed_)
    if (!pushed.displacement.isZero(0)) lost_ += 0.5 * force_on(bodies, pushed.node).dot(pushed.displacement);
}

void MicrostepContacts::settle_pushed(const ExplicitBodies& bodies, double dt) {
  for (const Pushed& pushed : pushed_) {
    const Vec3 beside = dt * pushed.change - pushed.displacement;
    if (!beside.isZero(0)) lost_ -= 0.5 * force_on(bodies, pushed.node).dot(beside);
    pushed_at_[pushed.node] = -1;
  }
  pushed_.clear();
}

double MicrostepContacts::lost(const ExplicitBodies& bodies, double dt) {
  settle_pushed(bodies, dt);
  return lost_;
}

}  // namespace griffith::explicit_dynamics
