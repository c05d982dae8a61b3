#include "sim/fracture/mean_tension.h"

#include <algorithm>
#include <numbers>

namespace griffith {
namespace {

/// Radii in characteristic lengths.
constexpr double kBesideCracks = std::numbers::pi / 4, kElsewhere = 0.24;

double distance_at_rest(const TetMesh& mesh, NodeId node, TetId tet) {
  Vec3 sum = Vec3::Zero();
  for (const NodeId corner : mesh.tets[tet]) sum += mesh.rest_positions[corner];
  return (sum / 4 - mesh.rest_positions[node]).norm();
}

}  // namespace

TensionZone star_zone(const TetMesh& mesh, NodeId node) {
  TensionZone zone;
  for (const TetId tet : mesh.stars[node]) zone.parts.push_back({tet, 1});
  return zone;
}

TensionZone TensionZones::zone_within(NodeId node, double radius) {
  TensionZone zone{{}, radius};
  std::vector<TensionZone::Part>& parts = zone.parts;
  const auto weight_of = [&](TetId tet) { return 1 - distance_at_rest(mesh_, node, tet) / radius; };
  for (const TetId tet : mesh_.stars[node])
    if (const double weight = weight_of(tet); weight > 0) parts.push_back({tet, weight});
  if (parts.empty()) return zone;
  seen_.resize(mesh_.tets.size(), 0);
  ++search_;
  for (const TensionZone::Part& part : parts) seen_[part.tet.index()] = search_;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const TetId next : mesh_.neighbors[parts[i].tet]) {
      if (!next.valid() || seen_[next.index()] == search_) continue;
      seen_[next.index()] = search_;
      if (const double weight = weight_of(next); weight > 0) parts.push_back({next, weight});
    }
  return zone;
}

bool TensionZones::is_at_front(TetId tet) const {
  return std::ranges::any_of(mesh_.tets[tet], [&](NodeId corner) { return at_crack_front_[corner] != 0; });
}

TensionZone TensionZones::zone_of(NodeId node, double length, double depth) {
  TensionZone zone = zone_within(node, std::min(kBesideCracks * length, depth));
  if (std::ranges::any_of(zone.parts, [&](const TensionZone::Part& part) { return is_at_front(part.tet); }))
    return zone;
  return zone_within(node, std::min(kElsewhere * length, depth));
}

double mean_tension(const SeparationInput& input, const TensionZone& zone, const Vec3& normal) {
  double sum = 0, whole = 0;
  for (const auto& [tet, weight] : zone.parts) {
    const ElementState& state = input.states[tet];
    const double part = weight * input.rest_elements[tet].volume;
    sum += part * std::max(0.0, normal.dot(cauchy_stress(state.frame, state.stress) * normal));
    whole += part;
  }
  return sum / whole;
}

}  // namespace griffith
