#include "app/editor/holding_edits.h"

#include "app/editor/thickness.h"

namespace griffith::app {

void apply_strength(ui::EditHistory& history, const HoldingFound& found) {
  history.change("Apply strength", [&](Scene& scene) {
    scene.bodies[static_cast<std::size_t>(found.run.scene_body)].material =
        stronger(found.run.material, found.answer.strength.holds);
  });
  history.finish();
}

void apply_speed(ui::EditHistory& history, const HoldingFound& found) {
  const RunToCrack slow = slowed(found.run, found.answer.speed.value().holds);
  history.change("Apply speed", [&](Scene& scene) {
    scene.projectiles = shots_of(slow);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      scene.bodies[i].velocity = slow.scene.bodies[i].velocity;
      scene.bodies[i].angular_velocity = slow.scene.bodies[i].angular_velocity;
    }
  });
  history.finish();
}

void apply_thickness(ui::EditHistory& history, const HoldingFound& found) {
  history.change("Apply thickness", [&](Scene& scene) {
    BodyDescription& body = scene.bodies[static_cast<std::size_t>(found.run.scene_body)];
    body = thickened(body, found.answer.thickness.value().holds, scene.gravity);
  });
  history.finish();
}

}  // namespace griffith::app
