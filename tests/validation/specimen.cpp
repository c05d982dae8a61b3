#include "tests/validation/specimen.h"

#include <stdexcept>

#include "sim/fracture/separation_tensor.h"
#include "sim/mesh/topology.h"
#include "sim/scene/scene_reader.h"
#include "sim/solver/static_solve.h"
#include "sim/world/phases.h"

namespace griffith::validation {

MeshLabel mesh_label(BoxPattern pattern, int cells) {
  constexpr std::array<const char*, 3> kNames = {"kuhn", "five_tet", "bcc"};
  return {kNames[static_cast<int>(pattern)], "n = " + std::to_string(cells)};
}

Scene validation_scene(const std::string& name) {
  return read_scene(std::string(GRIFFITH_SOURCE_DIR) + "/scenes/validation/" + name + ".json");
}

Specimen::Specimen(const Scene& scene) : world_(scene) { build_world(world_); }

void Specimen::deform(const std::function<Vec3(const Vec3&)>& map) {
  for (int node = 0; node < node_count(); ++node) world_.nodes.positions[node] = map(rest_position(node));
  update_elements(world_);
}

void Specimen::equilibrate() {
  const Material& material = world_.materials[0];
  std::vector<Vec3> loads;
  for (double mass : world_.nodes.masses) loads.push_back(mass * world_.scene.gravity);
  add_load_forces(world_, 0, loads);
  const ElasticLaw law = elastic_law(material);
  const auto state = [&](TetId tet, std::span<const Vec3> positions) {
    Corners corners;
    for (int i = 0; i < 4; ++i) corners.col(i) = positions[world_.mesh.tets[tet][i]];
    return element_state(law, element_deformation(law.model, world_.elements.rests[tet], corners));
  };
  const std::vector<TetId>& tets = world_.bodies[0].tets;
  const StaticProblem problem{.mesh = world_.mesh,
                              .tets = tets,
                              .rests = world_.elements.rests,
                              .law = law,
                              .masses = world_.nodes.masses,
                              .constraints = world_.nodes.constraints,
                              .loads = loads,
                              .evaluate = [&](std::span<const Vec3> positions, std::span<ElementState> states) {
                                for (TetId tet : tets) states[tet] = state(tet, positions);
                              }};
  if (!solve_static(problem, {}, world_.nodes.positions, world_.elements.states).converged)
    throw std::runtime_error(world_.scene.name + ": found no equilibrium");
  update_elements(world_);
}

std::vector<Vec3> Specimen::elastic_forces() const {
  std::vector<Vec3> sum(node_count(), Vec3::Zero());
  for (int tet = 0; tet < world_.mesh.tet_count(); ++tet) {
    const ElementState& state = world_.elements.states[tet];
    const Corners forces = nodal_forces(world_.elements.rests[tet], state.frame, state.stress);
    for (int i = 0; i < 4; ++i) sum[world_.mesh.tets[tet][i]] += forces.col(i);
  }
  return sum;
}

Separation Specimen::separation(int node) const {
  const SeparationInput input{world_.mesh, world_.elements.rests, world_.elements.states};
  const PrincipalValues principal =
      principal_values(separation_tensor(input, NodeId(node), world_.nodes.held[node] != 0));
  Separation separation{.normal = principal.directions.col(2)};
  separation.stress = separation_stress(input, NodeId(node), principal.values[2], separation.normal);
  return separation;
}

std::vector<int> Specimen::nodes_where(const std::function<bool(const Vec3&)>& condition) const {
  std::vector<int> nodes;
  for (int node = 0; node < node_count(); ++node)
    if (condition(rest_position(node))) nodes.push_back(node);
  return nodes;
}

}  // namespace griffith::validation
