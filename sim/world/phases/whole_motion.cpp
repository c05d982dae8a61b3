#include "sim/world/phases/whole_motion.h"

#include <Eigen/LU>

#include "sim/core/rotation.h"
#include "sim/solver/pivot.h"

namespace griffith {

WholeMotion whole_motion(const WorldState& world, const Body& body, double dt) {
  WholeMotion whole;
  const std::optional<Pivot> pivot = pivot_of(body.system->supports(), world.nodes.constraints, world.nodes.positions);
  if (body.supported() && !pivot) return whole;
  const std::span<const NodeId> nodes = body.system->nodes();
  whole.arms = body.system->gather(world.nodes.positions, world.edges.offsets);
  whole.masses.resize(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t row = 0; row < nodes.size(); ++row) whole.masses[row] = world.nodes.masses[nodes[row]];
  const Vec3 center = whole.arms.leftCols(whole.masses.size()) * whole.masses / whole.masses.sum();
  const Vec3 origin = pivot ? pivot->place : center;
  whole.arms.leftCols(whole.masses.size()).colwise() -= origin;
  whole.damping = 1 + dt * world.material_of(body).mass_damping;
  Mat3 inertia = Mat3::Zero();
  for (Eigen::Index i = 0; i < whole.masses.size(); ++i) {
    const Mat3 arm = cross_matrix(whole.arms.col(i));
    inertia -= whole.masses[i] * arm * arm;
  }
  if (pivot) {
    whole.inverse_inertia =
        pivot->axes * (pivot->axes.transpose() * inertia * pivot->axes).inverse() * pivot->axes.transpose();
  } else {
    whole.inverse_mass = 1 / whole.masses.sum();
    whole.inverse_inertia = inertia.inverse();
  }
  return whole;
}

}  // namespace griffith
