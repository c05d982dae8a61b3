#include <algorithm>
#include <cmath>

#include "app/picture/glyph_shape.h"
#include "app/picture/layer_picture.h"
#include "app/shared/quantile.h"
#include "sim/elasticity/principal_stress.h"

namespace griffith::app {
namespace {

constexpr double kTypical = 0.95;  // quantile represented by a symbol of normal size

/// An element with its principal stresses.
struct StressedTet {
  TetId tet;
  Vec3 center;
  PrincipalValues stress;
};

/// All visible elements, and a large stress among them [Pa].
struct StressField {
  std::vector<StressedTet> tets;
  double typical = 0;
};

StressField stress_field(const ShownMesh& shown) {
  StressField field;
  std::vector<double> sizes;
  for (std::size_t i = 0; i < shown.frame.elements.tets.size(); ++i) {
    const TetId tet(static_cast<std::int64_t>(i));
    const Mat3& stress = shown.frame.elements.stresses[i];
    const Vec3 center = shown.centroid(tet);
    if (stress.isZero(0) || !stress.allFinite() || !shown.visible(center)) continue;
    field.tets.push_back({tet, center, principal_values(stress)});
    sizes.push_back(field.tets.back().stress.values.cwiseAbs().maxCoeff());
  }
  field.typical = quantile(finite(std::move(sizes)), kTypical);
  return field;
}

const render::Rgb& sign_of(double stress) { return stress > 0 ? sign_color::kTension : sign_color::kCompression; }

/// Returns the color of the largest eigenvector: pale far from fracture, red at the limit.
render::Rgb utilization_color(double utilization) {
  return render::color_map_color(render::ColorMap::coolwarm,
                                 static_cast<float>(0.5 + 0.5 * std::clamp(utilization, 0.0, 1.0)));
}

std::vector<std::uint8_t> surface_nodes(const Frame& frame) {
  std::vector<std::uint8_t> on_surface(frame.nodes.positions.size(), 0);
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet)
    for (std::size_t face = 0; face < 4; ++face)
      if (!frame.elements.neighbors[tet][face].valid())
        for (const int corner : kTetFaces[face]) on_surface[frame.elements.tets[tet][corner]] = 1;
  return on_surface;
}

}  // namespace

std::vector<LayerSymbol> stress_axis_symbols(const ShownMesh& shown) {
  const StressField field = stress_field(shown);
  const double reach = 0.5 * shown.element_size * shown.view.glyph_scale;
  std::vector<LayerSymbol> symbols;
  for (const StressedTet& tet : field.tets)
    for (int axis = 0; axis < 3; ++axis) {
      const double stress = tet.stress.values[axis];
      const Vec3 arm = std::min(std::abs(stress) / field.typical, 1.5) * reach * tet.stress.directions.col(axis);
      symbols.push_back({{ui::SymbolKind::stress_axis, tet.tet.index(), axis}, tet.center, arm, stress});
    }
  return symbols;
}

void add_stress_axes(const ShownMesh& shown, render::DrawScene& picture) {
  for (const auto& [symbol, place, arm, stress] : stress_axis_symbols(shown))
    picture.lines.push_back({(place - arm).cast<float>(), (place + arm).cast<float>(), sign_of(stress), symbol.index});
}

void add_stress_ellipsoids(const ShownMesh& shown, render::DrawScene& picture) {
  constexpr double kThinnest = 0.08;  // fraction of the longest axis, else it would be invisible
  const StressField field = stress_field(shown);
  const double reach = 0.3 * shown.element_size * shown.view.glyph_scale;
  for (const StressedTet& tet : field.tets) {
    const double largest = tet.stress.values.cwiseAbs().maxCoeff();
    const double prevailing =
        tet.stress.values[2] > -tet.stress.values[0] ? tet.stress.values[2] : tet.stress.values[0];
    const double size = std::min(largest / field.typical, 1.5) * reach;
    const Vec3 axes = (tet.stress.values.cwiseAbs() / largest).cwiseMax(kThinnest) * size;
    picture.glyphs.balls.push_back({tet.center.cast<float>(),
                                    (tet.stress.directions * axes.asDiagonal()).eval().cast<float>(),
                                    sign_of(prevailing), 1, tet.tet.index()});
  }
}

std::vector<LayerSymbol> separation_axis_symbols(const ShownMesh& shown) {
  const Frame& frame = shown.frame;
  std::vector<LayerSymbol> symbols;
  std::vector<double> sizes;
  for (const NodeSeparation& separation : frame.nodes.separations)
    if (!separation.tensor.isZero(0)) sizes.push_back(separation.tensor.norm());
  const double typical = quantile(finite(std::move(sizes)), kTypical),
               reach = 0.5 * shown.element_size * shown.view.glyph_scale;
  for (std::size_t i = 0; i < frame.nodes.separations.size(); ++i) {
    const NodeSeparation& separation = frame.nodes.separations[i];
    const Vec3& place = shown.positions[i];
    if (separation.tensor.isZero(0) || !separation.tensor.allFinite() || !shown.visible(place)) continue;
    const PrincipalValues principal = principal_values(separation.tensor);
    for (int axis = 0; axis < 3; ++axis) {
      const double value = principal.values[axis];
      const Vec3 arm = std::min(std::abs(value) / typical, 1.5) * reach * principal.directions.col(axis);
      symbols.push_back({{ui::SymbolKind::separation_axis, static_cast<int>(i), axis}, place, arm, value});
    }
  }
  return symbols;
}

void add_separation_axes(const ShownMesh& shown, render::DrawScene& picture) {
  const double thickness = 0.06 * shown.element_size * shown.view.glyph_scale;
  for (const auto& [symbol, place, arm, value] : separation_axis_symbols(shown)) {
    const double utilization = shown.frame.nodes.separations[static_cast<std::size_t>(symbol.index)].utilization;
    if (symbol.axis == 2 && value > 0) {
      add_arrow(picture.glyphs.arrows, place, arm, thickness, utilization_color(utilization));
      add_arrow(picture.glyphs.arrows, place, -arm, thickness, utilization_color(utilization));
    } else {
      picture.lines.push_back(
          {(place - arm).cast<float>(), (place + arm).cast<float>(), sign_of(value), render::kNoId});
    }
  }
}

void add_velocities(const ShownMesh& shown, render::DrawScene& picture) {
  const Frame& frame = shown.frame;
  const std::vector<std::uint8_t> on_surface = surface_nodes(frame);
  std::vector<double> speeds;
  for (std::size_t i = 0; i < on_surface.size(); ++i)
    if (on_surface[i]) speeds.push_back(frame.nodes.velocities[i].norm());
  const double typical = quantile(finite(std::move(speeds)), kTypical);
  if (!(typical > 0)) return;
  const double reach = 1.2 * shown.element_size * shown.view.glyph_scale;
  for (std::size_t i = 0; i < on_surface.size(); ++i) {
    if (!on_surface[i] || !shown.visible(shown.positions[i])) continue;
    const Vec3& velocity = frame.nodes.velocities[i];
    const double length = std::min(velocity.norm() / typical, 2.0) * reach;
    if (length < 0.02 * reach) continue;
    add_arrow(picture.glyphs.arrows, shown.positions[i], length * velocity.normalized(), 0.05 * reach,
              sign_color::kVelocity);
  }
}

}  // namespace griffith::app
