#include "sim/solver/contact_motion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/rotation.h"
#include "sim/solver/conjugate_gradient.h"
#include "sim/solver/rigid_motion.h"

namespace griffith {
namespace {

/// Writes A v, the whole of a body resisting by its mass alone.
void multiply_body(const DeformableInertia& body, const NodeVectors& v, NodeVectors& product) {
  if (!body.matrix) return void(product = v * body.masses.asDiagonal());
  if (!body.whole.exists()) return multiply(*body.matrix, v, product);
  const NodeVectors whole = body.whole.part_of(v);
  multiply(*body.matrix, v - whole, product);
  product -= body.whole.momentum_of(product);
  const Eigen::Index nodes = body.whole.masses.size();
  product.leftCols(nodes) += whole.leftCols(nodes) * (body.whole.damping * body.whole.masses).asDiagonal();
}

}  // namespace

ContactBodies::ContactBodies(std::span<const DeformableInertia> deformable, std::span<const RigidInertia> rigid,
                             Condensed condensed)
    : deformable_(deformable), rigid_(rigid), condensed_(std::move(condensed)) {
  for (std::size_t i = 0; i < deformable.size(); ++i) {
    offsets_.push_back(size_);
    size_ += condensed_[i] ? condensed_[i]->size() : 3 * deformable[i].rows();
  }
  first_rigid_ = size_;
  size_ += 6 * static_cast<int>(rigid.size());
}

NodeVectors ContactBodies::change(std::size_t body, const Eigen::VectorXd& v) const {
  return v.segment(offsets_[body], 3 * deformable_[body].rows()).reshaped(3, deformable_[body].rows());
}

double ContactBodies::speed_under(const Eigen::VectorXd& impulses) const {
  double largest = 0;
  for (std::size_t i = 0; i < deformable_.size(); ++i)
    largest = std::max(largest, squared_speed_of_deformable(i, impulses));
  for (std::size_t i = 0; i < rigid_.size(); ++i) largest = std::max(largest, squared_speed_of_rigid(i, impulses));
  return std::sqrt(largest);
}

double ContactBodies::squared_speed_of_deformable(std::size_t i, const Eigen::VectorXd& impulses) const {
  if (condensed_[i]) return condensed_[i]->squared_speed_under(impulses.segment(offsets_[i], condensed_[i]->size()));
  const DeformableInertia& body = deformable_[i];
  double largest = 0;
  NodeVectors of_body = change(i, impulses), z;
  if (body.matrix && body.whole.exists()) {
    const NodeVectors whole = body.whole.momentum_of(of_body);
    for (Eigen::Index row = 0; row < body.whole.masses.size(); ++row)
      largest = std::max(largest, whole.col(row).squaredNorm() / (body.whole.masses[row] * body.whole.masses[row]));
    of_body -= whole;
  }
  if (body.matrix) {
    Preconditioning(*body.preconditioner, body.factors).apply(of_body, z);
  } else {
    z = of_body * body.masses.cwiseInverse().asDiagonal();
  }
  return z.cols() > 0 ? std::max(largest, z.colwise().squaredNorm().maxCoeff()) : largest;
}

double ContactBodies::squared_speed_of_rigid(std::size_t i, const Eigen::VectorXd& impulses) const {
  const auto of_body = impulses.segment<6>(first_rigid_ + 6 * static_cast<Eigen::Index>(i));
  const Vec3 turning = of_body.tail<3>();
  const RigidInertia& body = rigid_[i];
  return of_body.head<3>().squaredNorm() / (body.mass * body.mass) +
         turning.dot(body.inertia.inverse() * turning) / body.mass;
}

void ContactBodies::multiply(const Eigen::VectorXd& v, Eigen::VectorXd& product) const {
  product.resize(size_);
  NodeVectors of_body;
  for (std::size_t i = 0; i < deformable_.size(); ++i) {
    if (condensed_[i]) {
      const int size = condensed_[i]->size();
      product.segment(offsets_[i], size) = condensed_[i]->multiply(v.segment(offsets_[i], size));
      continue;
    }
    auto segment = product.segment(offsets_[i], 3 * deformable_[i].rows());
    multiply_body(deformable_[i], change(i, v), of_body);
    segment = of_body.reshaped();
  }
  for (std::size_t i = 0; i < rigid_.size(); ++i) {
    const Eigen::Index first = first_rigid_ + 6 * static_cast<Eigen::Index>(i);
    product.segment<3>(first) = rigid_[i].mass * v.segment<3>(first);
    product.segment<3>(first + 3) = rigid_[i].inertia * v.segment<3>(first + 3);
  }
}

ContactMotion::ContactMotion(const ContactBodies& bodies, std::span<const DeformableInertia> deformable,
                             std::span<const FrictionContact> contacts)
    : deformable_(deformable), levers_of_(deformable.size()) {
  for (const FrictionContact& contact : contacts) {
    add_side(bodies, contact.a, contact.axes.transpose());
    add_side(bodies, contact.b, -contact.axes.transpose());
    local_.finish_contact();
  }
}

Eigen::Matrix3Xd ContactMotion::of(const Eigen::VectorXd& v) const {
  Eigen::Matrix3Xd relative = local_.multiply(v);
  std::vector<Vec3> spins(levers_of_.size(), Vec3::Zero());
  for (std::size_t body = 0; body < spins.size(); ++body)
    if (!levers_of_[body].empty()) spins[body] = spin_of(levers_[levers_of_[body].front()], v);
  for (const Lever& lever : levers_) relative.col(lever.contact) += lever.arm * spins[lever.body];
  return relative;
}

void ContactMotion::add_impulses(const Eigen::Matrix3Xd& p, Eigen::VectorXd& v) const {
  local_.add_transposed(p, v);
  for (const std::vector<int>& levers : levers_of_)
    if (!levers.empty()) add_torques(levers, p, v);
}

void ContactMotion::add_side(const ContactBodies& bodies, const ContactSide& side, const Mat3& axes) {
  if (side.body < 0) return;
  const int offset = bodies.offset(side);
  if (!side.deformable) return local_.add(offset, axes * rigid_modes(side.arm));
  if (const TouchedInverse* condensed = bodies.condensed(side.body))
    return condensed->add_side(side, axes, offset, local_);
  for (int i = 0; i < 3; ++i)
    if (const int row = side.point.rows[i]; row >= 0) local_.add(offset + 3 * row, axes * side.point.weights[i]);
  if (side.offset.isZero(0)) return;
  levers_of_[side.body].push_back(static_cast<int>(levers_.size()));
  levers_.push_back({local_.contacts(), side.body, offset, -axes * cross_matrix(side.offset)});
}

Vec3 ContactMotion::spin_of(const Lever& lever, const Eigen::VectorXd& v) const {
  const WholeMotion& whole = deformable_[lever.body].whole;
  return whole.spin_of(v.segment(lever.offset, whole.arms.size()).reshaped(3, whole.arms.cols()));
}

void ContactMotion::add_torques(std::span<const int> levers, const Eigen::Matrix3Xd& p, Eigen::VectorXd& v) const {
  const Lever& first = levers_[levers.front()];
  const WholeMotion& whole = deformable_[first.body].whole;
  std::vector<Vec3> spins;
  for (const int lever : levers)
    spins.push_back(whole.inverse_inertia * Vec3(levers_[lever].arm.transpose() * p.col(levers_[lever].contact)));
  for (Eigen::Index row = 0; row < whole.masses.size(); ++row) {
    const Vec3 arm = whole.arms.col(row);
    Vec3 impulse = v.segment<3>(first.offset + 3 * row);
    for (const Vec3& spin : spins) impulse += whole.masses[row] * spin.cross(arm);
    v.segment<3>(first.offset + 3 * row) = impulse;
  }
}

}  // namespace griffith
