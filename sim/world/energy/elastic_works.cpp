#include "sim/world/energy/elastic_works.h"

#include <algorithm>
#include <array>

#include "sim/core/parallel.h"
#include "sim/core/tet_edge_corners.h"
#include "sim/elasticity/eigenvalues.h"
#include "sim/elasticity/stiffness.h"
#include "sim/world/bodies/effective_law.h"
#include "sim/world/state/corners.h"

namespace griffith {
namespace {

using simd::DoubleLanes;
using FourMatrices = simd::Matrix3<DoubleLanes>;

/// Four tets side by side before they move.
struct FourStarts {
  FourMatrices frame, gradient;  ///< gradient: of the displacements that deform the body
  simd::Symmetric3<DoubleLanes> stress;
  simd::Symmetric3<DoubleLanes> compaction = {};  ///< zero for laws that do not resist it
  DoubleLanes volume;
};

struct FourWorks {
  DoubleLanes first, change;
};

/// Returns the sum of the entries in pairs of pairs, like Eigen.
DoubleLanes sum_of(const FourMatrices& m) {
  const auto& a = m.at;
  return ((a[0][0] + a[1][0]) + (a[2][0] + a[0][1])) + ((a[1][1] + a[2][1]) + (a[0][2] + (a[1][2] + a[2][2])));
}

template <class Entry>
FourMatrices matrix_of(const Entry& entry) {
  FourMatrices m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m.at[i][j] = entry(i, j);
  return m;
}

FourMatrices full(const simd::Symmetric3<DoubleLanes>& s) {
  return {{{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}}};
}

DoubleLanes sum_of_products(const FourMatrices& a, const FourMatrices& b) {
  return sum_of(matrix_of([&](int i, int j) { return a.at[i][j] * b.at[i][j]; }));
}

DoubleLanes trace_of(const FourMatrices& m) { return m.at[0][0] + (m.at[1][1] + m.at[2][2]); }

/// Coordinates of the four corners of tets.
using FourCorners = DoubleLanes[3][4];

/// Returns the gradients of displacements of the corners. `slopes`: gradients of the shape functions.
FourMatrices gradients_of(const FourCorners& ways, const FourCorners& slopes) {
  return matrix_of([&](int i, int j) {
    return (ways[i][0] * slopes[j][0] + ways[i][1] * slopes[j][1]) +
           (ways[i][2] * slopes[j][2] + ways[i][3] * slopes[j][3]);
  });
}

FourStarts starts_of(const WorldState& world, const ElasticLaw& law, const std::array<TetId, 4>& tets, double dt) {
  const auto lanes = [&](const auto& get) {
    return DoubleLanes{get(tets[0]), get(tets[1]), get(tets[2]), get(tets[3])};
  };
  const auto state = [&](TetId tet) -> const ElementState& { return world.elements.states[tet]; };
  const auto rest = [&](TetId tet) -> const RestElement& { return world.elements.rest_elements[tet]; };
  const std::vector<Vec3>& deforming = world.scratch.substep_start.deforming_velocities;
  FourCorners ways, slopes;
  for (int i = 0; i < 3; ++i)
    for (int corner = 0; corner < 4; ++corner) {
      const auto node = [&](TetId tet) { return world.mesh->tets[tet][corner]; };
      ways[i][corner] = dt * lanes([&](TetId tet) { return deforming[node(tet)][i]; });
      slopes[i][corner] = lanes([&](TetId tet) { return rest(tet).shape_gradients(i, corner); });
    }
  FourStarts starts;
  starts.frame = matrix_of([&](int i, int j) { return lanes([&](TetId tet) { return state(tet).frame(i, j); }); });
  starts.gradient = gradients_of(ways, slopes);
  const auto symmetric = [&](SymmetricMat3 ElementState::*matrix) -> simd::Symmetric3<DoubleLanes> {
    const auto entry = [&](double SymmetricMat3::*of) {
      return lanes([&](TetId tet) { return state(tet).*matrix.*of; });
    };
    return {entry(&SymmetricMat3::xx), entry(&SymmetricMat3::yy), entry(&SymmetricMat3::zz),
            entry(&SymmetricMat3::xy), entry(&SymmetricMat3::xz), entry(&SymmetricMat3::yz)};
  };
  starts.stress = symmetric(&ElementState::stress);
  if (law.compaction > 0) starts.compaction = symmetric(&ElementState::compaction);
  starts.volume = lanes([&](TetId tet) { return rest(tet).volume; });
  return starts;
}

/// Returns the change of the work against compaction per volume: tr(a)² + ½ sym(a) : sym(a) with a = G (B C)ᵀ of the
/// gradient G (stiffness_row()).
DoubleLanes compaction_work(const FourStarts& starts) {
  const auto& b = starts.frame.at;
  const FourMatrices c = full(starts.compaction);
  const FourMatrices bc =
      matrix_of([&](int i, int j) { return b[i][0] * c.at[0][j] + (b[i][1] * c.at[1][j] + b[i][2] * c.at[2][j]); });
  const auto& g = starts.gradient.at;
  const auto rate = [&](int i, int j) {
    return g[i][0] * bc.at[j][0] + (g[i][1] * bc.at[j][1] + g[i][2] * bc.at[j][2]);
  };
  const FourMatrices x = matrix_of([&](int i, int j) { return 0.5 * (rate(i, j) + rate(j, i)); });
  return trace_of(x) * trace_of(x) + 0.5 * sum_of_products(x, x);
}

/// Returns the symmetric parts of Bᵀ G of a gradient G of displacements in the frame B.
FourMatrices strain_of(const FourMatrices& frame, const FourMatrices& gradient) {
  const auto &f = frame.at, &g = gradient.at;
  const FourMatrices turned =
      matrix_of([&](int i, int j) { return f[0][i] * g[0][j] + (f[1][i] * g[1][j] + f[2][i] * g[2][j]); });
  return matrix_of([&](int i, int j) { return 0.5 * (turned.at[i][j] + turned.at[j][i]); });
}

FourWorks works_of(const ElasticLaw& law, const FourStarts& starts) {
  const FourMatrices stress = full(starts.stress);
  const FourMatrices strain = strain_of(starts.frame, starts.gradient);
  FourWorks works;
  works.first = starts.volume * sum_of_products(stress, strain);
  works.change =
      starts.volume * (law.lambda * trace_of(strain) * trace_of(strain) + 2 * law.mu * sum_of_products(strain, strain));
  if (law.compaction > 0) works.change += starts.volume * compaction_work(starts);
  if (law.model == ElementModel::green_strain) {
    const auto &t = full(simd::tensile_part(starts.stress)).at, &g = starts.gradient.at;
    const FourMatrices carried =
        matrix_of([&](int i, int j) { return g[i][0] * t[0][j] + (g[i][1] * t[1][j] + g[i][2] * t[2][j]); });
    works.change += starts.volume * sum_of_products(carried, starts.gradient);
  }
  return works;
}

/// Displacements of the corners and offsets of the edges of a quadratic tet [m].
struct QuadraticWay {
  Corners corners;
  EdgeVectors edges;
};

/// Returns the displacements y_v of linear tets with the gradients at the corners v of a quadratic one, and their sum:
/// y_v,i = x_i + 4 w_vi.
std::array<Corners, 5> linear_ways(const QuadraticWay& way) {
  const Corners& x = way.corners;
  std::array<Corners, 5> ways = {x, x, x, x, Corners::Zero()};
  for (int edge = 0; edge < 6; ++edge) {
    const auto [i, j] = kTetEdges[edge];
    ways[i].col(j) += 4 * way.edges.col(edge);
    ways[j].col(i) += 4 * way.edges.col(edge);
  }
  for (int v = 0; v < 4; ++v) ways[4] += ways[v];
  return ways;
}

/// Returns a·K a of a quadratic tet. With K of the linear tet, it is (Σ_v a_v·K a_v + Σ a_v·K Σ a_v) / 20.
double stiffness_product(const ElasticLaw& law, const RestElement& rest, const ElementState& mean,
                         const QuadraticWay& way) {
  const std::array<Corners, 5> ways = linear_ways(way);
  double product = 0;
  for (int i = 0; i < 4; ++i) {
    const StiffnessRow row = stiffness_row(law, rest, mean, i);
    for (int j = 0; j < 4; ++j) {
      const Mat3 block = row.block(j);
      for (int v = 0; v < 5; ++v) product += ways[v].col(i).dot(block * ways[v].col(j));
    }
  }
  return product / 20;
}

ElasticWorks quadratic_works(const WorldState& world, const Body& body, double dt) {
  const ElasticLaw law = elastic_law(world.material_of(body));
  const SubstepStart& start = world.scratch.substep_start;
  const auto count = static_cast<int>(body.tets.size());
  std::vector<double> first(count), change(count);
  parallel_for(count, 64, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const TetId tet = body.tets[i];
      const RestElement& rest = world.elements.rest_elements[tet];
      const auto way_of = [&](const std::vector<Vec3>& nodes, const std::vector<Vec3>& edges) {
        return QuadraticWay{dt * corners_of(world.mesh, tet, nodes), dt * edges_of(world.tet_edges, tet, edges)};
      };
      const QuadraticWay deforming = way_of(start.deforming_velocities, start.deforming_edge_velocities);
      const QuadraticForces acting = quadratic_forces(rest, world.elements.quadratic_states[tet]);
      first[i] =
          -acting.corners.cwiseProduct(deforming.corners).sum() - acting.edges.cwiseProduct(deforming.edges).sum();
      change[i] = stiffness_product(law, rest, world.elements.states[tet], deforming);
    }
  });
  ElasticWorks sum;
  for (int i = 0; i < count; ++i) {
    sum.first += first[i];
    sum.change += change[i];
    sum.energy_densities.push_back(world.elements.states[body.tets[i]].energy_density);
  }
  return sum;
}

}  // namespace

