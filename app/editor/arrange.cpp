#include "app/editor/arrange.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editor/placed_surface.h"
#include "sim/core/error.h"
#include "ui/model/entry_choice.h"
#include "ui/model/region_outline.h"

namespace griffith::app {
using ui::EntryKind;
using ui::SceneEntry;

namespace {

constexpr char kAxisNames[] = "xyz";

void select_bodies(ui::EditorState& state, const Scene& scene, const std::vector<std::size_t>& bodies) {
  std::vector<SceneEntry> entries;
  for (const std::size_t body : bodies) entries.push_back({EntryKind::body, static_cast<int>(body)});
  ui::select_entries(state, scene, std::move(entries));
}

/// Makes one entry of the history of all bodies.
void set_bodies(ui::EditHistory& history, ui::EditorState& state, const std::string& label,
                std::vector<BodyDescription> bodies) {
  state.running = false;
  history.change(label, [&](Scene& scene) { scene.bodies = std::move(bodies); });
  history.finish();
}

/// Adds bodies under free names, as one entry of the history. Returns their indices.
std::vector<std::size_t> append_bodies(ui::EditHistory& history, ui::EditorState& state, const std::string& label,
                                       std::vector<BodyDescription> added) {
  std::vector<BodyDescription> bodies = history.scene().bodies;
  std::vector<std::size_t> copies;
  for (BodyDescription& body : added) {
    body.name = ui::free_name(bodies, body.name);
    copies.push_back(bodies.size());
    state.added_bodies.push_back(body.name);
    bodies.push_back(std::move(body));
  }
  set_bodies(history, state, label, std::move(bodies));
  return copies;
}

/// Returns the height of a body above what is below it [m]. What it would have to leave by more than half its height is
/// not below it.
double height_above_rest(const Scene& scene, const std::vector<ui::PlacedSurface>& surfaces,
                         const std::vector<std::size_t>& settled, std::size_t body) {
  const ui::PlacedSurface& own = surfaces[body];
  std::optional<double> height;
  const auto take = [&](double gap) {
    if (gap > -own.box.sizes().y() / 2 && (!height || gap < *height)) height = gap;
  };
  if (scene.ground) take(own.box.min().y() - scene.ground->height);
  for (const std::size_t other : settled)
    if (const std::optional<double> gap = ui::vertical_gap(own, surfaces[other])) take(*gap);
  if (height) return *height;
  throw InputError("bodies/" + scene.bodies[body].name, "has nothing below it to rest on",
                   "add a ground in the panel Scene, or move it above another body");
}

std::vector<ui::PlacedSurface> all_surfaces(const Scene& scene) {
  std::vector<ui::PlacedSurface> surfaces;
  for (const BodyDescription& body : scene.bodies) surfaces.push_back(placed_surface(body, scene.folder));
  return surfaces;
}

Vec3 mirrored(const Vec3& vector, int axis) {
  Vec3 result = vector;
  result[axis] = 0 - result[axis];  // avoids a negative zero
  return result;
}

/// Mirrors a direction of rotation, an angular velocity or angles about fixed axes.
Vec3 mirrored_rotation(const Vec3& rotation, int axis) {
  Vec3 result = rotation;
  for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) result[other] = 0 - result[other];
  return result;
}

Region mirrored(Region region, int axis) {
  if (auto* box = std::get_if<BoxRegion>(&region)) {
    const double low = box->minimum[axis];
    box->minimum[axis] = 0 - box->maximum[axis];
    box->maximum[axis] = 0 - low;
  } else if (auto* sphere = std::get_if<SphereRegion>(&region)) {
    sphere->center = mirrored(sphere->center, axis);
  } else if (auto* half = std::get_if<HalfSpaceRegion>(&region)) {
    half->point = mirrored(half->point, axis);
    half->normal = mirrored(half->normal, axis);
  }
  return region;
}

/// Throws InputError if a body has no mirror image that a scene can describe.
void require_mirror_image(const BodyDescription& body) {
  const bool from_file =
      std::holds_alternative<MeshFileShape>(body.shape) || std::holds_alternative<SurfaceShape>(body.shape);
  const auto lists_nodes = [](const auto& item) { return !ui::has_place(item.region); };
  const bool painted = std::ranges::any_of(body.supports, lists_nodes) || std::ranges::any_of(body.loads, lists_nodes);
  const bool strained = body.residual_stress && !std::holds_alternative<ParabolicStress>(*body.residual_stress);
  if (!from_file && !painted && !strained) return;
  throw InputError("bodies/" + body.name,
                   std::string("has no mirror image: ") + (from_file ? "its mesh comes from a file"
                                                           : painted ? "a support or load of it lists nodes"
                                                                     : "its residual strain has a direction"),
                   "duplicate it and place the copy by hand");
}

/// Returns the mirror image of a body of a symmetric shape across the plane at `place` [m] normal to the axis.
BodyDescription mirrored(BodyDescription body, int axis, double place) {
  require_mirror_image(body);
  body.position[axis] = 2 * place - body.position[axis];
  body.rotation_degrees = mirrored_rotation(body.rotation_degrees, axis);
  body.velocity = mirrored(body.velocity, axis);
  body.angular_velocity = mirrored_rotation(body.angular_velocity, axis);
  for (Support& support : body.supports) {
    support.region = mirrored(support.region, axis);
    support.normal = mirrored(support.normal, axis);
    support.velocity = mirrored(support.velocity, axis);
  }
  for (Load& load : body.loads) {
    load.region = mirrored(load.region, axis);
    for (Vec3* vector : {&load.force, &load.traction, &load.acceleration}) *vector = mirrored(*vector, axis);
  }
  return body;
}

double center_along(const Scene& scene, std::size_t body, int axis) {
  return placed_box(scene.bodies[body], scene.folder).center()[axis];
}

/// Throws InputError if the body lies in the mirror plane, so that its image would fill the same place.
void require_side(const Scene& scene, std::size_t body, int axis, double place) {
  constexpr double kRoundOff = 1e-9;  // [m]
  if (std::abs(center_along(scene, body, axis) - place) > kRoundOff) return;
  throw InputError("bodies/" + scene.bodies[body].name, "lies in the mirror plane, its image would fill the same place",
                   "move it to one side, or select the body in the middle last");
}

}  // namespace

