#include "sim/solver/contact_response.h"

#include <cmath>
#include <utility>

#include "sim/solver/conjugate_gradient.h"

namespace griffith {
namespace {

ContactBodies::Condensed none_condensed(std::size_t bodies) { return ContactBodies::Condensed(bodies); }

/// Changes of velocity by which the momentum of a whole moves it.
NodeVectors velocities_of(const WholeMotion& whole, NodeVectors momentum) {
  for (Eigen::Index i = 0; i < whole.masses.size(); ++i) momentum.col(i) /= whole.damping * whole.masses[i];
  return momentum;
}

}  // namespace

ContactResponse::ContactResponse(const ContactBodies& bodies, const ContactMotion& motion,
                                 std::span<const DeformableInertia> deformable, std::span<const RigidInertia> rigid,
                                 std::span<const FrictionContact> contacts)
    : bodies_(bodies),
      motion_(motion),
      deformable_(deformable),
      all_rows_(deformable, rigid, none_condensed(deformable.size())),
      motion_of_all_rows_(all_rows_, deformable, contacts),
      changes_(deformable.size()) {}

Eigen::Matrix3Xd ContactResponse::respond(const Eigen::Matrix3Xd& impulses, const Eigen::VectorXd& y,
                                          double relative_residual, int max_iterations) {
  Eigen::VectorXd on_rows = Eigen::VectorXd::Zero(all_rows_.size()), all(all_rows_.size());
  motion_of_all_rows_.add_impulses(impulses, on_rows);
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    changes_[i] = respond_alone(deformable_[i], all_rows_.change(i, on_rows), relative_residual, max_iterations,
                                bodies_.condensed(i) ? NodeVectors() : bodies_.change(i, y));
    all.segment(all_rows_.first_of_deformable(i), changes_[i].size()) = changes_[i].reshaped();
  }
  all.tail(all.size() - all_rows_.first_of_rigid()) = y.tail(y.size() - bodies_.first_of_rigid());
  return motion_of_all_rows_.of(all) - motion_.of(y);
}

NodeVectors respond_alone(const DeformableInertia& body, const NodeVectors& impulses, double relative_residual,
                          int max_iterations, const NodeVectors& guess) {
  if (!body.matrix) return impulses * body.masses.cwiseInverse().asDiagonal();
  NodeVectors rest = impulses, deforming = guess.size() > 0 ? guess : NodeVectors::Zero(3, impulses.cols());
  NodeVectors whole = NodeVectors::Zero(3, impulses.cols());
  if (body.whole.exists()) {
    const NodeVectors momentum = body.whole.momentum_of(impulses);
    rest -= momentum;
    deforming -= body.whole.part_of(deforming);
    whole = body.whole.part_of(velocities_of(body.whole, momentum));
  }
  conjugate_gradient(*body.matrix, {*body.preconditioner, body.factors}, rest, deforming, relative_residual,
                     std::sqrt(dot(rest, rest)), max_iterations, {}, body.whole.exists() ? &body.whole : nullptr);
  return whole + deforming;
}

}  // namespace griffith
