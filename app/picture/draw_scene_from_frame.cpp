#include "app/picture/draw_scene_from_frame.h"

#include <algorithm>
#include <limits>

#include "app/picture/carried_points.h"
#include "app/picture/crack_dust.h"
#include "app/picture/crack_lines.h"
#include "app/picture/element_picture.h"
#include "app/picture/embedded_picture.h"
#include "app/picture/layer_picture.h"
#include "app/picture/natural_materials.h"
#include "app/picture/picture_options.h"
#include "app/picture/projectile_picture.h"
#include "app/picture/quantities.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/scene/quantities.h"
#include "ui/model/units.h"
#include "ui/model/view_layers.h"

namespace griffith::app {
namespace {

/// True if embedded surfaces can replace the tets.
bool shows_whole_bodies(const ViewSettings& view) {
  if (view.elements != ElementStyle::surface) return false;
  return !is_scalar(view.quantity) || place_of(*find_view_quantity(view.quantity)) != ValuePlace::face;
}

/// Selects the tets that are drawn, rather than the surfaces embedded in them.
class TetFilter {
 public:
  TetFilter(const ShownMesh& shown, const EmbeddedPieces& pieces)
      : shown_(shown),
        pieces_(pieces),
        embedded_(shown.view.splinters && pieces.mesh && shows_whole_bodies(shown.view)) {}

  bool shows_embedded() const { return embedded_; }
  /// True if a face without a neighbor is shown: for a body with a skin, the faces opened by cracks.
  bool shows(std::size_t tet, std::size_t face) const {
    const Frame& frame = shown_.frame;
    const BodyId body = frame.elements.bodies[tet];
    if (shown_.is_hidden(body)) return false;
    if (!embedded_) return true;
    const auto scene_body = static_cast<std::size_t>(frame.bodies[body].scene_body);
    const bool is_crack = !(frame.elements.first_surface[tet] >> face & 1);
    return !pieces_.splintered[scene_body] && (is_crack || !pieces_.skinned[scene_body]);
  }
  /// True if the shown faces enclose whole pieces; of pieces with a skin only a part is shown.
  bool shows_whole_pieces() const { return !embedded_ || pieces_.closed; }

