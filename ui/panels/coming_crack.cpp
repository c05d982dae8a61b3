#include "sim/scene/region.h"
#include "ui/model/verdict.h"
#include "ui/panels/overlays.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/style.h"

namespace griffith::ui {
namespace {

/// Returns the mean distance from a node to the other corners of its tets [m].
double reach_of(const Frame& frame, NodeId node) {
  double sum = 0;
  int count = 0;
  for (const TetId tet : frame.nodes.stars[node])
    for (const NodeId corner : frame.elements.tets[tet])
      if (corner != node) {
        sum += (frame.nodes.positions[corner] - frame.nodes.positions[node]).norm();
        ++count;
      }
  return count > 0 ? sum / count : 0;
}

}  // namespace

void draw_coming_crack(const Panel& panel) {
  const Frame& frame = panel.input.frame;
  const std::optional<ComingCrack> crack = coming_crack(panel.state.stop, panel.state.selection.node, frame);
  if (!crack) return;
  const HalfSpaceRegion plane{frame.nodes.positions[crack->node], crack->normal};
  const double size = 2 * reach_of(frame, crack->node);
  draw_world_lines(panel, ImGui::GetWindowDrawList(), region_lines(plane, size), Pose{}, palette::kError);
}

}  // namespace griffith::ui
