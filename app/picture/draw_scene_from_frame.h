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
#include "sim/world/frame.h"
#include "ui/model/selection.h"

namespace griffith::app {

/// What stands for tets in a picture: splinters, and the surfaces that bodies were made from.
struct EmbeddedPieces {
  std::shared_ptr<const render::EmbeddedMesh> mesh;  ///< null where no body has any
  std::vector<std::uint8_t> splintered;              ///< per scene body: 1 when it has splinters
  std::vector<std::uint8_t> skinned;  ///< per scene body: 1 when it has the surface that it was made from
  std::vector<SkinPart> skin_parts;   ///< numbered after the parts of splinters
  bool closed = false;  ///< what stands for a piece bounds it: a skin may have holes, and overhangs cracks
};

/// What a world's pictures show in place of tets, found in its first frame.
struct EmbeddedDisplay {
  EmbeddedPieces authored;                 ///< as the scene has it: for values, which belong to elements
  EmbeddedPieces natural;                  ///< with shards for bodies that have no splinters
  Shards shards;                           ///< none where `natural` is `authored`
  std::vector<std::array<int, 4>> orders;  ///< per tet: summation_orders() of the first frame
};

/// Throws InputError when a surface cannot be read, Cancelled when the monitor says so.
EmbeddedDisplay embedded_display(const Frame& frame, const Scene& scene, const Monitor& monitor = {});
/// To be called before a frame is drawn: some shards lie round the first crack.
void follow_first_cracks(EmbeddedDisplay& display, const Frame& frame, const Scene& scene);

/// The picture of a frame: bodies as view.elements says, coloured by view.quantity (natural colours for "material", one
/// for each body, element or splinter for "body", "tet" and "splinter"), cracks and the selection marked, the view's
/// layers, projectiles, ground. Bodies with splinters or a surface of their own show them if view.splinters says so,
/// and shards where there are no values to be shown. A triangle's id is its tet. `range`: of the colours where the view
/// leaves it automatic, as SteadyRange has it; none: what suits this frame alone.
render::DrawScene draw_scene_from_frame(const Frame& frame, const EmbeddedDisplay& display, const Scene& scene,
                                        const ViewSettings& view, const ui::Selection& selection,
                                        const std::optional<Vec2>& range = std::nullopt,
                                        const HiddenBodies& hidden = {});

/// The picture of a step that comes after those that `display` and `range` have followed: they follow it first.
render::DrawScene draw_next_step(const Frame& frame, CopyOnWrite<EmbeddedDisplay>& display, SteadyRange& range,
                                 const Scene& scene, const ViewSettings& view, const ui::Selection& selection = {},
                                 const HiddenBodies& hidden = {});

}  // namespace griffith::app
