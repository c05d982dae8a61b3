#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ui/panels/panels.h"
#include "ui/widgets/field_range.h"
#include "ui/widgets/field_widgets.h"
#include "ui/widgets/number_slider.h"

namespace griffith::ui {
namespace {

/// A shape that the tool can fire, and its name in the list.
struct Choice {
  std::string name;
  std::optional<ProjectileShape> shape;
};

constexpr char kSurface[] = "Surface of a file";

/// Spheres, boxes, surfaces of files, and the hulls that the scene's own bursts are.
std::vector<Choice> choices(const Scene& scene) {
  std::vector<Choice> all = {{"Sphere", std::nullopt}, {"Box", BoxProjectile{}}, {kSurface, SurfaceProjectile{}}};
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
  return std::holds_alternative<SurfaceProjectile>(*shape) ? kSurface : "Hull";
}

/// A logarithmic slider for the field `name` of a burst (or its box), from `low` to `high`.
template <class T>
void number_row(Panel& panel, const char* tag, const char* label, const char* name, double low, double high,
                double& value) {
  number_slider(
      panel, {.tag = tag, .label = label, .numbers = range_of<T>(name), .low = low, .high = high, .logarithmic = true},
      value);
}

/// Which surface it is; its convex hull is what flies.
void surface_rows(Panel& panel, SurfaceProjectile& surface) {
  draw_field(panel,
             {"projectile/path", "Surface",
              ".obj, .stl, .ply, .off, .gltf or .glb: the convex hull flies. Enter takes the path."},
             panel.history.scene().folder, surface.path);
  number_row<SurfaceProjectile>(panel, "projectile/scale", "Metres a unit", "scale", 1e-3, 10, surface.scale);
}

void shape_rows(Panel& panel, ProjectileBurst& shot) {
  const std::vector<Choice> all = choices(panel.history.scene());
  std::vector<std::string> names;
  for (const Choice& choice : all) names.push_back(choice.name);
  const int chosen = combo_row(panel, "projectile/shape", "Shape", names, name_of(all, shot.shape));
  if (chosen >= 0) shot.shape = all[static_cast<std::size_t>(chosen)].shape;
  if (!shot.shape)
    return number_row<ProjectileBurst>(panel, "projectile/radius", "Radius", "radius", 5e-3, 5, shot.radius);
  if (auto* box = std::get_if<BoxProjectile>(&*shot.shape)) {
    number_row<BoxProjectile>(panel, "projectile/width", "Width", "size", 5e-3, 5, box->size.x());
    number_row<BoxProjectile>(panel, "projectile/height", "Height", "size", 5e-3, 5, box->size.y());
    number_row<BoxProjectile>(panel, "projectile/depth", "Depth", "size", 5e-3, 5, box->size.z());
  }
  if (auto* surface = std::get_if<SurfaceProjectile>(&*shot.shape)) surface_rows(panel, *surface);
  constexpr std::array kTurns = {"projectile/turn_x", "projectile/turn_y", "projectile/turn_z"};
  constexpr std::array kLabels = {"Turn about x", "Turn about y", "Turn about z"};
  for (std::size_t i = 0; i < 3; ++i)
    number_slider(panel,
                  {.tag = kTurns[i],
                   .label = kLabels[i],
                   .numbers = range_of<ProjectileBurst>("rotation_degrees"),
                   .low = -180,
                   .high = 180},
                  shot.rotation_degrees[static_cast<Eigen::Index>(i)]);
}

/// What the scene's burst says by a density is tuned as one: the mass then follows the size.
void mass_rows(Panel& panel, ProjectileBurst& shot) {
  constexpr double kDensityOfSteel = 7850;
  if (shot.density) {
    number_row<ProjectileBurst>(panel, "projectile/density", "Density", "density", 1, 3e4, *shot.density);
  } else {
    number_row<ProjectileBurst>(panel, "projectile/mass", "Mass", "mass", 1e-3, 1e5, shot.mass);
  }
  bool by_density = shot.density.has_value();
  if (!checkbox(panel, "projectile/by_density", "Mass by density", by_density)) return;
  shot.density = by_density ? std::optional(kDensityOfSteel) : std::nullopt;
}

/// Something to fire, to start from.
struct ShotPreset {
  const char* name;
  double radius, mass, speed;
  std::optional<Vec3> box = std::nullopt;
};

const std::array<ShotPreset, 6>& shot_presets() {
  static const std::array<ShotPreset, 6> kPresets = {{{"steel ball", 0.02, 0.263, 20},
                                                      {"marble", 0.008, 0.0054, 10},
                                                      {"bullet", 0.0045, 0.008, 400},
                                                      {"brick", 0.1, 3.5, 10, Vec3(0.24, 0.071, 0.115)},
                                                      {"cannonball", 0.055, 5.4, 150},
                                                      {"wrecking ball", 0.5, 4000, 8}}};
  return kPresets;
}

void preset_row(Panel& panel, ProjectileBurst& shot) {
  std::vector<std::string> names;
  for (const ShotPreset& preset : shot_presets()) names.emplace_back(preset.name);
  const int chosen = combo_row(panel, "projectile/preset", "Shot", names, "choose…");
  if (chosen < 0) return;
  const ShotPreset& preset = shot_presets()[static_cast<std::size_t>(chosen)];
  shot.radius = preset.radius;
  shot.mass = preset.mass;
  shot.speed = preset.speed;
  shot.density.reset();
  shot.shape.reset();
  if (preset.box) shot.shape = BoxProjectile{*preset.box};
}

}  // namespace

void draw_projectile_panel(Panel& panel) {
  heading(panel, "Projectile");
  ProjectileBurst& shot = panel.state.shot;
  preset_row(panel, shot);
  shape_rows(panel, shot);
  number_row<ProjectileBurst>(panel, "projectile/speed", "Speed", "speed", 0.1, 1000, shot.speed);
  mass_rows(panel, shot);
  integer_row(panel, "projectile/count", "Burst", shot.count, range_of<ProjectileBurst>("count"));
  field_tooltip(panel, "projectile/count", "Projectiles in a row.");
  if (shot.count > 1) {
    number_row<ProjectileBurst>(panel, "projectile/interval", "Interval", "interval", 1e-2, 5, shot.interval);
  }
  hint(panel, "Right-click in the view, or press F, to fire at the cursor.");
  if (!panel.state.last_shot) return;
  const CommandInfo& keep = command_info(CommandId::keep_shot);
  if (text_button(panel, "projectile/keep", keep.label.data())) issue(panel, {.id = keep.id});
  tooltip(keep.hint);
}

}  // namespace griffith::ui
