#include "sim/contact/impulse_solver.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace griffith::contact {
namespace {

/// What a sweep needs of a row again and again.
struct PreparedRow {
  Mat3 compliance;                     ///< of both ends along the axes [1/kg]
  Eigen::Matrix2d inverse_tangential;  ///< of its tangential block
  double largest_tangential;           ///< eigenvalue of that block
};

Vec3 velocity_at(const Responder& responder, const ContactEnd& end) {
  if (responder.compliance) return responder.point_velocities.col(end.point);
  return responder.velocity + responder.angular_velocity.cross(end.arm);
}

void push(Responder& responder, const ContactEnd& end, const Vec3& impulse) {
  if (responder.compliance) {
    responder.point_velocities.reshaped().noalias() +=
        responder.compliance->middleCols<3>(3 * end.point) * impulse;
  } else if (responder.inverse_mass > 0) {
    responder.velocity += responder.inverse_mass * impulse;
    responder.angular_velocity += responder.inverse_inertia * end.arm.cross(impulse);
  }
}

Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Mat3 compliance_of(const Responder& responder, const ContactEnd& end) {
  if (responder.compliance) return responder.compliance->block<3, 3>(3 * end.point, 3 * end.point);
  const Mat3 arm = cross_matrix(end.arm);
  return responder.inverse_mass * Mat3::Identity() - arm * responder.inverse_inertia * arm;
}

PreparedRow prepare(const ContactRow& row, std::span<const Responder> responders) {
  PreparedRow prepared;
  const Mat3 compliance = compliance_of(responders[row.a.responder], row.a) + compliance_of(responders[row.b.responder], row.b);
  prepared.compliance = row.axes.transpose() * compliance * row.axes;
  const Eigen::Matrix2d tangential = prepared.compliance.bottomRightCorner<2, 2>();
  const double mean = tangential.trace() / 2;
  prepared.largest_tangential = mean + std::sqrt(std::max(0.0, mean * mean - tangential.determinant()));
  prepared.inverse_tangential.setZero();
  if (tangential.determinant() > 0) prepared.inverse_tangential = tangential.inverse();
  return prepared;
}

void apply(const ContactRow& row, const Vec3& impulse, std::span<Responder> responders) {
  const Vec3 world = row.axes * impulse;
  push(responders[row.a.responder], row.a, world);
  push(responders[row.b.responder], row.b, -world);
}

/// What stops the sliding, where the limit allows it; else as much as it allows, against the sliding.
Vec2 friction_impulse(const Vec2& impulse, const Vec2& sliding, double limit, const PreparedRow& prepared) {
  const Vec2 stopping = impulse - prepared.inverse_tangential * sliding;
  if (stopping.squaredNorm() <= limit * limit) return stopping;
  const Vec2 opposing = impulse - sliding / prepared.largest_tangential;
  const double length = opposing.norm();
  return length > limit ? Vec2(limit / length * opposing) : opposing;
}

/// Solves one row among the others' present impulses; returns the change of velocity that this made.
double relax(ContactRow& row, const PreparedRow& prepared, std::span<Responder> responders) {
  const double stiffness = prepared.compliance(0, 0);
  if (!(stiffness > 0)) return 0;
  const Vec3 velocity = row.axes.transpose() * (velocity_at(responders[row.a.responder], row.a) -
                                                velocity_at(responders[row.b.responder], row.b));
  Vec3 next = row.impulse;
  next[0] = std::max(0.0, row.impulse[0] - (velocity[0] - row.least_speed) / stiffness);
  if (row.friction > 0) {
    const Vec2 sliding = velocity.tail<2>() + (next[0] - row.impulse[0]) * prepared.compliance.block<2, 1>(1, 0);
    next.tail<2>() = friction_impulse(row.impulse.tail<2>(), sliding, row.friction * next[0], prepared);
  }
  const Vec3 change = next - row.impulse;
  if (change.isZero(0)) return 0;
  row.impulse = next;
  apply(row, change, responders);
  return (prepared.compliance * change).norm();
}

}  // namespace

void solve_impulses(std::span<ContactRow> rows, std::span<Responder> responders, const SolverLimits& limits) {
  std::vector<PreparedRow> prepared;
  prepared.reserve(rows.size());
  double speed = 0;
  for (const ContactRow& row : rows) {
    prepared.push_back(prepare(row, responders));
    speed = std::max(speed, row.least_speed - row.axes.col(0).dot(velocity_at(responders[row.a.responder], row.a) -
                                                                   velocity_at(responders[row.b.responder], row.b)));
  }
  for (const ContactRow& row : rows)
    if (!row.impulse.isZero(0)) apply(row, row.impulse, responders);
  const std::size_t count = rows.size();
  for (int sweep = 0; sweep < limits.iterations; ++sweep) {
    double change = 0;
    // Up and down in turn: what a stack carries goes through it both ways.
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = sweep % 2 == 0 ? k : count - 1 - k;
      change = std::max(change, relax(rows[i], prepared[i], responders));
    }
    if (change <= limits.tolerance * speed) return;
  }
}

}  // namespace griffith::contact
