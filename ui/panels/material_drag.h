#pragma once

#include <optional>

#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Begins to drag a material if the mouse drags the last item.
void drag_material(Panel& panel, const Material& material);

/// Gives a material that is dropped on the last item to a body of the scene, or to all selected ones if it is among
/// them; highlights the item, unless `outlined` is false, while a material is over it. Does nothing without a body.
void drop_material(Panel& panel, std::optional<std::size_t> body, bool outlined = true);

}  // namespace griffith::ui
