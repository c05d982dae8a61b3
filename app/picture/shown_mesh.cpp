#include "app/picture/shown_mesh.h"

#include <algorithm>
#include <limits>

#include "app/picture/exaggeration.h"
#include "sim/world/output/node_report.h"

namespace griffith::app {
namespace {

/// Returns the center of mass of the pieces that are still connected, from which an exploded view moves pieces away.
Vec3 common_center(const Frame& frame) {
  Vec3 moment = Vec3::Zero();
  double mass = 0;
  for (const BodyView& body : frame.bodies) {
    if (!body.center_of_mass.allFinite()) continue;
    moment += body.mass * body.center_of_mass;
    mass += body.mass;
  }
  return mass > 0 ? Vec3(moment / mass) : Vec3(Vec3::Zero());
}

std::vector<Vec3> offsets_of(const Frame& frame, double explode, const HiddenBodies& hidden) {
  std::vector<Vec3> offsets(frame.bodies.size(), Vec3::Zero());
  const Vec3 center = explode == 0 ? Vec3(Vec3::Zero()) : common_center(frame);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (explode != 0) offsets[i] = explode * (frame.bodies[i].center_of_mass - center);
    if (hidden.contains(frame.bodies[i].scene_body)) offsets[i].setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return offsets;
}

/// Returns the size of symbols. In fine meshes they are larger than elements, in proportion to the largest body, but
/// small enough not to overlap.
double sign_size(const Frame& frame, double element_size) {
  constexpr double kShare = 1.0 / 30, kMaxElements = 4;
  std::vector<Eigen::AlignedBox3d> boxes(frame.materials.size());
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet)
    for (const NodeId corner : frame.elements.tets[tet])
      boxes[static_cast<std::size_t>(frame.bodies[frame.elements.bodies[tet]].scene_body)].extend(
          frame.nodes.rest_positions[corner]);
  double extent = 0;
  for (const Eigen::AlignedBox3d& box : boxes)
    if (!box.isEmpty()) extent = std::max(extent, box.diagonal().norm());
  return std::clamp(kShare * extent, element_size, kMaxElements * element_size);
}

}  // namespace

bool ShownMesh::visible(const Vec3& place) const {
  if (!place.allFinite()) return false;
  return !view.slice || place.dot(view.slice->normal.normalized()) <= view.slice->offset;
}

Vec3 ShownMesh::centroid(TetId tet) const {
  Vec3 sum = Vec3::Zero();
  for (NodeId corner : frame.elements.tets[tet]) sum += positions[corner];
  return sum / 4;
}

ShownMesh shown_mesh(const Frame& frame, const ViewSettings& view, const ui::Selection& selection,
                     const HiddenBodies& hidden) {
  ShownMesh shown{frame,
                  view,
                  offsets_of(frame, view.explode, hidden),
                  exaggerated_positions(frame, view.deformation_scale),
                  1,
                  1,
                  selection.node};
  if (view.explode != 0 || !hidden.empty()) {
    for (std::size_t i = 0; i < shown.positions.size(); ++i)
      shown.positions[i] += shown.offsets[shown.body_of(NodeId(static_cast<std::int64_t>(i)))];
  }
  if (view.layers.empty()) return shown;
  const auto rest_elements = frame.elements.rest_elements;
  shown.element_size = rest_elements.empty() ? 1 : mean_element_size(rest_elements);
  shown.sign_size = sign_size(frame, shown.element_size);
  if (!shown.chosen.valid()) shown.chosen = most_loaded_node(frame);
  if (shown.chosen.valid() && shown.is_hidden(shown.body_of(shown.chosen))) shown.chosen = {};
  return shown;
}

render::HalfSpace visible_half(const SlicePlane& slice) {
  return {slice.normal.normalized().cast<float>(), static_cast<float>(slice.offset)};
}

render::Rgb id_color(std::int32_t id) {
  constexpr double kGoldenRatio = 0.6180339887498949, kStart = 0.07;
  const double hue = std::fmod(kStart + kGoldenRatio * id, 1.0);
  const auto channel = [hue](double offset) {
    const double k = std::fmod(offset + 12 * hue, 12);
    return static_cast<float>(0.66 - 0.2 * std::clamp(std::min(k - 3, 9 - k), -1.0, 1.0));
  };
  return {channel(0), channel(8), channel(4)};
}

}  // namespace griffith::app
