#include "app/picture/exaggeration.h"

#include "sim/elasticity/polar_decomposition.h"

namespace griffith::app {
namespace {

/// A weighted sum over a piece's nodes, and what it makes of them.
struct RigidFit {
  double weight = 0;
  Vec3 rest = Vec3::Zero(), now = Vec3::Zero();  ///< sums, then means
  Mat3 covariance = Mat3::Zero(), rotation = Mat3::Identity();
};

constexpr double kHeldWeight = 1e8;  // of a held node, where a free one has 1

double fit_weight(const Frame& frame, std::size_t node) {
  if (!frame.nodes.positions[node].allFinite()) return 0;
  return frame.nodes.constraints[node].is_held() ? kHeldWeight : 1;
}

BodyId piece_of(const Frame& frame, std::size_t node) {
  const std::vector<TetId>& star = frame.nodes.stars[node];
  return star.empty() ? BodyId() : frame.elements.bodies[star.front()];
}

std::vector<RigidFit> rigid_fits(const Frame& frame) {
  std::vector<RigidFit> fits(frame.bodies.size());
  const auto for_each_node = [&](const auto& add) {
    for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i)
      if (const BodyId piece = piece_of(frame, i); piece.valid()) add(i, fits[piece], fit_weight(frame, i));
  };
  for_each_node([&](std::size_t i, RigidFit& fit, double weight) {
    if (weight == 0) return;
    fit.weight += weight;
    fit.rest += weight * frame.nodes.rest_positions[i];
    fit.now += weight * frame.nodes.positions[i];
  });
  for (RigidFit& fit : fits) {
    if (fit.weight == 0) continue;
    fit.rest /= fit.weight;
    fit.now /= fit.weight;
  }
  for_each_node([&](std::size_t i, RigidFit& fit, double weight) {
    if (weight == 0) return;
    fit.covariance +=
        weight * (frame.nodes.positions[i] - fit.now) * (frame.nodes.rest_positions[i] - fit.rest).transpose();
  });
  for (RigidFit& fit : fits) fit.rotation = polar_rotation(fit.covariance);  // the nearest one (Kabsch 1976)
  return fits;
}

}  // namespace

std::vector<Vec3> exaggerated_positions(const Frame& frame, double factor) {
  std::vector<Vec3> positions(frame.nodes.positions.begin(), frame.nodes.positions.end());
  if (factor == 1) return positions;
  const std::vector<RigidFit> fits = rigid_fits(frame);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const BodyId piece = piece_of(frame, i);
    if (!piece.valid() || !positions[i].allFinite()) continue;
    const RigidFit& fit = fits[piece];
    const Vec3 rigid = fit.now + fit.rotation * (frame.nodes.rest_positions[i] - fit.rest);
    positions[i] = rigid + factor * (positions[i] - rigid);
  }
  return positions;
}

}  // namespace griffith::app
