#include "sim/explicit/explicit_bodies.h"

#include <algorithm>
#include <cmath>

#include "sim/core/parallel.h"
#include "sim/elasticity/element_frequency.h"
#include "sim/elasticity/quadratic_frequency.h"
#include "sim/explicit/stars.h"
#include "sim/fracture/fracture_law.h"

namespace griffith::explicit_dynamics {
namespace {

/// Sets the entries of one lane.
void set_lane(Lanes (&entries)[6], int lane, const Mat3& m) {
  constexpr int kRow[6] = {0, 1, 2, 0, 1, 0}, kColumn[6] = {0, 1, 2, 1, 2, 2};
  for (int e = 0; e < 6; ++e) entries[e][lane] = static_cast<float>(m(kRow[e], kColumn[e]));
}

/// Fraction of critical damping at the highest frequency: damps oscillations that the mesh cannot resolve, but no
/// others.
constexpr double kDampingRatio = 0.12;
/// Elements that would keep a smaller fraction of their stiffness are so flat that they exert no force.
constexpr double kMinFraction = 0.25;

/// Leaves an element a fraction of its stiffness.
void relieve(ElementBlock& block, std::size_t lane, double fraction) {
  block.stiffness[lane] = fraction > kMinFraction ? static_cast<float>(fraction) : 0;
  if (fraction > kMinFraction) return;
  for (int k = 0; k < 3; ++k)
    for (int a = 0; a < 3; ++a) block.gradients[k][a][lane] = 0;  // its numbers stay finite however it is crushed
}

}  // namespace

int ExplicitBodies::add_node(const ExplicitNodeStart& start) {
  nodes_.push_back({.inverse_mass = 1 / start.mass});
  references_.push_back({wide(start.reference)});
  displacements_.push_back({wide(start.displacement)});
  velocities_.push_back({wide(start.velocity)});
  accelerations_.push_back({wide(start.acceleration)});
  return node_count() - 1;
}

int ExplicitBodies::copy_node(int node, double mass) {
  const ExplicitNodeStart start{reference(node), displacement(node), velocity(node), vector(accelerations_[node].value),
                                mass};
  const int copy = add_node(start);
  if (nodes_[node].constraint >= 0) constrain(copy, NodeConstraint(constraints_[nodes_[node].constraint].constraint));
  return copy;
}

void ExplicitBodies::constrain(int node, const NodeConstraint& constraint) {
  int& index = nodes_[node].constraint;
  if (index >= 0) {
    constraints_[index].constraint = constraint;
    return;
  }
  index = static_cast<int>(constraints_.size());
  constraints_.push_back({node, constraint, velocity(node) - constraint.allowed * velocity(node)});
}

void ExplicitBodies::add_body(const ElasticLaw& law, double density, std::span<const std::array<int, 4>> tets,
                              std::span<const RestElement> rest_elements, std::span<const Mat3> offsets, double limit,
                              std::span<const std::array<int, 6>> edges) {
  ExplicitBody body;
  body.law = {law.model, static_cast<float>(law.lambda), static_cast<float>(law.mu), 0};
  body.density = density;
  body.first_block = static_cast<int>(blocks_.size());
  body.blocks = static_cast<int>(tets.size() + kLanes - 1) / kLanes;
  blocks_.resize(blocks_.size() + body.blocks);
  block_bodies_.resize(blocks_.size(), static_cast<int>(bodies_.size()));
  const int unused = tets[0][0];
  for (int i = 0; i < body.blocks * kLanes; ++i) {
    ElementBlock& block = blocks_[body.first_block + i / kLanes];
    const int lane = i % kLanes;
    const bool used = i < static_cast<int>(tets.size());
    for (int corner = 0; corner < 4; ++corner) block.nodes[corner][lane] = used ? tets[i][corner] : unused;
    corners_.push_back(used ? tets[i] : std::array{unused, unused, unused, unused});
    for (int a = 0; a < 4; ++a) block.rotation[a][lane] = a == 3 ? 1.0F : 0.0F;
    for (int e = 0; e < 6; ++e) block.offset[e][lane] = block.strain[e][lane] = 0;
    block.volume[lane] = used ? static_cast<float>(rest_elements[i].volume) : 0.0F;
    block.stiffness[lane] = 1;
    for (int k = 0; k < 3; ++k)
      for (int a = 0; a < 3; ++a)
        block.gradients[k][a][lane] = used ? static_cast<float>(rest_elements[i].shape_gradients(a, k + 1)) : 0.0F;
    if (!used) continue;
    set_lane(block.offset, lane, offsets[i]);
  }
  quadratic_of_block_.resize(blocks_.size(), -1);
  if (edges.empty()) {
    relieve_slivers(law, density, rest_elements, limit, body);
  } else {
    add_quadratic_blocks(edges, body);
    body.frequency = highest_quadratic_frequency(law, density, rest_elements, tets, edges);
  }
  body.damping = 2 * kDampingRatio / body.frequency;
  bodies_.push_back(body);
}

void ExplicitBodies::set_strength_surface(const Material& material) {
  const FractureLaw& law = fracture_law(material);
  bodies_.back().law.strength_ratio = law.strength_ratio ? static_cast<float>(law.strength_ratio(material)) : 0;
}

void ExplicitBodies::relieve_slivers(const ElasticLaw& law, double density, std::span<const RestElement> rest_elements,
                                     double limit, ExplicitBody& body) {
  constexpr double kRounding = 1e-6;
  const std::vector<double> frequencies = element_frequencies(law, density, rest_elements);
  body.frequency = std::min(limit, std::ranges::max(frequencies));
  for (std::size_t i = 0; i < rest_elements.size(); ++i) {
    if (frequencies[i] <= (1 + kRounding) * body.frequency) continue;
    relieve(blocks_[body.first_block + i / kLanes], i % kLanes, std::pow(body.frequency / frequencies[i], 2));
    ++body.relieved;
  }
}

void ExplicitBodies::add_quadratic_blocks(std::span<const std::array<int, 6>> edges, const ExplicitBody& body) {
  for (int b = 0; b < body.blocks; ++b) {
    quadratic_of_block_[body.first_block + b] = static_cast<int>(quadratics_.size());
    block_of_quadratic_.push_back(body.first_block + b);
    QuadraticBlock& block = quadratics_.emplace_back();
    for (int lane = 0; lane < kLanes; ++lane) {
      const std::size_t tet = std::min(edges.size() - 1, static_cast<std::size_t>(b * kLanes + lane));
      for (int i = 0; i < 6; ++i) block.edges[i][lane] = edges[tet][i];
    }
    for (int v = 0; v < 4; ++v)
      for (int e = 0; e < 6; ++e) {
        block.strain[v][e] = block.rate[v][e] = broadcast(0);
        block.offset[v][e] = blocks_[body.first_block + b].offset[e];
      }
  }
}

void ExplicitBodies::set_corner_offsets(std::span<const CornerTensors> offsets) {
  const int first = quadratic_of_block_[bodies_.back().first_block];
  for (std::size_t i = 0; i < offsets.size(); ++i)
    for (int v = 0; v < 4; ++v)
      set_lane(quadratics_[first + i / kLanes].offset[v], static_cast<int>(i % kLanes), offsets[i][v]);
}

void ExplicitBodies::finish() {
  forces_.resize(4 * static_cast<std::size_t>(tet_slots()));
  viscous_works_.resize(blocks_.size());
  const auto each_corner = [&](auto use) {
    for (int slot = 0; slot < tet_slots(); ++slot) {
      if (blocks_[slot / kLanes].volume[slot % kLanes] == 0) continue;
      for (int c = 0; c < 4; ++c) use(corner(slot, c), 4 * slot + c);
    }
  };
  list_stars(each_corner, nodes_, stars_);
  list_edge_stars();
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const BlockLaw& law = bodies_[block_bodies_[b]].law;
    if (const int quadratic = quadratic_of_block_[b]; quadratic >= 0) {
      settle_quadratic_elements(law, blocks_[b], quadratics_[quadratic], displacements());
    } else {
      settle_elements(law, blocks_[b], &displacements_[0].value);
    }
  }
}

