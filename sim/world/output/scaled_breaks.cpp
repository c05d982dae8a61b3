#include "sim/world/output/scaled_breaks.h"

#include <map>

namespace griffith {

std::vector<ScaledBreak> scaled_breaks(const Frame& frame) {
  std::map<int, ScaledBreak> by_scene_body;
  for (const BodyView& body : frame.bodies) {
    if (!body.broke_scaled || body.tets == 0) continue;
    ScaledBreak& found = by_scene_body[body.scene_body];
    found.scene_body = body.scene_body;
    ++found.pieces;
    if (found.pieces == 1 || body.broke_scaled->factor < found.least.factor) found.least = *body.broke_scaled;
  }
  std::vector<ScaledBreak> breaks;
  for (const auto& [scene_body, found] : by_scene_body) breaks.push_back(found);
  return breaks;
}

}  // namespace griffith
