#include <algorithm>
#include <array>
#include <cmath>

#include "app/picture/glyph_shape.h"
#include "app/picture/layer_picture.h"
#include "sim/elasticity/principal_stress.h"
#include "sim/geometry/convex_hull.h"
#include "sim/world/output/probes.h"
#include "ui/model/view_layers.h"

namespace griffith::app {
namespace {

/// Adds arrows at nodes for vectors of any unit, the largest one `reach` long.
void add_node_arrows(const ShownMesh& shown, std::span<const Vec3> vectors, const render::Rgb& color, bool pushing,
                     render::DrawScene& picture) {
  double largest = 0;
  for (const Vec3& vector : vectors)
    if (vector.allFinite()) largest = std::max(largest, vector.norm());
  const double reach = 1.5 * shown.sign_size * shown.view.glyph_scale;
  for (std::size_t i = 0; i < vectors.size() && largest > 0; ++i) {
    const Vec3 way = reach / largest * vectors[i];
    if (!shown.visible(shown.positions[i]) || way.norm() < 0.01 * reach) continue;
    add_arrow(picture.glyphs.arrows, pushing ? Vec3(shown.positions[i] - way) : shown.positions[i], way, 0.06 * reach,
              color);
  }
}

Vec3 contact_offset(const ShownMesh& shown, const ContactView& contact) {
  const BodyId body = contact.a.valid() ? contact.a : contact.b;
  return body.valid() ? shown.offsets[body] : Vec3::Zero();
}

void add_support(const ShownMesh& shown, std::size_t node, render::DrawScene& picture) {
  const NodeConstraint& constraint = shown.frame.nodes.constraints[node];
  const Vec3& place = shown.positions[node];
  const double size = 0.1 * shown.sign_size * shown.view.glyph_scale;
  if (constraint.is_held()) {
    picture.glyphs.boxes.push_back(
        {place.cast<float>(), (size * Mat3::Identity()).cast<float>(), sign_color::kSupport});
  } else {
    // The blocked directions are those that the projector removes: eigenvalue 0.
    const PrincipalValues allowed = principal_values(constraint.allowed);
    for (int i = 0; i < constraint.blocked; ++i)
      picture.glyphs.discs.push_back(disc(place, allowed.directions.col(i), 1.6 * size, sign_color::kSupport, 1));
  }
  if (!constraint.velocity.isZero(0))
    add_arrow(picture.glyphs.arrows, place, 8 * size * constraint.velocity.normalized(), 0.8 * size,
              sign_color::kVelocity);
}

Vec3 place_of(const PlacedProbe& probe, const ShownMesh& shown) {
  Vec3 sum = Vec3::Zero();
  for (const ProbedNode& node : probe.nodes)
    sum += node.weight * shown.positions[node_at(shown.frame.elements.tets, node.corner)];
  return sum;
}

}  // namespace

std::vector<LayerSymbol> contact_symbols(const ShownMesh& shown) {
  double largest = 0;
  for (const ContactView& contact : shown.frame.contacts) largest = std::max(largest, contact.impulse.norm());
  const double reach = 2 * shown.sign_size * shown.view.glyph_scale;
  std::vector<LayerSymbol> symbols;
  for (std::size_t i = 0; i < shown.frame.contacts.size(); ++i) {
    const ContactView& contact = shown.frame.contacts[i];
    const Vec3 place = contact.position + contact_offset(shown, contact);
    if (shown.visible(place))
      symbols.push_back({{ui::SymbolKind::contact, static_cast<int>(i)}, place, reach / largest * contact.impulse});
  }
  return symbols;
}

void add_contacts(const ShownMesh& shown, render::DrawScene& picture) {
  const double reach = 2 * shown.sign_size * shown.view.glyph_scale;
  for (const LayerSymbol& contact : contact_symbols(shown)) {
    picture.glyphs.balls.push_back(ball(contact.place, 0.04 * reach, sign_color::kImpulse));
    add_arrow(picture.glyphs.arrows, contact.place, contact.arm, 0.06 * reach, sign_color::kImpulse);
    add_arrow(picture.glyphs.arrows, contact.place, -contact.arm, 0.06 * reach, sign_color::kImpulse);
  }
}

std::vector<LayerSymbol> layer_symbols(const ShownMesh& shown) {
  std::vector<LayerSymbol> all;
  const auto add = [&](ViewLayer layer, std::vector<LayerSymbol> (*symbols)(const ShownMesh&)) {
    if (!ui::shows_layer(shown.view, layer)) return;
    const std::vector<LayerSymbol> added = symbols(shown);
    all.insert(all.end(), added.begin(), added.end());
  };
  add(ViewLayer::fracture_planes, fracture_plane_symbols);
  add(ViewLayer::contacts, contact_symbols);
  add(ViewLayer::stress_axes, stress_axis_symbols);
  add(ViewLayer::separation_axes, separation_axis_symbols);
  return all;
}

void add_body_frames(const ShownMesh& shown, render::DrawScene& picture) {
  constexpr render::Rgb kAxes[3] = {{0.86f, 0.22f, 0.20f}, {0.25f, 0.65f, 0.25f}, {0.20f, 0.40f, 0.85f}};
  for (const BodyView& body : shown.frame.bodies) {
    const Vec3 center = body.center_of_mass + shown.offsets[body.id];
    if (body.tets == 0 || !shown.visible(center)) continue;
    const double volume = body.mass / shown.frame.materials[body.scene_body].density;
    const double reach = 0.5 * std::cbrt(volume) * shown.view.glyph_scale;
    const Mat3 axes = body.orientation.toRotationMatrix();
    for (int axis = 0; axis < 3; ++axis)
      add_arrow(picture.glyphs.arrows, center, reach * axes.col(axis), 0.06 * reach, kAxes[axis]);
    picture.glyphs.balls.push_back(ball(center, 0.07 * reach, {0.95f, 0.95f, 0.95f}));
  }
}

void add_collision_shapes(const ShownMesh& shown, render::DrawScene& picture) {
  for (const BodyView& body : shown.frame.bodies) {
    const Vec3 center = body.center_of_mass + shown.offsets[body.id];
    if (!shown.visible(center)) continue;
    const render::Rgb color = id_color(body.id.index());
    for (const std::vector<Vec3>& part : body.collision_parts) {
      const ConvexHull hull = convex_hull(part);
      const auto corner = [&](int i) { return (center + body.orientation * hull.corners[i]).cast<float>().eval(); };
      for (const std::vector<int>& face : hull.faces)
        for (std::size_t i = 0; i < face.size(); ++i) {
          const int a = face[i], b = face[(i + 1) % face.size()];
          if (a < b) picture.lines.push_back({corner(a), corner(b), color, render::kNoId});
        }
    }
  }
}

void add_supports(const ShownMesh& shown, render::DrawScene& picture) {
  for (std::size_t i = 0; i < shown.positions.size(); ++i)
    if (!shown.frame.nodes.constraints[i].is_free() && shown.visible(shown.positions[i]))
      add_support(shown, i, picture);
  add_node_arrows(shown, shown.frame.nodes.reactions, sign_color::kSupport, true, picture);
}

void add_loads(const ShownMesh& shown, render::DrawScene& picture) {
  add_node_arrows(shown, shown.frame.nodes.load_forces, sign_color::kLoad, true, picture);
}

void add_probes(const ShownMesh& shown, render::DrawScene& picture) {
  const double size = 0.2 * shown.sign_size * shown.view.glyph_scale;
  for (const PlacedProbe& probe : shown.frame.probes) {
    if (probe.nodes.empty()) continue;
    const Vec3 place = place_of(probe, shown);
    if (!place.allFinite()) continue;  // in a hidden body
    picture.glyphs.balls.push_back(ball(place, size, sign_color::kProbe));
    for (const ProbedNode& node : probe.nodes)
      picture.points.push_back(
          {shown.positions[node_at(shown.frame.elements.tets, node.corner)].cast<float>(), 7, sign_color::kProbe});
    picture.labels.push_back({(place + 1.3 * size * Vec3::UnitY()).cast<float>(), probe.probe.name, 0.8f});
  }
}

void add_layers(const ShownMesh& shown, render::DrawScene& picture) {
  // By ViewLayer.
  static constexpr std::array kAdd = {add_stress_axes, add_stress_ellipsoids, add_separation_axes, add_velocities,
                                      add_contacts,    add_fracture_planes,   add_candidate_plane, add_element_forces,
                                      add_body_frames, add_collision_shapes,  add_supports,        add_loads,
                                      add_probes};
  for (const ViewLayer layer : shown.view.layers) kAdd[static_cast<std::size_t>(layer)](shown, picture);
}

}  // namespace griffith::app
