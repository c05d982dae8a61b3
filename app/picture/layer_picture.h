#pragma once

#include "app/picture/shown_mesh.h"

namespace griffith::app {

/// Draws what the view's layers ask for besides the bodies.
void add_layers(const ShownMesh& shown, render::DrawScene& picture);

// The layers, by what they show. Sizes of signs go by the mean element size, those of nodes and places by the
// body's, and the view's glyph_scale.

/// stress_axes, stress_ellipsoids: of every element.
void add_stress_axes(const ShownMesh& shown, render::DrawScene& picture);
void add_stress_ellipsoids(const ShownMesh& shown, render::DrawScene& picture);
/// separation_axes, velocities: of the nodes.
void add_separation_axes(const ShownMesh& shown, render::DrawScene& picture);
void add_velocities(const ShownMesh& shown, render::DrawScene& picture);
/// fracture_planes, candidate_plane, element_forces.
void add_fracture_planes(const ShownMesh& shown, render::DrawScene& picture);
void add_candidate_plane(const ShownMesh& shown, render::DrawScene& picture);
void add_element_forces(const ShownMesh& shown, render::DrawScene& picture);
/// contacts, body_frames, collision_shapes, supports, loads, probes.
void add_contacts(const ShownMesh& shown, render::DrawScene& picture);
void add_body_frames(const ShownMesh& shown, render::DrawScene& picture);
void add_collision_shapes(const ShownMesh& shown, render::DrawScene& picture);
void add_supports(const ShownMesh& shown, render::DrawScene& picture);
void add_loads(const ShownMesh& shown, render::DrawScene& picture);
void add_probes(const ShownMesh& shown, render::DrawScene& picture);

}  // namespace griffith::app
