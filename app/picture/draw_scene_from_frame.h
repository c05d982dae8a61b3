#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/picture/shards.h"
#include "app/picture/shown_mesh.h"
#include "app/picture/skin.h"
#include "app/picture/steady_range.h"
#include "renderer/draw_scene.h"
#include "sim/core/copy_on_write.h"
#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"
#include "ui/model/selection.h"

namespace griffith::app {

/// Surfaces embedded in tets that replace them in a picture: splinters and original surfaces of bodies.
struct EmbeddedPieces {
  std::shared_ptr<const render::EmbeddedMesh> mesh;  ///< null if no body has any
  std::vector<std::uint8_t> splintered;              ///< per scene body: 1 if it has splinters
  std::vector<std::uint8_t> skinned;                 ///< per scene body: 1 if it has its original surface
  std::vector<SkinPart> skin_parts;                  ///< numbered after the parts of splinters
  bool closed = false;  ///< true if the surfaces enclose each piece; a skin may have holes, and overhangs cracks
};

/// Embedded surfaces of a world's pictures, found in its first frame.
struct EmbeddedDisplay {
  EmbeddedPieces authored;                 ///< surfaces of the scene alone: for values, which belong to elements
  EmbeddedPieces natural;                  ///< with shards for bodies that have no splinters
  Shards shards;                           ///< none if `natural` equals `authored`
  std::vector<std::array<int, 4>> orders;  ///< per tet: summation_orders() of the first frame
};

/// Makes them, except for shards of unchanged bodies in `known`. Throws InputError if a surface cannot be read,
/// Cancelled by the monitor.
EmbeddedDisplay embedded_display(const Frame& frame, const Scene& scene, const Monitor& monitor = {},
                                 const KnownShards& known = {});
/// Updates the shards around the first crack; call it before a frame is drawn.
void follow_first_cracks(EmbeddedDisplay& display, const Frame& frame, const Scene& scene);

/// Returns the picture of a frame. Bodies are drawn in the style view.elements, colored by view.quantity: natural
/// colors for "material", one for each body, element or splinter for "body", "tet" and "splinter". Cracks and the
/// selection are marked; the view's layers, projectiles and ground are added. Bodies with splinters or a surface of
/// their own show them if view.splinters is set, and shards if no values are shown. A triangle's id is its tet.
/// `range`: range of the colors if the view leaves it automatic, as SteadyRange gives it; none: from this frame alone.
render::DrawScene draw_scene_from_frame(const Frame& frame, const EmbeddedDisplay& display, const Scene& scene,
                                        const ViewSettings& view, const ui::Selection& selection,
                                        const std::optional<Vec2>& range = std::nullopt,
                                        const HiddenBodies& hidden = {});

/// Returns the picture of the step after those that `display` and `range` have followed, and updates both.
render::DrawScene draw_next_step(const Frame& frame, CopyOnWrite<EmbeddedDisplay>& display, SteadyRange& range,
                                 const Scene& scene, const ViewSettings& view, const ui::Selection& selection = {},
                                 const HiddenBodies& hidden = {});

}  // namespace griffith::app
