#pragma once

#include <vector>

#include "app/picture/shown_mesh.h"
#include "ui/model/symbol.h"

namespace griffith::app {

/// Draws the view's layers.
void add_layers(const ShownMesh& shown, render::DrawScene& picture);

/// Symbol of a layer that can be picked, as it is drawn.
struct LayerSymbol {
  ui::Symbol symbol;
  Vec3 place;  ///< center [m]
  /// It extends from place − arm to place + arm [m]; for a plane its normal, of the length of its radius.
  Vec3 arm;
  double value = 0;  ///< principal value of an axis [Pa] or [N]
};
/// Returns the symbols of the view's layers that can be picked.
std::vector<LayerSymbol> layer_symbols(const ShownMesh& shown);
std::vector<LayerSymbol> fracture_plane_symbols(const ShownMesh& shown);
std::vector<LayerSymbol> contact_symbols(const ShownMesh& shown);
std::vector<LayerSymbol> stress_axis_symbols(const ShownMesh& shown);
std::vector<LayerSymbol> separation_axis_symbols(const ShownMesh& shown);

// Layers. Symbols of elements scale with the mean element size, those of nodes and points with the body's size, all
// with the view's glyph_scale.

/// Adds stress_axes and stress_ellipsoids of every element.
void add_stress_axes(const ShownMesh& shown, render::DrawScene& picture);
void add_stress_ellipsoids(const ShownMesh& shown, render::DrawScene& picture);
/// Adds separation_axes and velocities of the nodes.
void add_separation_axes(const ShownMesh& shown, render::DrawScene& picture);
void add_velocities(const ShownMesh& shown, render::DrawScene& picture);
/// Adds fracture_planes, candidate_plane and element_forces.
void add_fracture_planes(const ShownMesh& shown, render::DrawScene& picture);
void add_candidate_plane(const ShownMesh& shown, render::DrawScene& picture);
void add_element_forces(const ShownMesh& shown, render::DrawScene& picture);
/// Adds contacts, body_frames, collision_shapes, supports, loads and probes.
void add_contacts(const ShownMesh& shown, render::DrawScene& picture);
void add_body_frames(const ShownMesh& shown, render::DrawScene& picture);
void add_collision_shapes(const ShownMesh& shown, render::DrawScene& picture);
void add_supports(const ShownMesh& shown, render::DrawScene& picture);
void add_loads(const ShownMesh& shown, render::DrawScene& picture);
void add_probes(const ShownMesh& shown, render::DrawScene& picture);

}  // namespace griffith::app