Mat3 ExplicitBodies::elastic_strain(int slot, const Mat3& strain) const {
  const ElementBlock& block = blocks_[slot / kLanes];
  const int lane = slot % kLanes;
  const auto& o = block.offset;
  Mat3 offset;
  offset << o[0][lane], o[3][lane], o[5][lane], o[3][lane], o[1][lane], o[4][lane], o[5][lane], o[4][lane], o[2][lane];
  return block.stiffness[lane] * (strain - offset);
}

double ExplicitBodies::stable_step(double courant) const {
  double step = std::numeric_limits<double>::infinity();
  for (const ExplicitBody& body : bodies_) {
    const double ratio = body.damping * body.frequency / 2;
    step = std::min(step, courant * 2 / body.frequency * (std::sqrt(1 + ratio * ratio) - ratio));
  }
  return step;
}

void ExplicitBodies::set_step(double dt) {
  dt_ = dt;
  follow_step();
  for (ExplicitBody& body : bodies_) body.last_viscosity = body.law.viscosity;
}

/// Sets viscosities for strains that change in a microstep.
void ExplicitBodies::follow_step() {
  for (ExplicitBody& body : bodies_) body.law.viscosity = static_cast<float>(body.damping / dt_);
}

void ExplicitBodies::compute_forces(bool finds_largest) {
  constexpr int kGrain = 256;  // 2,048 tets: fewer are done before another thread could start
  parallel_for(static_cast<int>(blocks_.size()), kGrain, [&](int begin, int end) {
    for (int b = begin; b < end; ++b) {
      const ExplicitBody& body = bodies_[block_bodies_[b]];
      Quad* forces = &forces_[4 * static_cast<std::size_t>(kLanes) * b].value;
      if (const int quadratic = quadratic_of_block_[b]; quadratic >= 0) {
        force_quadratic_elements(body.law, blocks_[b], quadratics_[quadratic], displacements(), forces,
                                 &edge_forces_[6 * static_cast<std::size_t>(kLanes) * quadratic].value,
                                 viscous_works_[b], body.last_viscosity, finds_largest);
      } else {
        force_elements(body.law, blocks_[b], &displacements_[0].value, forces, viscous_works_[b], body.last_viscosity,
                       finds_largest);
      }
    }
  });
  for (ExplicitBody& body : bodies_) body.last_viscosity = body.law.viscosity;
}

