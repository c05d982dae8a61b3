#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

// Region of the active support, load or probe, at the start of the simulation, for which scenes define it.

/// Lets the mouse drag the faces of a box and the surface of a sphere. Call it after the item that the picture fills.
/// True if the region takes the mouse.
bool drag_region(Panel& panel);

/// Draws the outline of the region over the picture, with its grips.
void draw_region(Panel& panel);

// Region of the active support, load or probe, painted on its body at the start of the simulation.

/// Lets the mouse paint nodes, or erase them with Ctrl, while painting is on; a drag that begins off the body rotates
/// the view as usual. Call it after the item that the picture fills. True if the brush takes the mouse.
bool paint_region(Panel& panel);

/// Draws the nodes of a painted region over the picture, and the brush.
void draw_painted_region(Panel& panel);

/// Frames four views and names them; the names of all but the camera's open their settings.
void draw_view_names(Panel& panel);

/// Draws a dark rounded card behind text over the picture.
void draw_card(ImDrawList* list, ImVec2 low, ImVec2 high, float scale);

/// Returns the height of the card at the top that says why the simulation stopped; 0 without one [pixels].
float stop_card_height(const Panel& panel);

/// Draws cards with the limits of the shown result below the upper left corner of the view: scaled impacts, overlaps,
/// missed convergence. Their tooltips say what to do.
void draw_view_warnings(Panel& panel, ImVec2 corner);

/// Draws the plane across which the selected node cracks in the next step, if the simulation stopped before that.
void draw_coming_crack(const Panel& panel);
/// Marks the picked symbol of a layer.
void draw_symbol(const Panel& panel);

/// Lets the mouse move and rotate the selected entries if the gizmo is shown and the simulation is at its start. An
/// arrow or plane moves all of them, a ring rotates the active one. Call it after the item that the picture fills. True
/// if the gizmo takes the mouse.
bool drag_gizmo(Panel& panel);

/// Draws the gizmo over the picture.
void draw_gizmo(Panel& panel);

/// Aims while the right button is held in the view, which was drawn last. Releasing it fires, Escape cancels. `cursor`:
/// position of the mouse in the view.
void aim_shot(Panel& panel, const Vec2& cursor);

/// Draws the predicted path of the aimed shot and its hit.
void draw_aim(const Panel& panel);

/// Lets the left button grab a piece at `cursor`, the position of the mouse in the view, and drag it while the tool is
/// on. Escape lets go. Call it after the item that the picture fills. True if the grab takes the mouse.
bool drag_piece(Panel& panel, const Vec2& cursor);

/// Draws the spring of the present grab from the piece to its target, with its force.
void draw_grab(const Panel& panel);

/// Draws the last push for some steps, and what a click would do to the piece below the mouse while the tool is on.
void draw_push(Panel& panel);

/// Gives a material that is dropped on the picture, the item drawn last, to the body below the mouse.
void drop_material_on_view(Panel& panel);

/// Tints the bodies that would get the dragged material.
void draw_material_target(Panel& panel);

/// Draws the compared branch over the picture in the view, right of a border that can be dragged or as a ghost, with
/// the names of both branches and their difference.
void draw_comparison(Panel& panel);

}  // namespace griffith::ui
