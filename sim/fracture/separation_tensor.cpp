#include "sim/fracture/separation_tensor.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/elasticity/corner_traction.h"
#include "sim/elasticity/principal_stress.h"

namespace griffith {
namespace {

bool constrained(const SeparationInput& input, NodeId node) {
  return !input.constraints.empty() && !input.constraints[node].is_free();
}

bool anchored(const SeparationInput& input, TetId tet) {
  const auto& corners = input.tets[tet];
  return std::all_of(corners.begin(), corners.end(),
                     [&](NodeId corner) { return input.constraints[corner].is_held(); });
}

bool counts(const SeparationInput& input, TetId tet, NodeId node) {
  return !constrained(input, node) || !anchored(input, tet);
}

int local_corner(const SeparationInput& input, TetId tet, NodeId node) {
  const auto& corners = input.tets[tet];
  return (corners[1] == node) + 2 * (corners[2] == node) + 3 * (corners[3] == node);
}

/// A split force in the first three lanes; the fourth counts for nothing.
struct ForceLanes {
  simd::WideQuad tensile = {}, compressive = {};
};

ForceLanes force_lanes(const RestElement& rest, const ElementState& state, int corner) {
  const auto gradient = rest.shape_gradients.col(corner);
  const simd::WideQuad part = simd::product(state.tensile_traction.data(), gradient[0], gradient[1], gradient[2]);
  const simd::WideQuad whole = corner_traction(rest, state, corner);
  return {-rest.volume * part, rest.volume * (part - whole)};
}

/// 1/|f| of the first three lanes of each, 0 of a zero force.
simd::DoubleLanes inverse_lengths(simd::WideQuad a, simd::WideQuad b, simd::WideQuad c, simd::WideQuad d) {
  simd::transpose(a, b, c, d);
  const simd::DoubleLanes length = simd::root(a * a + b * b + c * c), zero = {};
  return length > 0.0 ? 1.0 / length : zero;
}

/// A sum of m(f⁺) − m(f⁻).
struct Dyads {
  simd::WideQuad columns[3] = {};

  /// Adds `factor` times that of two elements, in their order: 1 and −1 cancel exactly.
  void add(const ForceLanes& first, const ForceLanes& second, double factor) {
    const simd::DoubleLanes inverse =
        inverse_lengths(first.tensile, first.compressive, second.tensile, second.compressive);
    add(first, factor, inverse[0], inverse[1]);
    add(second, factor, inverse[2], inverse[3]);
  }

