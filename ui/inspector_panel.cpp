#include <algorithm>
#include <cmath>

#include "ui/panels.h"
#include "ui/style.h"
#include "ui/units.h"
#include "ui/widgets.h"

namespace griffith::ui {
namespace {

/// The corner that is nearest to separating.
const NodeSeparation& most_loaded_corner(const Frame& frame, const std::array<NodeId, 4>& corners) {
  const auto worst = std::max_element(corners.begin(), corners.end(), [&](NodeId a, NodeId b) {
    return frame.separations[static_cast<std::size_t>(a.value)].margin <
           frame.separations[static_cast<std::size_t>(b.value)].margin;
  });
  return frame.separations[static_cast<std::size_t>(worst->value)];
}

void separation_rows(const Panel& panel, const NodeSeparation& separation, const Material& material) {
  const bool by_force = material.criterion == FractureCriterion::separation_force;
  const std::string_view unit = by_force ? "N" : "Pa";
  const double load = by_force ? separation.eigenvalue : separation.stress;
  value_row(panel, by_force ? "Separation force" : "Separation stress", format_quantity(load, unit), palette::kText);
  value_row(panel, "Resistance", format_quantity(separation.resistance, unit), palette::kText);
  value_row(panel, "Margin", format_quantity(separation.margin, "", 3),
            separation.margin > 0.9 ? palette::kWarning : palette::kText);
}

}  // namespace

void draw_inspector_panel(Panel& panel) {
  heading(panel, "Selection");
  const Frame& frame = panel.input.frame;
  const TetId tet = panel.state.selected_tet;
  if (!tet.valid() || static_cast<std::size_t>(tet.value) >= frame.tets.size()) {
    hint(panel, "Click an element in the view to inspect it.");
    return;
  }
  const auto t = static_cast<std::size_t>(tet.value);
  const BodyView& body = frame.bodies[static_cast<std::size_t>(frame.tet_bodies[t].value)];
  value_row(panel, "Element", std::to_string(tet.value), palette::kText);
  value_row(panel, "Piece", std::to_string(body.id.value) + ", " + format_quantity(body.mass, "kg", 3), palette::kText);
  const Mat3 deviator = frame.stresses[t] - frame.stresses[t].trace() / 3 * Mat3::Identity();
  value_row(panel, "Von Mises stress", format_quantity(std::sqrt(1.5) * deviator.norm(), "Pa"), palette::kText);
  separation_rows(panel, most_loaded_corner(frame, frame.tets[t]),
                  frame.materials[static_cast<std::size_t>(body.scene_body)]);
}

}  // namespace griffith::ui
