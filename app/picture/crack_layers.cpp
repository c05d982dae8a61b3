#include <algorithm>
#include <cmath>

#include "app/picture/glyph_shape.h"
#include "app/picture/layer_picture.h"
#include "sim/world/output/node_report.h"

namespace griffith::app {
namespace {

/// Returns the color of a crack plane, which cools down from the newest to the oldest.
render::Rgb age_color(double age, double newest, double oldest) {
  const float t = oldest > newest ? static_cast<float>(std::sqrt((age - newest) / (oldest - newest))) : 0;
  const render::Rgb fresh = {1.0f, 0.62f, 0.08f}, old = {0.36f, 0.26f, 0.52f};
  return {fresh.r + t * (old.r - fresh.r), fresh.g + t * (old.g - fresh.g), fresh.b + t * (old.b - fresh.b)};
}

/// Adds the edges of an element, slightly shrunken so that neighbors remain distinct.
void add_outline(const ShownMesh& shown, TetId tet, const render::Rgb& color, render::DrawScene& picture) {
  constexpr double kShrink = 0.93;
  const Vec3 middle = shown.centroid(tet);
  const auto corner = [&](int i) {
    return (middle + kShrink * (shown.positions[shown.frame.elements.tets[tet][i]] - middle)).cast<float>().eval();
  };
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b) picture.lines.push_back({corner(a), corner(b), color, tet.index()});
}

}  // namespace

std::vector<LayerSymbol> fracture_plane_symbols(const ShownMesh& shown) {
  const auto& events = shown.frame.crack_events;
  const std::size_t count = std::min(events.size(), static_cast<std::size_t>(shown.view.fracture_planes));
  const double radius = 0.45 * shown.element_size * shown.view.glyph_scale;
  std::vector<LayerSymbol> symbols;
  for (std::size_t i = events.size() - count; i < events.size(); ++i) {
    const Vec3 place = events[i].position + shown.offsets[events[i].body];
    if (shown.visible(place))
      symbols.push_back({{ui::SymbolKind::fracture_plane, static_cast<int>(i)}, place, radius * events[i].normal});
  }
  return symbols;
}

void add_fracture_planes(const ShownMesh& shown, render::DrawScene& picture) {
  const auto& events = shown.frame.crack_events;
  const auto shows = events.last(std::min(events.size(), static_cast<std::size_t>(shown.view.fracture_planes)));
  if (shows.empty()) return;
  const double radius = 0.45 * shown.element_size * shown.view.glyph_scale;
  const double oldest = shown.frame.time - shows.front().time, newest = shown.frame.time - shows.back().time;
  for (const LayerSymbol& plane : fracture_plane_symbols(shown)) {
    const CrackEvent& event = events[static_cast<std::size_t>(plane.symbol.index)];
    const render::Rgb color = age_color(shown.frame.time - event.time, newest, oldest);
    picture.glyphs.discs.push_back(disc(plane.place, event.normal, radius, color, 1));
    add_arrow(picture.glyphs.arrows, plane.place, 0.8 * radius * event.normal, 0.09 * radius, color);
  }
}

void add_candidate_plane(const ShownMesh& shown, render::DrawScene& picture) {
  if (!shown.chosen.valid()) return;
  const NodeReport report = node_report(shown.frame, shown.chosen);
  if (!report.strained) return;
  const Vec3 place = shown.positions[shown.chosen], normal = report.normal();
  const double radius = 0.9 * shown.element_size * shown.view.glyph_scale;
  picture.glyphs.discs.push_back(disc(place, normal, radius, sign_color::kPlane, 0.55f));
  add_arrow(picture.glyphs.arrows, place, 0.8 * radius * normal, 0.07 * radius, sign_color::kPlane);
  picture.glyphs.balls.push_back(ball(place, 0.07 * radius, sign_color::kPlane));
  for (const ElementContribution& element : report.elements)
    add_outline(shown, element.tet, element.above ? sign_color::kAbove : sign_color::kBelow, picture);
}

void add_element_forces(const ShownMesh& shown, render::DrawScene& picture) {
  constexpr int kMaxLabels = 5;
  if (!shown.chosen.valid()) return;
  const NodeReport report = node_report(shown.frame, shown.chosen);
  if (!report.strained) return;
  const Vec3 place = shown.positions[shown.chosen];
  double largest = 0;
  for (const ElementContribution& element : report.elements)
    largest = std::max({largest, element.force.tensile.norm(), element.force.compressive.norm()});
  const double reach = 1.1 * shown.element_size * shown.view.glyph_scale;
  int rank = 0;
  for (const ElementContribution& element : report.elements) {
    const Vec3 middle = shown.centroid(element.tet);
    picture.lines.push_back({place.cast<float>(), middle.cast<float>(), {0.25f, 0.27f, 0.30f}, element.tet.index()});
    if (largest > 0) {
      const auto add = [&](const Vec3& force, const render::Rgb& color) {
        add_arrow(picture.glyphs.arrows, middle, reach / largest * force, 0.05 * reach, color, element.tet.index());
      };
      add(element.force.tensile, sign_color::kTension);
      add(element.force.compressive, sign_color::kCompression);
    }
    if (++rank <= kMaxLabels) picture.labels.push_back({middle.cast<float>(), std::to_string(rank), 0});
  }
  picture.glyphs.balls.push_back(ball(place, 0.06 * reach, sign_color::kPlane));
}

}  // namespace griffith::app