bool drop_bodies(ui::EditHistory& history, ui::EditorState& state) {
  const Scene& scene = history.scene();
  const std::vector<std::size_t> selected = ui::selected_body_indices(state, scene);
  std::vector<std::size_t> dropped = selected, settled;
  std::vector<ui::PlacedSurface> surfaces = all_surfaces(scene);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (std::ranges::find(dropped, i) == dropped.end()) settled.push_back(i);
  std::ranges::stable_sort(dropped, {}, [&](std::size_t body) { return surfaces[body].box.min().y(); });
  std::vector<BodyDescription> bodies = scene.bodies;
  for (const std::size_t body : dropped) {
    const double height = height_above_rest(scene, surfaces, settled, body);
    bodies[body].position = ui::moved_place(bodies[body].position, Vec3(0, -height, 0));
    ui::move_surface(surfaces[body], Vec3(0, -height, 0));
    settled.push_back(body);
  }
  if (bodies == scene.bodies) return false;
  set_bodies(history, state, "Drop", std::move(bodies));
  select_bodies(state, history.scene(), selected);
  return true;
}

void array_bodies(ui::EditHistory& history, ui::EditorState& state, int count, const Vec3& offset) {
  const std::vector<std::size_t> selected = ui::selected_body_indices(state, history.scene());
  std::vector<BodyDescription> added;
  for (int i = 1; i < count; ++i)
    for (const std::size_t body : selected) {
      added.push_back(history.scene().bodies[body]);
      added.back().position = ui::moved_place(added.back().position, i * offset);
    }
  select_bodies(state, history.scene(), append_bodies(history, state, "Array", std::move(added)));
}

Vec3 side_by_side(const Scene& scene, const ui::EditorState& state) {
  Eigen::AlignedBox3d box;
  for (const std::size_t body : ui::selected_body_indices(state, scene))
    box.extend(placed_box(scene.bodies[body], scene.folder));
  return box.isEmpty() ? Vec3(1, 0, 0) : ui::moved_place(Vec3::Zero(), Vec3(box.sizes().x(), 0, 0));
}

void mirror_bodies(ui::EditHistory& history, ui::EditorState& state, int axis) {
  const Scene& scene = history.scene();
  std::vector<std::size_t> selected = ui::selected_body_indices(state, scene);
  std::optional<std::size_t> center;
  if (selected.size() > 1) {
    center = selected.back();
    selected.pop_back();
  }
  const double place = center ? center_along(scene, *center, axis) : 0;
  std::vector<BodyDescription> added;
  for (const std::size_t body : selected) {
    require_side(scene, body, axis, place);
    added.push_back(mirrored(scene.bodies[body], axis, place));
    added.back().position = ui::moved_place(added.back().position, Vec3::Zero());
  }
  std::vector<std::size_t> images =
      append_bodies(history, state, std::string("Mirror along ") + kAxisNames[axis], std::move(added));
  if (center) {  // so that the next mirror repeats both sides about the same body
    images.insert(images.begin(), selected.begin(), selected.end());
    images.push_back(*center);
  }
  select_bodies(state, history.scene(), images);
}

void align_bodies(ui::EditHistory& history, ui::EditorState& state, int axis) {
  const Scene& scene = history.scene();
  const std::vector<std::size_t> selected = ui::selected_body_indices(state, scene);
  const double place = center_along(scene, selected.back(), axis);
  std::vector<BodyDescription> bodies = scene.bodies;
  for (const std::size_t body : selected) {
    if (body == selected.back()) continue;
    const double way = place - center_along(scene, body, axis);
    bodies[body].position = ui::moved_place(bodies[body].position, way * Vec3::Unit(axis));
  }
  set_bodies(history, state, std::string("Align along ") + kAxisNames[axis], std::move(bodies));
  select_bodies(state, history.scene(), selected);
}

}  // namespace griffith::app
