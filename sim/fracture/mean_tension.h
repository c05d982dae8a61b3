#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/fracture/separation_tensor.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Part of a body over which the tension at a node counts. A crack begins only where enough of the body is overloaded
/// to pay for it, so that a peak smaller than the characteristic length l_ch = (K_Ic/σ_t)² breaks nothing (Leguillon
/// 2002).
struct TensionZone {
  struct Part {
    TetId tet;
    double weight = 0;  ///< 1 at the node, falling linearly with the distance to 0 at the radius
  };
  std::vector<Part> parts;  ///< empty where single elements are larger
  double radius = 0;        ///< [m]
};

/// Returns the tets of a node as its zone, all alike.
TensionZone star_zone(const TetMesh& mesh, NodeId node);

/// Finds the zones of nodes, one after the other.
class TensionZones {
 public:
  /// `at_crack_front`: per node, 1 where faces of a crack end. Both have to outlive this.
  TensionZones(const TetMesh& mesh, std::span<const std::uint8_t> at_crack_front)
      : mesh_(mesh), at_crack_front_(at_crack_front) {}

  /// Returns the zone of a node: the tets that its own ones reach through faces and whose centroids at rest are within
  /// a radius, at most half of a plate's thickness: a crack through the body is long enough.
  ///   near a crack front   π/4 l_ch, that of a round crack that runs at σ_t (Sneddon 1946). A second crack beside a
  ///                        first one thus needs the energy of two.
  ///   elsewhere            0.24 l_ch. It gives the mean tension σ_t ahead of a sharp notch at its critical load
  ///                        (theory of critical distances, Taylor 2007).
  ///   length  l_ch [m], > 0
  ///   depth   volume of the body over its surface [m]
  TensionZone zone_of(NodeId node, double length, double depth);

 private:
  TensionZone zone_within(NodeId node, double radius);
  bool is_at_front(TetId tet) const;

  const TetMesh& mesh_;
  std::span<const std::uint8_t> at_crack_front_;
  std::vector<int> seen_;  ///< per tet: the search that came by
  int search_ = 0;
};

/// Returns the mean tension across planes with a unit normal of the world frame, in a zone that is not empty [Pa].
/// Compression counts as 0.
double mean_tension(const SeparationInput& input, const TensionZone& zone, const Vec3& normal);

}  // namespace griffith
