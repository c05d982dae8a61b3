#include "sim/fracture/node_load_sums.h"

#include <algorithm>
#include <array>

#include "sim/elasticity/corner_traction.h"
#include "sim/fracture/force_dyads.h"
#include "sim/mesh/corner_sums.h"

namespace griffith {
namespace {

using simd::DoubleLanes;
using simd::WideQuad;

/// Sums of each corner of an element.
using CornerSums = std::array<NodeLoadSums*, 4>;

void add_forces(const CornerVectors& tensile, const CornerVectors& compressive, const CornerSums& to) {
  const std::array<WideQuad, 4> t = one_by_one(tensile), c = one_by_one(compressive);
  for (int i = 0; i < 4; ++i) {
    to[i]->total.tensile += t[i];
    to[i]->total.compressive += c[i];
  }
}

/// Returns unit vectors; 0 for 0.
CornerVectors directions_of(const CornerVectors& f) {
  return inverse_or_zero(simd::root(f.x * f.x + f.y * f.y + f.z * f.z)) * f;
}

void add_dyads(const CornerVectors& tensile, const CornerVectors& compressive, const CornerSums& to) {
  const CornerVectors t = directions_of(tensile), c = directions_of(compressive);
  const auto add_column = [&](int column, DoubleLanes f, DoubleLanes g) {
    const std::array<WideQuad, 4> of_corners = one_by_one(f * t - g * c);
    for (int i = 0; i < 4; ++i) to[i]->dyads.columns[column] += of_corners[i];
  };
  add_column(0, tensile.x, compressive.x);
  add_column(1, tensile.y, compressive.y);
  add_column(2, tensile.z, compressive.z);
}

void add_tension(double volume, const ElementState& state, std::span<NodeLoadSums* const> to) {
  const auto& [xx, yy, zz, xy, xz, yz] = state.tension;
  const WideQuad diagonal = volume * WideQuad{xx, yy, zz, 1}, off_diagonal = volume * WideQuad{xy, xz, yz, 0};
  for (NodeLoadSums* sums : to) {
    sums->diagonal += diagonal;
    sums->off_diagonal += off_diagonal;
    sums->largest = std::max(sums->largest, state.tension_norm);
  }
}

void add_element(const RestElement& rest, const ElementState& state, bool anchored, const CornerSums& to) {
  const CornerVectors gradients = corner_gradients(rest);
  const CornerVectors part = product(state.tensile_traction, gradients), whole = corner_tractions(state, gradients);
  const DoubleLanes zero = {}, volume = zero + rest.volume;
  const CornerVectors tensile = -volume * part, compressive = volume * (part - whole);
  add_forces(tensile, compressive, to);
  add_dyads(tensile, compressive, to);
  if (!anchored) add_tension(rest.volume, state, to);
}

/// The same for a quadratic element, each corner of which has its own state.
void add_element(const RestElement& rest, const std::array<ElementState, 4>& states, bool anchored,
                 const CornerSums& to) {
  const auto at_corners = [&](const auto& vector_at) {
    return simd::side_by_side(vector_at(0), vector_at(1), vector_at(2), vector_at(3));
  };
  const auto gradient = [&](int i) { return rest.shape_gradients.col(i); };
  const CornerVectors part = at_corners([&](int i) {
    return simd::product(states[i].tensile_traction.data(), gradient(i)[0], gradient(i)[1], gradient(i)[2]);
  });
  const CornerVectors whole = at_corners([&](int i) { return corner_traction(rest, states[i], i); });
  const DoubleLanes zero = {}, volume = zero + rest.volume;
  const CornerVectors tensile = -volume * part, compressive = volume * (part - whole);
  add_forces(tensile, compressive, to);
  add_dyads(tensile, compressive, to);
  for (int i = 0; i < 4 && !anchored; ++i) add_tension(rest.volume, states[i], std::span(&to[i], 1));
}

/// Adds V/2 |(cof(B) g)·e| with the direction e of a corner.
void add_area(const RestElement& rest, const std::array<ElementState, 4>& states, const CornerSums& to) {
  for (int i = 0; i < 4; ++i) {
    const Vec3 across = cofactor(states[i].frame).transpose() * to[i]->pulled.direction;
    to[i]->area += 0.5 * rest.volume * std::abs(across.dot(rest.shape_gradients.col(i)));
  }
}

/// Adds V/2 |(cof(B) g)·e| with the direction e of each corner.
void add_area(const RestElement& rest, const ElementState& state, const CornerSums& to) {
  const auto direction = [&](int i) {
    const Vec3& e = to[i]->pulled.direction;
    return WideQuad{e.x(), e.y(), e.z(), 0};
  };
  const CornerVectors directions = simd::side_by_side(direction(0), direction(1), direction(2), direction(3));
  const Mat3 cofactors = cofactor(state.frame);
  const auto along = [&](int i) {  // cof(B)ᵀ e
    const DoubleLanes zero = {};
    return simd::dot({zero + cofactors(0, i), zero + cofactors(1, i), zero + cofactors(2, i)}, directions);
  };
  const CornerVectors across = {along(0), along(1), along(2)};
  const DoubleLanes area = 0.5 * rest.volume * simd::absolute(simd::dot(across, corner_gradients(rest)));
  for (int i = 0; i < 4; ++i) to[i]->area += area[i];
}

Mat3 tensor_of(const Dyads& dyads) { return 0.5 * simd::matrix_of(dyads.columns); }

/// Computes the separation tensors of nodes with complete sums, and their largest eigenpairs.
void find_pulls(const SeparationInput& input, std::span<const NodeId> nodes, std::span<NodeLoadSums> sums) {
  constexpr std::size_t kLanes = 4;
  for (std::size_t first = 0; first < nodes.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, nodes.size() - first);
    std::array<Mat3, kLanes> tensors;
    for (std::size_t i = 0; i < kLanes; ++i) {
      NodeLoadSums& star = sums[nodes[first + std::min(i, count - 1)]];  // spare lanes repeat the last one
      if (i < count && !is_constrained(input, nodes[first + i])) star.dyads.add(star.total, {}, -1);
      tensors[i] = tensor_of(star.dyads);
    }
    const std::array<LargestPrincipal, kLanes> pulled = largest_principals(tensors);
    for (std::size_t i = 0; i < count; ++i) sums[nodes[first + i]].pulled = pulled[i];
  }
}

}  // namespace