 private:
  const ShownMesh& shown_;
  const EmbeddedPieces& pieces_;
  bool embedded_;
};

void color_plainly(render::DrawScene& picture, const Frame& frame, const EmbeddedPieces& pieces) {
  if (!picture.embedded.mesh) return;
  picture.embedded.piece_colors.assign(frame.splinters.splinters.size() + pieces.skin_parts.size(),
                                       picture.surface.color);
}

/// Returns the color of the quantity "body", "tet" or "splinter".
render::Rgb tet_color(const Frame& frame, std::int32_t tet, const ViewSettings& view) {
  return id_color(view.quantity == "tet" ? tet : frame.elements.bodies[tet].index());
}

void color_by_id(render::DrawScene& picture, const Frame& frame, const EmbeddedPieces& pieces,
                 const ViewSettings& view) {
  for (const std::int32_t tet : picture.surface.ids) picture.surface.colors.push_back(tet_color(frame, tet, view));
  if (!picture.embedded.mesh) return;
  for (std::size_t i = 0; i < frame.splinters.splinters.size(); ++i) {
    const std::int32_t owner = frame.splinters.splinters[i].owner.index();
    picture.embedded.piece_colors.push_back(view.quantity == "splinter" ? id_color(static_cast<std::int32_t>(i))
                                                                        : tet_color(frame, owner, view));
  }
  for (const SkinPart& part : pieces.skin_parts)
    picture.embedded.piece_colors.push_back(tet_color(frame, part.owner.index(), view));
}

void color_by_material(render::DrawScene& picture, const Frame& frame) {
  for (std::size_t i = 0; i < picture.surface.ids.size(); ++i) {
    const BodyId body = frame.elements.bodies[picture.surface.ids[i]];
    const Look look = picture.surface.flags[i] & render::kCrackFace ? Look::inside : Look::outside;
    const auto index = static_cast<std::size_t>(look_index(frame.bodies[body].scene_body, look));
    const render::EmbeddedMaterial& material = picture.embedded.materials[index];
    picture.surface.colors.push_back(material.color);
    picture.surface.matters.push_back(static_cast<std::int32_t>(index));
    if (material.clear_depth == 0) {
      picture.surface.flags[i] &= static_cast<std::uint8_t>(~render::kCrackFace);  // the inside has a color of its own
      continue;
    }
    picture.surface.flags[i] |= render::kClear;
    picture.surface.clear_depth = material.clear_depth;
  }
}

/// Returns the values with NaN in place of those without a color in the picture: of hidden bodies, and of gray ones.
QuantityValues colored_values(const ShownMesh& shown, QuantityValues values) {
  const ViewSettings& view = shown.view;
  if (view.elements != ElementStyle::wireframe) values = strained_values(shown.frame, view.quantity, std::move(values));
  const std::size_t per_tet = values.place == ValuePlace::tet ? 1 : 4;
  for (std::size_t i = 0; i < values.values.size(); ++i) {
    const BodyId body = values.place == ValuePlace::node
                            ? shown.body_of(NodeId(static_cast<std::int64_t>(i)))
                            : shown.frame.elements.bodies[TetId(static_cast<std::int64_t>(i / per_tet))];
    if (shown.is_hidden(body)) values.values[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return values;
}

/// Returns the style of scalars. `automatic`: the range if the view has none.
render::ScalarStyle scalar_style(const ShownMesh& shown, const QuantityValues& values, const Vec2& automatic) {
  constexpr int kBins = 48;
  const ViewSettings& view = shown.view;
  const bool parted = ui::parts_at_zero(view);
  Vec2 range = view.range.value_or(automatic);
  if ((view.symmetric || parted) && !view.range) range = symmetric_range(range);
  render::ScalarStyle style;
  const render::ColorMap one_sided =
      view.quantity == "utilization" ? render::ColorMap::heat : render::ColorMap::viridis;
  style.color_map = render::find_color_map(view.color_map).value_or(parted ? render::ColorMap::coolwarm : one_sided);
  style.minimum = static_cast<float>(range[0]);
  style.maximum = static_cast<float>(range[1]);
  style.histogram = histogram(colored_values(shown, values), range, kBins);
  style.has_nan =
      values.place != ValuePlace::face && std::ranges::any_of(values.values, [](float v) { return std::isnan(v); });
  const Quantity* quantity = find_view_quantity(view.quantity);
  style.quantity = quantity->label;
  style.unit = quantity->unit;
  return style;
}

/// True if materials have their natural colors.
bool shows_materials(const ViewSettings& view) { return view.quantity == "material" || view.quantity == "texture"; }

/// Color of bodies that move as a whole and so have no stress, darker than that of no stress in any map of colors.
constexpr render::Rgb kRigidColor = {0.33f, 0.35f, 0.38f};

/// Adds the edges of the wireframe, or the triangles of the bodies, to the picture.
void add_elements(const ShownMesh& shown, const TetFilter& filter, const QuantityValues* values, TetId selected,
                  render::DrawScene& picture) {
  constexpr double kShrink = 0.75;
  const ViewSettings& view = shown.view;
  const render::ScalarStyle style = picture.surface.scalar_style;
  if (view.elements == ElementStyle::wireframe) {
    picture.lines = wireframe(shown, values, style);
    return;
  }
  const bool shrunken = view.elements == ElementStyle::shrunken;
  std::vector<PictureTriangle> triangles =
      shrunken
          ? element_triangles(shown)
          : surface_triangles(shown.frame, [&](std::size_t tet, std::size_t face) { return filter.shows(tet, face); });
  if (!shrunken && !is_scalar(view.quantity)) picture.lines = crack_lines(triangles, shown);
  if (view.slice && !shrunken) {
    picture.visible = visible_half(*view.slice);
    const std::vector<PictureTriangle> caps = cap_triangles(shown);
    triangles.insert(triangles.end(), caps.begin(), caps.end());
  }
  picture.surface = surface_of(triangles, shown, shrunken ? kShrink : 1, selected);
  picture.surface.closed = shrunken || filter.shows_whole_pieces();
  picture.surface.scalar_style = style;
  picture.surface.opacity = static_cast<float>(view.opacity);
  if (values) add_scalars(triangles, shown.frame, *values, picture.surface);
  if (values && follows_from_strain(view.quantity) && show_rigid(triangles, shown.frame, picture.surface)) {
    picture.surface.color = kRigidColor;
    picture.surface.scalar_style.plain = "rigid";
  }
  if (shows_materials(view)) picture.surface.rests = rest_corners(triangles, shown.frame);
}

/// Adds colors for pictures without a scalar.
void add_colors(render::DrawScene& picture, const Frame& frame, const EmbeddedPieces& pieces,
                const ViewSettings& view) {
  if (shows_materials(view)) {
    picture.embedded.checker = view.quantity == "texture";
    color_by_material(picture, frame);
  } else if (view.quantity == "plain") {
    color_plainly(picture, frame, pieces);
  } else if (!is_scalar(view.quantity)) {
    color_by_id(picture, frame, pieces, view);
  }
}

render::EmbeddedSurface embedded_surface(const ShownMesh& shown, const EmbeddedPieces& pieces,
                                         std::span<const std::array<int, 4>> orders) {
  const Frame& frame = shown.frame;
  render::EmbeddedSurface surface;
  surface.mesh = pieces.mesh;
  surface.closed = pieces.closed;
  surface.points.reserve(shown.positions.size());
  // Objects embedded in hidden bodies collapse to a point.
  for (const Vec3& position : shown.positions)
    surface.points.push_back(position.allFinite() ? position.cast<float>().eval() : Eigen::Vector3f(0, 0, 0));
  surface.tets = ordered_tets(frame, orders);
  add_carriers(frame, surface.carriers);
  for (const SkinPart& part : pieces.skin_parts) surface.carriers.push_back(skin_carrier(frame, part).index());
  surface.opened.assign(frame.splinters.open_walls.begin(), frame.splinters.open_walls.end());
  return surface;
}

void mark_node(const ShownMesh& shown, NodeId node, render::DrawScene& picture) {
  const Eigen::Vector3f place = shown.positions[node].cast<float>();
  // The first of two points at one place is visible: the second is its rim.
  picture.points.push_back({place, 9, {1.0f, 0.55f, 0.10f}, render::kNoId});
  picture.points.push_back({place, 13, {0.10f, 0.11f, 0.13f}, render::kNoId});
  picture.labels.push_back({place, "node " + std::to_string(node.index()), 1.4f});
}

/// Adds labels with the exaggeration of the deformation above the bodies.
void add_deformation_labels(const ShownMesh& shown, render::DrawScene& picture) {
  const double scale = shown.view.deformation_scale;
  if (scale == 1) return;
  Eigen::AlignedBox3d box;
  for (const Vec3& place : shown.positions)
    if (shown.visible(place)) box.extend(place);
  if (box.isEmpty()) return;
  const Vec3 top(box.center().x(), box.max().y(), box.center().z());
  picture.labels.push_back({top.cast<float>(), "deformation × " + ui::format_quantity(scale, "-"), 1.4f});
}

void add_ground(const Scene& scene, render::DrawScene& picture) {
  if (!scene.ground) return;
  render::Ground ground;
  ground.height = static_cast<float>(scene.ground->height);
  picture.ground = ground;
}

EmbeddedPieces embedded_pieces(const Frame& frame, std::span<const std::array<int, 4>> orders, std::size_t scene_bodies,
                               std::span<const Skin> skins) {
  EmbeddedPieces pieces;
  pieces.splintered.resize(scene_bodies, 0);
  pieces.skinned.resize(scene_bodies, 0);
  for (const Splinter& splinter : frame.splinters.splinters) pieces.splintered[splinter.scene_body] = 1;
  for (const Skin& skin : skins) pieces.skinned[skin.scene_body] = 1;
  pieces.closed = skins.empty();
  auto mesh = std::make_shared<render::EmbeddedMesh>();
  add_splinters(frame, orders, pieces.skinned, *mesh);
  for (const Skin& skin : skins) {
    const auto parts = static_cast<int>(pieces.skin_parts.size());
    add_skin(frame, orders, skin, static_cast<int>(frame.splinters.parts.size()) + parts,
             static_cast<int>(frame.splinters.splinters.size()) + parts, *mesh);
    for (const SkinCorner& corner : skin.corners) pieces.skin_parts.push_back(corner.part);
  }
  if (!mesh->polygons.empty()) pieces.mesh = std::move(mesh);
  return pieces;
}

EmbeddedPieces natural_pieces(const Frame& frame, const EmbeddedDisplay& display) {
  const FrameWithShards sharded(frame, display.shards);
  return embedded_pieces(sharded.frame(), display.orders, display.authored.splintered.size(), display.shards.skins());
}

/// True if pieces are in their places, in natural colors, and nothing is explained.
bool shows_dust(const ViewSettings& view) {
  return view.dust && view.quality != PictureQuality::draft && !is_scalar(view.quantity) && view.quantity != "tet" &&
         shows_whole_bodies(view) && view.deformation_scale == 1 && view.explode == 0 && !view.slice &&
         view.layers.empty();
}

void add_dust(const Frame& frame, const Scene& scene, const HiddenBodies& hidden, render::DrawScene& picture) {
  CrackDust dust = crack_dust(frame, scene, hidden);
  picture.puffs = std::move(dust.puffs);
  picture.crumbs = std::move(dust.crumbs);
}

/// Parts of a frame to draw.
struct DrawRequest {
  const Scene& scene;
  const ViewSettings& view;
  const ui::Selection& selection;
  const HiddenBodies& hidden;
  std::optional<Vec2> range;
};

std::optional<QuantityValues> values_of(const Frame& frame, const ViewSettings& view) {
  return is_scalar(view.quantity) ? std::optional(linear_values(frame, *find_view_quantity(view.quantity)))
                                  : std::nullopt;
}

/// Draws a frame. `values`: values_of() the frame.
render::DrawScene drawn(const Frame& frame, const EmbeddedPieces& pieces, std::span<const std::array<int, 4>> orders,
                        const DrawRequest& request, std::optional<QuantityValues> values) {
  const auto& [scene, view, selection, hidden, range] = request;
  render::DrawScene result;
  const ShownMesh shown = shown_mesh(frame, view, selection, hidden);
  const TetFilter filter(shown, pieces);
  if (values && !frame.elements.tets.empty())
    result.surface.scalar_style =
        scalar_style(shown, *values, range ? *range : automatic_range(frame, view.quantity, *values));
  add_elements(shown, filter, values ? &*values : nullptr, selection.tet, result);
  if (filter.shows_embedded()) result.embedded = embedded_surface(shown, pieces, orders);
  result.embedded.materials = natural_materials(scene);
  result.embedded.selected_tet = selection.tet.index();
  add_colors(result, frame, pieces, view);
  if (values && filter.shows_embedded()) {
    if (values->place == ValuePlace::corner) values = quantity_values(frame, *find_view_quantity(view.quantity));
    result.embedded.scalars_per_point = values->place == ValuePlace::node;
    result.embedded.scalars = std::move(values->values);
  }
  add_layers(shown, result);
  if (selection.valid() && !shown.is_hidden(shown.body_of(selection.node))) mark_node(shown, selection.node, result);
  add_deformation_labels(shown, result);
  add_projectiles(frame, shows_materials(view), result);
  add_ground(scene, result);
  if (shows_dust(view)) add_dust(frame, scene, hidden, result);
  return result;
}

render::DrawScene drawn(const Frame& frame, const EmbeddedDisplay& display, const DrawRequest& request,
                        std::optional<QuantityValues> values) {
  if (display.shards.empty() || !shows_shards(request.view))
    return drawn(frame, display.authored, display.orders, request, std::move(values));
  const FrameWithShards sharded(frame, display.shards);
  return drawn(sharded.frame(), display.natural, display.orders, request, std::move(values));
}

}  // namespace

EmbeddedDisplay embedded_display(const Frame& frame, const Scene& scene, const Monitor& monitor,
                                 const KnownShards& known) {
  EmbeddedDisplay display;
  display.orders = summation_orders(frame);
  display.authored = embedded_pieces(frame, display.orders, scene.bodies.size(), make_skins(frame, scene));
  display.natural = display.authored;
  display.shards = Shards(frame, scene, monitor, known);
  if (!display.shards.empty()) display.natural = natural_pieces(frame, display);
  return display;
}

void follow_first_cracks(EmbeddedDisplay& display, const Frame& frame, const Scene& scene) {
  if (display.shards.follow(frame, scene)) display.natural = natural_pieces(frame, display);
}

render::DrawScene draw_scene_from_frame(const Frame& frame, const EmbeddedDisplay& display, const Scene& scene,
                                        const ViewSettings& view, const ui::Selection& selection,
                                        const std::optional<Vec2>& range, const HiddenBodies& hidden) {
  return drawn(frame, display, {scene, view, selection, hidden, range}, values_of(frame, view));
}

render::DrawScene draw_next_step(const Frame& frame, CopyOnWrite<EmbeddedDisplay>& display, SteadyRange& range,
                                 const Scene& scene, const ViewSettings& view, const ui::Selection& selection,
                                 const HiddenBodies& hidden) {
  std::optional<QuantityValues> values = values_of(frame, view);
  range.follow(frame, view.quantity, values ? &*values : nullptr);
  if (display->shards.are_behind(frame, scene)) follow_first_cracks(display.edit(), frame, scene);
  return drawn(frame, *display, {scene, view, selection, hidden, range.range()}, std::move(values));
}

}  // namespace griffith::app
