#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ui/number_slider.h"
#include "ui/panels.h"

namespace griffith::ui {
namespace {

/// A shape that the tool can fire, and its name in the list.
struct Choice {
  std::string name;
  std::optional<ProjectileShape> shape;
};

/// Spheres, boxes, and the hulls that the scene's own bursts are.
std::vector<Choice> choices(const Scene& scene) {
  std::vector<Choice> all = {{"Sphere", std::nullopt}, {"Box", BoxProjectile{}}};
  for (std::size_t i = 0; i < scene.projectiles.size(); ++i)
    if (const auto& shape = scene.projectiles[i].shape; shape && !std::holds_alternative<BoxProjectile>(*shape))
      all.push_back({"Hull of burst " + std::to_string(i + 1), shape});
  return all;
}

std::string name_of(const std::vector<Choice>& all, const std::optional<ProjectileShape>& shape) {
  if (!shape) return "Sphere";
  if (std::holds_alternative<BoxProjectile>(*shape)) return "Box";
  for (const Choice& choice : all)
    if (choice.shape == shape) return choice.name;
  return "Hull";
}

void shape_rows(Panel& panel, ProjectileBurst& shot) {
  const std::vector<Choice> all = choices(panel.history.scene());
  std::vector<std::string> names;
  for (const Choice& choice : all) names.push_back(choice.name);
  const int chosen = combo_row(panel, "projectile/shape", "Shape", names, name_of(all, shot.shape));
  if (chosen >= 0) shot.shape = all[static_cast<std::size_t>(chosen)].shape;
  if (!shot.shape) number_slider(panel, {"projectile/radius", "Radius", "m", 5e-3, 5, true}, shot.radius);
  if (!shot.shape) return;
  if (auto* box = std::get_if<BoxProjectile>(&*shot.shape)) {
    number_slider(panel, {"projectile/width", "Width", "m", 5e-3, 5, true}, box->size.x());
    number_slider(panel, {"projectile/height", "Height", "m", 5e-3, 5, true}, box->size.y());
    number_slider(panel, {"projectile/depth", "Depth", "m", 5e-3, 5, true}, box->size.z());
  }
  constexpr std::array kTurns = {"projectile/turn_x", "projectile/turn_y", "projectile/turn_z"};
  constexpr std::array kLabels = {"Turn about x", "Turn about y", "Turn about z"};
  for (int i = 0; i < 3; ++i)
    number_slider(panel, {kTurns[static_cast<std::size_t>(i)], kLabels[static_cast<std::size_t>(i)], "°", -180, 180},
                  shot.rotation_degrees[i]);
}

/// What the scene's burst says by a density is tuned as one: the mass then follows the size.
void mass_rows(Panel& panel, ProjectileBurst& shot) {
  constexpr double kDensityOfSteel = 7850;
  if (shot.density) {
    number_slider(panel, {"projectile/density", "Density", "kg/m³", 1, 3e4, true}, *shot.density);
  } else {
    number_slider(panel, {"projectile/mass", "Mass", "kg", 1e-3, 1e5, true}, shot.mass);
  }
  bool by_density = shot.density.has_value();
  if (!checkbox(panel, "projectile/by_density", "Mass by density", by_density)) return;
  shot.density = by_density ? std::optional(kDensityOfSteel) : std::nullopt;
}

}  // namespace

void draw_projectile_panel(Panel& panel) {
  heading(panel, "Projectile");
  ProjectileBurst& shot = panel.state.shot;
  shape_rows(panel, shot);
  number_slider(panel, {"projectile/speed", "Speed", "m/s", 0.1, 1000, true}, shot.speed);
  mass_rows(panel, shot);
  integer_row(panel, "projectile/count", "Burst", shot.count, 1, 100);
  if (shot.count > 1) {
    number_slider(panel, {"projectile/interval", "Interval", "s", 1e-2, 5, true}, shot.interval);
  }
  hint(panel, "Right-click in the view, or press F, to fire at the cursor.");
}

}  // namespace griffith::ui