void ExplicitBodies::advance(double kick, std::vector<int>& flagged) {
  flagged.clear();
  follow_step();
  advance_nodes(kick * dt_, dt_, flagged);
  advance_edges(kick * dt_, dt_);
  for (int i = 0; i < static_cast<int>(constraints_.size()); ++i) hold(i, dt_);
}

void ExplicitBodies::kick(double fraction) {
  std::vector<int> flagged;
  advance_nodes(fraction * dt_, 0, flagged);
  advance_edges(fraction * dt_, 0);
  for (int i = 0; i < static_cast<int>(constraints_.size()); ++i) hold(i, 0);
}

/// Updates velocities with the forces of `kick`, positions with the velocities of `drift` [s].
void ExplicitBodies::advance_nodes(double kick, double drift, std::vector<int>& flagged) {
  double fastest = 0;
  lowest_ = highest_ = velocities_[0].value;
  for (int i = 0; i < node_count(); ++i) {
    const ExplicitNode& node = nodes_[i];
    const int* star = stars_.data() + node.first;
    Quad even = {}, odd = {}, largest = {};
    const auto add = [&](int entry, Quad& sum) {
      const Quad force = forces_[star[entry]].value;
      sum += force;
      largest = force > largest ? force : largest;
    };
    for (int e = 0; e + 1 < node.count; e += 2) add(e, even), add(e + 1, odd);
    if (node.count % 2 == 1) add(node.count - 1, even);
    if (largest[3] > node.threshold) flagged.push_back(i);
    WideQuad force = __builtin_convertvector(even + odd, WideQuad);
    force[3] = 0;
    WideQuad& moving = velocities_[i].value;
    moving += kick * (node.inverse_mass * force + accelerations_[i].value);
    lowest_ = moving < lowest_ ? moving : lowest_;
    highest_ = moving > highest_ ? moving : highest_;
    if (node.constraint < 0) displacements_[i].value += drift * moving;
    fastest = std::max(fastest, velocity(i).squaredNorm());
  }
  fastest_ = std::sqrt(fastest);
}

float ExplicitBodies::flagging_stress(int node) const {
  float largest = 0;
  for (const int entry : star(node)) largest = std::max(largest, forces_[entry].value[3]);
  return largest;
}

void ExplicitBodies::hold(int index, double drift) {
  ExplicitConstraint& held = constraints_[index];
  const Vec3 free = velocity(held.node);
  const Vec3 allowed = held.constraint.allowed * free + held.constraint.velocity;
  held.take((allowed - free) / nodes_[held.node].inverse_mass);
  velocities_[held.node].value = wide(allowed);
  displacements_[held.node].value += drift * velocities_[held.node].value;
}

void ExplicitBodies::part(int node, std::span<const int> copies, std::span<const std::vector<int>> stars) {
  int at = nodes_[node].first;
  for (std::size_t i = 0; i < stars.size(); ++i) {
    const int owner = i == 0 ? node : copies[i - 1];
    nodes_[owner].first = at;
    nodes_[owner].count = static_cast<int>(stars[i].size());
    for (const int entry : stars[i]) {
      stars_[at++] = entry;
      const int slot = entry / 4;
      blocks_[slot / kLanes].nodes[entry % 4][slot % kLanes] = corners_[slot][entry % 4] = owner;
      if (quadratic_of_block_[slot / kLanes] >= 0) parted_.push_back(slot);
    }
  }
}

void ExplicitBodies::push(int node, const Vec3& impulse) {
  const ExplicitNode& pushed = nodes_[node];
  Vec3 change = pushed.inverse_mass * impulse;
  if (pushed.constraint >= 0) {
    ExplicitConstraint& held = constraints_[pushed.constraint];
    const Vec3 allowed = held.constraint.allowed * change;
    held.take((allowed - change) / pushed.inverse_mass);
    change = allowed;
  }
  velocities_[node].value += wide(change);
}

Vec3 ExplicitBodies::displacement_by(int node, const Vec3& impulse, double time) const {
  const ExplicitNode& pushed = nodes_[node];
  const Vec3 displacement = time * pushed.inverse_mass * impulse;
  return pushed.constraint < 0 ? displacement : Vec3(constraints_[pushed.constraint].constraint.allowed * displacement);
}

double ExplicitBodies::mobility(int node, const Vec3& direction) const {
  const ExplicitNode& pushed = nodes_[node];
  if (pushed.constraint < 0) return pushed.inverse_mass;
  return pushed.inverse_mass * direction.dot(constraints_[pushed.constraint].constraint.allowed * direction);
}

}  // namespace griffith::explicit_dynamics