double twice_energy_density(const ElasticLaw& law, const Mat3& stress) {
  const double fraction = law.lambda / (3 * law.lambda + 2 * law.mu);
  return (stress.squaredNorm() - fraction * stress.trace() * stress.trace()) / (2 * law.mu);
}

ElasticWorks elastic_works(const WorldState& world, const Body& body, double dt) {
  if (!body.edges.empty()) return quadratic_works(world, body, dt);
  constexpr int kLanes = simd::kDoubleLanes;
  const ElasticLaw law = effective_elastic_law(world, body);
  const int count = static_cast<int>(body.tets.size());
  std::vector<FourWorks> of_tets((count + kLanes - 1) / kLanes);
  parallel_for(static_cast<int>(of_tets.size()), 256, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      std::array<TetId, kLanes> tets;
      for (int lane = 0; lane < kLanes; ++lane) tets[lane] = body.tets[std::min(kLanes * i + lane, count - 1)];
      of_tets[i] = works_of(law, starts_of(world, law, tets, dt));
    }
  });
  ElasticWorks sum;
  sum.energy_densities.reserve(body.tets.size());
  for (int i = 0; i < count; ++i) {
    const FourWorks& works = of_tets[i / kLanes];
    sum.first += works.first[i % kLanes];
    sum.change += works.change[i % kLanes];
    sum.energy_densities.push_back(world.elements.states[body.tets[i]].energy_density);
  }
  return sum;
}

double stored_since(const WorldState& world, const Body& body, const ElasticWorks& works) {
  double stored = 0;
  for (std::size_t i = 0; i < body.tets.size(); ++i) {
    const TetId tet = body.tets[i];
    stored += world.elements.rest_elements[tet].volume *
              (world.elements.states[tet].energy_density - works.energy_densities[i]);
  }
  return stored;
}

}  // namespace griffith
