#include "sim/fracture/separation_tensor.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/elasticity/corner_traction.h"
#include "sim/fracture/force_dyads.h"

namespace griffith {
namespace {

bool counts(const SeparationInput& input, TetId tet, NodeId node) {
  return !is_constrained(input, node) || !is_anchored(input, tet);
}

int local_corner(const SeparationInput& input, TetId tet, NodeId node) {
  const auto& corners = input.tets[tet];
  return (corners[1] == node) + 2 * (corners[2] == node) + 3 * (corners[3] == node);
}

ForceLanes force_lanes(const RestElement& rest, const ElementState& state, int corner) {
  const auto gradient = rest.shape_gradients.col(corner);
  const simd::WideQuad part = simd::product(state.tensile_traction.data(), gradient[0], gradient[1], gradient[2]);
  const simd::WideQuad whole = corner_traction(rest, state, corner);
  return {-rest.volume * part, rest.volume * (part - whole)};
}

NodeLoad node_load(const SeparationInput& input, NodeId node, const Mat3& tensor, const LargestPrincipal& pulled) {
  NodeLoad load{.tensor = tensor, .pulled = pulled};
  simd::WideQuad diagonal = {}, others = {};  // sums of volume times tension
  for (TetId tet : input.stars[node]) {
    if (!counts(input, tet, node)) continue;
    const RestElement& rest = input.rest_elements[tet];
    const int corner = local_corner(input, tet, node);
    const ElementState& state = input.state_at(tet, corner);
    const Vec3 across = cofactor(state.frame).transpose() * pulled.direction;
    load.area += 0.5 * rest.volume * std::abs(across.dot(rest.shape_gradients.col(corner)));
    load.volume += rest.volume;
    const SymmetricMat3& t = state.tension;
    diagonal += rest.volume * simd::WideQuad{t.xx, t.yy, t.zz, 0};
    others += rest.volume * simd::WideQuad{t.xy, t.xz, t.yz, 0};
    load.largest = std::max(load.largest, state.tension_norm);
  }
  load.tension = SymmetricMat3{diagonal[0], diagonal[1], diagonal[2], others[0], others[1], others[2]};
  return load;
}

std::array<LargestPrincipal, 1> principals_of(const std::array<Mat3, 1>& symmetric) {
  return {largest_principal(symmetric[0])};
}

std::array<LargestPrincipal, 4> principals_of(const std::array<Mat3, 4>& symmetric) {
  return largest_principals(symmetric);
}

/// Returns the unit normals n with the largest n·S n / n·T n.
template <std::size_t N>
std::array<Vec3, N> weakest_normals(std::array<Mat3, N> tensors, const std::array<DirectionalStrength, N>& strengths) {
  std::array<Mat3, N> roots;
  for (std::size_t i = 0; i < N; ++i) {
    if (strengths[i].is_uniform()) continue;
    roots[i] = strengths[i].inverse_root();
    tensors[i] = roots[i] * tensors[i] * roots[i];
  }
  const std::array<LargestPrincipal, N> principals = principals_of(tensors);
  std::array<Vec3, N> normals;
  for (std::size_t i = 0; i < N; ++i)
    normals[i] =
        strengths[i].is_uniform() ? principals[i].direction : (roots[i] * principals[i].direction).normalized();
  return normals;
}

template <std::size_t N>
bool all_uniform(const std::array<DirectionalStrength, N>& strengths) {
  return std::ranges::all_of(strengths, &DirectionalStrength::is_uniform);
}

/// Returns the plane normal to `normal` with the load of the separation tensor.
CandidatePlane pulled_plane(const NodeLoad& load, const Vec3& normal) {
  CandidatePlane plane;
  plane.normal = plane.pulled = normal;
  plane.eigenvalue = normal.dot(load.tensor * normal);
  plane.volume = load.volume;
  // If hardly any face meets the plane (as in a star of one tet) the quotient is meaningless. No plane can carry more
  // than the existing stress.
  if (load.pulled.value > 0 && load.area > 0)
    plane.stress = std::min(1 / load.area, load.largest / load.pulled.value) * plane.eigenvalue;
  return plane;
}

/// Takes the plane normal to `normal` if the mean tensile stress has a higher load there.
void take_if_weaker(const Mat3& average, const Vec3& normal, const DirectionalStrength& strength,
                    CandidatePlane& plane) {
  const double stress = normal.dot(average * normal);
  if (stress * strength.fraction(plane.normal) <= plane.stress * strength.fraction(normal)) return;
  plane.normal = normal;
  plane.stress = stress;
  plane.by_tension = true;
}

/// Returns the plane of each. Eigenvectors take longest and are computed side by side.
template <std::size_t N>
std::array<CandidatePlane, N> find_planes(const std::array<NodeLoad, N>& loads,
                                          const std::array<DirectionalStrength, N>& strengths) {
  std::array<Vec3, N> normals;
  std::array<Mat3, N> tensors, averages;
  for (std::size_t i = 0; i < N; ++i) {
    tensors[i] = loads[i].tensor;
    normals[i] = loads[i].pulled.direction;
  }
  if (!all_uniform(strengths)) normals = weakest_normals(tensors, strengths);

  std::array<CandidatePlane, N> planes;
  std::array<bool, N> is_open;  // true if the mean stress may have a weaker plane
  for (std::size_t i = 0; i < N; ++i) {
    const double volume = loads[i].volume;
    planes[i] = pulled_plane(loads[i], normals[i]);
    averages[i] = volume > 0 ? Mat3(loads[i].tension / volume) : Mat3(Mat3::Zero());
    // No plane of a mean stress has more than its norm.
    is_open[i] = volume != 0 && !(strengths[i].is_uniform() && averages[i].norm() <= planes[i].stress);
  }
  if (std::ranges::none_of(is_open, std::identity())) return planes;
  normals = weakest_normals(averages, strengths);
  for (std::size_t i = 0; i < N; ++i)
    if (is_open[i]) take_if_weaker(averages[i], normals[i], strengths[i], planes[i]);
  return planes;
}

}  // namespace

bool is_constrained(const SeparationInput& input, NodeId node) {
  return !input.constraints.empty() && !input.constraints[node].is_free();
}

bool is_anchored(const SeparationInput& input, TetId tet) {
  return !input.constraints.empty() &&
         std::ranges::all_of(input.tets[tet], [&](NodeId corner) { return input.constraints[corner].is_held(); });
}

Mat3 force_dyad(const Vec3& force) {
  const double length = force.norm();
  return length > 0 ? Mat3(force * force.transpose() * (1 / length)) : Mat3(Mat3::Zero());
}

SplitForce split_force(const SeparationInput& input, TetId tet, NodeId node) {
  const int corner = local_corner(input, tet, node);
  return split_force(input.rest_elements[tet], input.state_at(tet, corner), corner);
}

SplitForce split_force(const RestElement& rest, const ElementState& state, int corner) {
  const ForceLanes forces = force_lanes(rest, state, corner);
  return {Vec3(forces.tensile[0], forces.tensile[1], forces.tensile[2]),
          Vec3(forces.compressive[0], forces.compressive[1], forces.compressive[2])};
}

Mat3 separation_tensor(const SeparationInput& input, NodeId node) {
  const std::span<const TetId> star = input.stars[node];
  const auto forces_of = [&](TetId tet) {
    const int corner = local_corner(input, tet, node);
    return force_lanes(input.rest_elements[tet], input.state_at(tet, corner), corner);
  };
  Dyads sum;
  ForceLanes total;
  for (std::size_t i = 0; i < star.size(); i += 2) {
    const ForceLanes first = forces_of(star[i]), second = i + 1 < star.size() ? forces_of(star[i + 1]) : ForceLanes();
    sum.add(first, second, 1);
    total.tensile = total.tensile + first.tensile + second.tensile;
    total.compressive = total.compressive + first.compressive + second.compressive;
  }
  if (!is_constrained(input, node)) sum.add(total, {}, -1);
  return 0.5 * simd::matrix_of(sum.columns);
}

CandidatePlane candidate_plane(const SeparationInput& input, NodeId node, const Mat3& tensor,
                               const DirectionalStrength& strength) {
  return find_planes<1>({node_load(input, node, tensor, largest_principal(tensor))}, {strength})[0];
}

std::array<NodeLoad, 4> node_loads(const SeparationInput& input, std::span<const NodeId> nodes) {
  std::array<Mat3, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i)
    tensors[i] = i < nodes.size() ? separation_tensor(input, nodes[i]) : tensors[i - 1];
  const std::array<LargestPrincipal, 4> pulled = largest_principals(tensors);
  std::array<NodeLoad, 4> loads;
  for (std::size_t i = 0; i < 4; ++i)
    loads[i] = i < nodes.size() ? node_load(input, nodes[i], tensors[i], pulled[i]) : loads[i - 1];
  return loads;
}

std::array<CandidatePlane, 4> candidate_planes(const std::array<NodeLoad, 4>& loads,
                                               const std::array<DirectionalStrength, 4>& strengths) {
  return find_planes<4>(loads, strengths);
}

double tension_fraction(const SeparationInput& input, TetId tet, NodeId node, const CandidatePlane& plane) {
  if (!counts(input, tet, node)) return 0;
  const ElementState& state = input.state_at(tet, local_corner(input, tet, node));
  return input.rest_elements[tet].volume / plane.volume * plane.normal.dot(state.tension.full() * plane.normal);
}

DirectionalStrength strength_at(const SeparationInput& input, NodeId node, const Weakness& weakness) {
  Vec3 axis = Vec3::Zero();
  for (TetId tet : input.stars[node])
    axis += input.rest_elements[tet].volume * (input.states[tet].frame * weakness.direction);
  return directional_strength(weakness, axis.normalized());
}

}  // namespace griffith