NodeLoad NodeLoadSums::load() const {
  return {tensor_of(dyads),
          pulled,
          area,
          diagonal[3],
          largest,
          SymmetricMat3{diagonal[0], diagonal[1], diagonal[2], off_diagonal[0], off_diagonal[1], off_diagonal[2]}};
}

void accumulate_node_loads(const SeparationInput& input, std::span<const TetId> tets, std::span<const NodeId> nodes,
                           std::span<NodeLoadSums> sums) {
  for (const NodeId node : nodes) sums[node] = {};
  add_at_corners(input.tets, tets, nodes, sums, [&](TetId tet, const CornerSums& to) {
    const bool anchored = is_anchored(input, tet);
    if (const auto* corners = input.corner_states(tet)) {
      add_element(input.rest_elements[tet], *corners, anchored, to);
    } else {
      add_element(input.rest_elements[tet], input.states[tet], anchored, to);
    }
  });
  find_pulls(input, nodes, sums);
  add_at_corners(input.tets, tets, nodes, sums, [&](TetId tet, const CornerSums& to) {
    if (is_anchored(input, tet)) return;
    if (const auto* corners = input.corner_states(tet)) {
      add_area(input.rest_elements[tet], *corners, to);
    } else {
      add_area(input.rest_elements[tet], input.states[tet], to);
    }
  });
}

}  // namespace griffith
