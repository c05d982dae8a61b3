#include "app/bake/piece_poses.h"

#include "sim/elasticity/placement.h"

namespace griffith::app {
namespace {

/// Sums over the tets of a piece, weighted by volume, since its density is uniform.
struct PieceSums {
  double volume = 0;               ///< [m³]
  Vec3 center = Vec3::Zero();      ///< integral of the position
  Mat3 covariance = Mat3::Zero();  ///< covariance of current and first positions relative to their centers
};

std::vector<Vec3> centers_of(const Frame& last, const MeshHistory& history, int state) {
  std::vector<Vec3> centers(last.bodies.size(), Vec3::Zero());
  std::vector<double> volumes(last.bodies.size());
  for (const TetId tet : IdRange<TetId>(0, std::ssize(last.elements.tets))) {
    const BodyId body = last.elements.bodies[tet];
    const double volume = last.elements.rest_elements[tet].volume;
    centers[body] += volume * history.corners(state, tet).rowwise().mean();
    volumes[body] += volume;
  }
  for (std::size_t i = 0; i < centers.size(); ++i)
    if (volumes[i] > 0) centers[i] /= volumes[i];
  return centers;
}

Pose fitted_pose(const PieceSums& sums, const std::vector<Pose>& before) {
  Pose pose;
  pose.translation = sums.center / sums.volume;
  pose.rotation = Quat(best_rotation(sums.covariance));
  if (!before.empty() && pose.rotation.dot(before.back().rotation) < 0) pose.rotation.coeffs() *= -1;
  return pose;
}

}  // namespace

std::vector<std::vector<Pose>> piece_poses(const Frame& last, const MeshHistory& history, int first) {
  const std::vector<Vec3> first_centers = centers_of(last, history, first);
  std::vector<Corners> arms;  // per tet: first corners relative to the center of its piece
  for (const TetId tet : IdRange<TetId>(0, std::ssize(last.elements.tets)))
    arms.push_back(history.corners(first, tet).colwise() - first_centers[last.elements.bodies[tet]]);
  std::vector<std::vector<Pose>> poses(last.bodies.size());
  for (int state = first; state < std::ssize(history.states()); ++state) {
    std::vector<PieceSums> sums(last.bodies.size());
    for (const TetId tet : IdRange<TetId>(0, std::ssize(last.elements.tets))) {
      PieceSums& piece = sums[last.elements.bodies[tet]];
      const double volume = last.elements.rest_elements[tet].volume;
      const Corners corners = history.corners(state, tet);
      piece.volume += volume;
      piece.center += volume * corners.rowwise().mean();
      piece.covariance += volume / 4 * corners * arms[tet].transpose();
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (sums[i].volume > 0) poses[i].push_back(fitted_pose(sums[i], poses[i]));
  }
  return poses;
}

}  // namespace griffith::app
