#include "tests/validation/specimen.h"

#include <stdexcept>

#include "sim/fracture/separation_tensor.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/equilibrium.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"

namespace griffith::validation {

MeshLabel mesh_label(BoxPattern pattern, int cells) {
  constexpr std::array<const char*, 3> kNames = {"kuhn", "five_tet", "bcc"};
  return {kNames[static_cast<int>(pattern)], "n = " + std::to_string(cells)};
}

Scene validation_scene(const std::string& name) {
  return read_scene(std::string(GRIFFITH_SOURCE_DIR) + "/scenes/validation/" + name + ".json");
}

Specimen::Specimen(const Scene& scene) : world_(build_world(scene)) {}

void Specimen::deform(const std::function<Vec3(const Vec3&)>& map) {
  for (int node = 0; node < node_count(); ++node) world_.nodes.positions[node] = map(rest_position(node));
  update_elements(world_);
}

void Specimen::equilibrate() {
  world_.report = {};
  find_equilibrium(world_, 0, 0, [](const Body&) { return true; });
  if (world_.report.unconverged_solves > 0)
    throw std::runtime_error(world_.model->scene.name + ": found no equilibrium");
  update_elements(world_);
}

std::vector<Vec3> Specimen::elastic_forces() const {
  std::vector<Vec3> sum(node_count(), Vec3::Zero());
  for (int tet = 0; tet < world_.mesh->tet_count(); ++tet) {
    const ElementState& state = world_.elements.states[tet];
    const Corners forces = nodal_forces(world_.elements.rest_elements[tet], state.frame, state.stress);
    for (int i = 0; i < 4; ++i) sum[world_.mesh->tets[tet][i]] += forces.col(i);
  }
  return sum;
}

Separation Specimen::separation(int node) const {
  const SeparationInput input{world_.mesh->tets, world_.mesh->stars, world_.elements.rest_elements,
                              world_.elements.states, world_.nodes.constraints};
  const CandidatePlane plane = candidate_plane(input, NodeId(node), separation_tensor(input, NodeId(node)));
  return {plane.stress, plane.normal};
}

std::vector<int> Specimen::nodes_where(const std::function<bool(const Vec3&)>& condition) const {
  std::vector<int> nodes;
  for (int node = 0; node < node_count(); ++node)
    if (condition(rest_position(node))) nodes.push_back(node);
  return nodes;
}

}  // namespace griffith::validation
