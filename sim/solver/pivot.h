#pragma once

#include <optional>
#include <span>

#include "sim/core/ids.h"
#include "sim/solver/block_sparse_matrix.h"
#include "sim/solver/node_constraint.h"

namespace griffith {

/// A point that the supports of a body hold still and about which they let it turn: a hinge or a ball joint.
struct Pivot {
  using Axes = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
  Vec3 place = Vec3::Zero();  ///< [m]
  Axes axes;                  ///< orthonormal columns: those that it may turn about, one or three
};

/// Rotation of a set of nodes about a pivot.
struct Turning {
  Mat3 inertia = Mat3::Zero();   ///< about the pivot [kg·m²]
  Vec3 momentum = Vec3::Zero();  ///< angular, about the pivot [kg·m²/s]
  Vec3 spin = Vec3::Zero();      ///< the turn about the pivot's axes that carries the momentum about them [rad/s]
};

/// Returns the pivot of a body with these supports, or none: where it is held more firmly, where nothing holds it still
/// and where supports move. `constraints` and `positions` [m] are per node of the mesh.
std::optional<Pivot> pivot_of(std::span<const NodeId> supports, std::span<const NodeConstraint> constraints,
                              std::span<const Vec3> positions);

/// Returns the number of independent rigid motions that supports leave free, 0 to 6; moving ones count as still.
int count_free_motions(std::span<const NodeId> supports, std::span<const NodeConstraint> constraints,
                       std::span<const Vec3> positions);

/// Returns the inverse of an inertia about the pivot [kg·m²], in terms of the pivot's axes [1/(kg·m²)].
Pivot::Square inverse_inertia_on_axes(const Pivot& pivot, const Mat3& inertia);

/// Returns the inverse of an inertia about the pivot [kg·m²] for turns about its axes, 0 across them [1/(kg·m²)].
Mat3 inverse_inertia_about(const Pivot& pivot, const Mat3& inertia);

/// Returns the angular velocity about the pivot's axes [rad/s] with the angular momentum [kg·m²/s] about them.
Vec3 spin_about(const Pivot& pivot, const Mat3& inertia, const Vec3& momentum);

/// Translation that the supports of a body share, by least squares [m/s]: what differs from it deforms the body.
Vec3 common_velocity(std::span<const NodeId> supports, std::span<const NodeConstraint> constraints);

/// Returns the rotation of nodes: one column or entry per node [m], [m/s], [kg].
Turning turning_about(const Pivot& pivot, const NodeVectors& positions, const NodeVectors& velocities,
                      const Eigen::VectorXd& masses);

/// Returns the angular acceleration about the pivot's axes [rad/s²] by forces on nodes that have `half_turn` [rad]
/// still to go; one column or entry a node [N].
Vec3 swing_acceleration(const Pivot& pivot, const NodeVectors& positions, const Eigen::VectorXd& masses,
                        const NodeVectors& forces, const Vec3& half_turn);
/// Returns what that acceleration changes by where forces act in the middle of a substep of `dt` [s], not at its start,
/// with the places and velocities of nodes there [rad/s²].
Vec3 acceleration_gained_halfway(const Pivot& pivot, const NodeVectors& positions, const NodeVectors& velocities,
                                 const Eigen::VectorXd& masses, const NodeVectors& forces, double dt);

}  // namespace griffith