 private:
  void add(const ForceLanes& forces, double factor, double inverse_tensile, double inverse_compressive) {
    const simd::WideQuad tensile = forces.tensile * inverse_tensile,
                         compressive = forces.compressive * inverse_compressive;
    for (int i = 0; i < 3; ++i)
      columns[i] += factor * (tensile * forces.tensile[i] - compressive * forces.compressive[i]);
  }
};

/// Sums over the elements round a node, seen across a plane.
struct StarSums {
  double area = 0, volume = 0, largest = 0;
  Mat3 tension = Mat3::Zero();  ///< volume times stress
};

StarSums sum_star(const SeparationInput& input, NodeId node, const Vec3& normal) {
  StarSums sums;
  simd::WideQuad diagonal = {}, others = {};  // of volume times tension
  for (TetId tet : input.stars[node]) {
    if (!counts(input, tet, node)) continue;
    const RestElement& rest = input.rest_elements[tet];
    const ElementState& state = input.states[tet];
    const Vec3 across = cofactor(state.frame).transpose() * normal;
    sums.area += 0.5 * rest.volume * std::abs(across.dot(rest.shape_gradients.col(local_corner(input, tet, node))));
    sums.volume += rest.volume;
    const SymmetricMat3& t = state.tension;
    diagonal += rest.volume * simd::WideQuad{t.xx, t.yy, t.zz, 0};
    others += rest.volume * simd::WideQuad{t.xy, t.xz, t.yz, 0};
    sums.largest = std::max(sums.largest, state.tension_norm);
  }
  sums.tension = SymmetricMat3{diagonal[0], diagonal[1], diagonal[2], others[0], others[1], others[2]};
  return sums;
}

std::array<LargestPrincipal, 1> principals_of(const std::array<Mat3, 1>& symmetric) {
  return {largest_principal(symmetric[0])};
}

std::array<LargestPrincipal, 4> principals_of(const std::array<Mat3, 4>& symmetric) {
  return largest_principals(symmetric);
}

/// The unit normals n with the largest n·S n / n·T n.
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

/// The plane that the separation tensor pulls at, across `normal`. `pulled`: its largest eigenpair.
CandidatePlane pulled_plane(const StarSums& sums, const Mat3& tensor, const LargestPrincipal& pulled,
                            const Vec3& normal) {
  CandidatePlane plane;
  plane.normal = plane.pulled = normal;
  plane.eigenvalue = normal.dot(tensor * normal);
  plane.volume = sums.volume;
  // Where hardly any face meets the plane (a star of one tet, say) the quotient means nothing: no plane can carry more
  // than the stress that is there.
  if (pulled.value > 0 && sums.area > 0)
    plane.stress = std::min(1 / sums.area, sums.largest / pulled.value) * plane.eigenvalue;
  return plane;
}

/// Takes the plane across `normal` where the mean tensile stress asks more of it.
void take_if_weaker(const Mat3& average, const Vec3& normal, const DirectionalStrength& strength,
                    CandidatePlane& plane) {
  const double stress = normal.dot(average * normal);
  if (stress * strength.fraction(plane.normal) <= plane.stress * strength.fraction(normal)) return;
  plane.normal = normal;
  plane.stress = stress;
  plane.by_tension = true;
}

/// candidate_plane() of each node: what takes longest, eigenvectors, side by side.
template <std::size_t N>
std::array<CandidatePlane, N> find_planes(const SeparationInput& input, const std::array<NodeId, N>& nodes,
                                          const std::array<Mat3, N>& tensors,
                                          const std::array<DirectionalStrength, N>& strengths) {
  const std::array<LargestPrincipal, N> pulled = principals_of(tensors);
  std::array<Vec3, N> normals;
  for (std::size_t i = 0; i < N; ++i) normals[i] = pulled[i].direction;
  if (!all_uniform(strengths)) normals = weakest_normals(tensors, strengths);

  std::array<CandidatePlane, N> planes;
  std::array<Mat3, N> averages;
  std::array<bool, N> is_open;  // whether the mean stress may have a plane that is weaker
  for (std::size_t i = 0; i < N; ++i) {
    const StarSums sums = sum_star(input, nodes[i], pulled[i].direction);
    planes[i] = pulled_plane(sums, tensors[i], pulled[i], normals[i]);
    averages[i] = sums.volume > 0 ? Mat3(sums.tension / sums.volume) : Mat3(Mat3::Zero());
    // No plane of a mean stress has more than its norm.
    is_open[i] = sums.volume != 0 && !(strengths[i].is_uniform() && averages[i].norm() <= planes[i].stress);
  }
  if (std::ranges::none_of(is_open, std::identity())) return planes;
  normals = weakest_normals(averages, strengths);
  for (std::size_t i = 0; i < N; ++i)
    if (is_open[i]) take_if_weaker(averages[i], normals[i], strengths[i], planes[i]);
  return planes;
}

}  // namespace

Mat3 force_dyad(const Vec3& force) {
  const double length = force.norm();
  return length > 0 ? Mat3(force * force.transpose() * (1 / length)) : Mat3(Mat3::Zero());
}

SplitForce split_force(const SeparationInput& input, TetId tet, NodeId node) {
  return split_force(input.rest_elements[tet], input.states[tet], local_corner(input, tet, node));
}

SplitForce split_force(const RestElement& rest, const ElementState& state, int corner) {
  const ForceLanes forces = force_lanes(rest, state, corner);
  return {Vec3(forces.tensile[0], forces.tensile[1], forces.tensile[2]),
          Vec3(forces.compressive[0], forces.compressive[1], forces.compressive[2])};
}

Mat3 separation_tensor(const SeparationInput& input, NodeId node) {
  const std::span<const TetId> star = input.stars[node];
  const auto forces_of = [&](TetId tet) {
    return force_lanes(input.rest_elements[tet], input.states[tet], local_corner(input, tet, node));
  };
  Dyads sum;
  ForceLanes total;
  for (std::size_t i = 0; i < star.size(); i += 2) {
    const ForceLanes first = forces_of(star[i]), second = i + 1 < star.size() ? forces_of(star[i + 1]) : ForceLanes();
    sum.add(first, second, 1);
    total.tensile = total.tensile + first.tensile + second.tensile;
    total.compressive = total.compressive + first.compressive + second.compressive;
  }
  if (!constrained(input, node)) sum.add(total, {}, -1);
  return 0.5 * simd::matrix_of(sum.columns);
}

CandidatePlane candidate_plane(const SeparationInput& input, NodeId node, const Mat3& tensor,
                               const DirectionalStrength& strength) {
  return find_planes<1>(input, {node}, {tensor}, {strength})[0];
}

std::array<CandidatePlane, 4> candidate_planes(const SeparationInput& input, const std::array<NodeId, 4>& nodes,
                                               const std::array<Mat3, 4>& tensors,
                                               const std::array<DirectionalStrength, 4>& strengths) {
  return find_planes<4>(input, nodes, tensors, strengths);
}

double tension_fraction(const SeparationInput& input, TetId tet, NodeId node, const CandidatePlane& plane) {
  if (!counts(input, tet, node)) return 0;
  const ElementState& state = input.states[tet];
  return input.rest_elements[tet].volume / plane.volume * plane.normal.dot(state.tension.full() * plane.normal);
}

DirectionalStrength strength_at(const SeparationInput& input, NodeId node, const Weakness& weakness) {
  Vec3 axis = Vec3::Zero();
  for (TetId tet : input.stars[node])
    axis += input.rest_elements[tet].volume * (input.states[tet].frame * weakness.direction);
  return directional_strength(weakness, axis.normalized());
}

}  // namespace griffith
