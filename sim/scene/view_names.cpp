#include "sim/scene/view_names.h"

#include <array>

namespace griffith {

std::span<const ViewLayerInfo> view_layers() {
  static constexpr std::array<ViewLayerInfo, 13> kLayers = {{
      {"stress_axes", "Principal stress axes",
       "A line along each axis of every element's stress: red tension, blue "
       "compression, with a length proportional to the stress."},
      {"stress_ellipsoids", "Stress ellipsoids",
       "Every element's stress as an ellipsoid along its axes: red where "
       "tension prevails, blue where compression does."},
      {"separation_axes", "Separation axes",
       "The eigenvectors of every node's separation tensor; the largest one, normal of "
       "the candidate plane, in the color of its utilization."},
      {"velocities", "Velocities", "An arrow at every surface node."},
      {"contacts", "Contacts", "A dot at each contact in the last step, and its impulse as an arrow."},
      {"fracture_planes", "Fracture planes", "The planes of the last cracks as discs with their normals."},
      {"candidate_plane", "Candidate plane",
       "The plane across which the selected node would separate, and its elements "
       "on either side; without a selection, at the most loaded node."},
      {"element_forces", "Element forces",
       "Forces of each element on the selected node: tensile red, compressive "
       "blue; without a selection, at the most loaded node."},
      {"body_frames", "Body frames", "Center of mass and axes of every piece."},
      {"collision_shapes", "Collision shapes", "The convex parts that represent every piece in contacts."},
      {"supports", "Supports", "Supported nodes: boxes fixed, discs sliding, arrows prescribed; and the reactions."},
      {"loads", "Loads", "The force of the loads on each node."},
      {"probes", "Probes", "Places of the probes."},
  }};
  return kLayers;
}

std::span<const std::string_view> element_style_names() {
  static constexpr std::array<std::string_view, 3> kNames = {"surface", "wireframe", "shrunken"};
  return kNames;
}

std::span<const std::string_view> picture_quality_names() {
  static constexpr std::array<std::string_view, 3> kNames = {"draft", "standard", "high"};
  return kNames;
}

std::span<const std::string_view> color_map_names() {
  static constexpr std::array<std::string_view, 5> kNames = {"automatic", "viridis", "coolwarm", "cividis", "heat"};
  return kNames;
}

}  // namespace griffith
