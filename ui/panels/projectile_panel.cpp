#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/scene/input_fields.h"
#include "ui/panels/panels.h"
#include "ui/widgets/field_range.h"
#include "ui/widgets/field_widgets.h"
#include "ui/widgets/number_field.h"

namespace griffith::ui {
namespace {

/// A shape that the tool can fire, with its listed name.
struct Choice {
  std::string name;
  std::optional<ProjectileShape> shape;
};

constexpr char kSurface[] = "Surface file";

/// Returns spheres, boxes, surface files, and the hulls of the scene's own bursts.
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

/// Draws a number for the field `name` of a burst.
template <class T>
void number_row(Panel& panel, const char* tag, const char* label, const char* name, double& value) {
  number_field_row(panel, {.tag = tag, .label = label, .numbers = range_of<T>(name)}, value);
}

/// Draws the sides of a box in one unit.
void size_rows(Panel& panel, Vec3& size) {
  constexpr std::array kSides = {"width", "height", "depth"}, kLabels = {"Width", "Height", "Depth"};
  const std::string tag = "projectile/size/";
  const SiPrefix prefix = shared_prefix(panel.state, tag, size.maxCoeff(), "m");
  for (std::size_t i = 0; i < kSides.size(); ++i)
    number_field_row(
        panel,
        {.tag = tag + kSides[i], .label = kLabels[i], .numbers = range_of<BoxProjectile>("size"), .prefix = prefix},
        size[static_cast<Eigen::Index>(i)]);
}

/// Draws the choice of a surface; its convex hull is fired.
void surface_rows(Panel& panel, SurfaceProjectile& surface) {
  draw_field(panel,
             {"projectile/path", "Surface",
              ".obj, .stl, .ply, .off, .gltf or .glb: the convex hull is fired. Enter accepts the path."},
             panel.history.scene().folder, surface.path);
  number_row<SurfaceProjectile>(panel, "projectile/scale", "Meters per unit", "scale", surface.scale);
}

void shape_rows(Panel& panel, ProjectileBurst& shot) {
  const std::vector<Choice> all = choices(panel.history.scene());
  std::vector<std::string> names;
  for (const Choice& choice : all) names.push_back(choice.name);
  const int chosen = combo_row(panel, "projectile/shape", "Shape", names, name_of(all, shot.shape));
  if (chosen >= 0) shot.shape = all[static_cast<std::size_t>(chosen)].shape;
  if (!shot.shape) return number_row<ProjectileBurst>(panel, "projectile/radius", "Radius", "radius", shot.radius);
  if (auto* box = std::get_if<BoxProjectile>(&*shot.shape)) size_rows(panel, box->size);
  if (auto* surface = std::get_if<SurfaceProjectile>(&*shot.shape)) surface_rows(panel, *surface);
  constexpr std::array kTurns = {"projectile/turn_x", "projectile/turn_y", "projectile/turn_z"};
  constexpr std::array kLabels = {"Rotation x", "Rotation y", "Rotation z"};
  for (std::size_t i = 0; i < 3; ++i)
    number_field_row(panel,
                     {.tag = kTurns[i], .label = kLabels[i], .numbers = range_of<ProjectileBurst>("rotation_degrees")},
                     shot.rotation_degrees[static_cast<Eigen::Index>(i)]);
}

/// Draws mass or density. A burst with a density keeps it, so that its mass follows the size.
void mass_rows(Panel& panel, ProjectileBurst& shot) {
  constexpr double kDensityOfSteel = 7850;
  if (shot.density) {
    number_row<ProjectileBurst>(panel, "projectile/density", "Density", "density", *shot.density);
  } else {
    number_row<ProjectileBurst>(panel, "projectile/mass", "Mass", "mass", shot.mass);
  }
  bool by_density = shot.density.has_value();
  if (!checkbox(panel, "projectile/by_density", "Mass from density", by_density)) return;
  shot.density = by_density ? std::optional(kDensityOfSteel) : std::nullopt;
}

/// A preset of the projectile tool.
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
  const int chosen = combo_row(panel, "projectile/preset", "Shot preset", names, "choose…");
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

void draw_grab_panel(Panel& panel) {
  if (!panel.state.grab_tool) return;
  heading(panel, "Grab");
  GrabSpring& spring = panel.state.grab_spring;
  const auto row = [&](const char* tag, const char* label, const char* name, double& value, const char* tooltip) {
    number_field_row(panel, {.tag = tag, .label = label, .numbers = range_of<GrabSpring>(name), .tooltip = tooltip},
                     value);
  };
  row("grab/strength", "Greatest force / weight", "strength", spring.strength,
      "Greatest force of the spring over the weight of the piece.");
  row("grab/frequency", "Frequency", "frequency", spring.frequency,
      "Frequency of the piece on the spring: stiffness. It is lower where a period would take less than 20 time "
      "steps.");
  row("grab/damping_ratio", "Damping ratio", "damping_ratio", spring.damping_ratio,
      "Damping of the grabbed point over critical damping.");
  hint(panel, "Drag a piece in the view. It is an input of the run, like a shot.");
}

void draw_push_panel(Panel& panel) {
  if (!panel.state.push_tool) return;
  heading(panel, "Push");
  number_field_row(
      panel,
      {.tag = "push/speed",
       .label = "Change of speed",
       .numbers = {.minimum = 1e-4, .maximum = 1e4, .unit = "m/s"},
       .tooltip = "Speed that a click gives to a free piece: its impulse is the mass of the piece times this "
                  "speed, by a constant force in the next time step."},
      panel.state.push_speed);
  hint(panel, "Click a piece in the view. It is an input of the run, like a shot.");
}

void draw_projectile_panel(Panel& panel) {
  heading(panel, "Projectile");
  ProjectileBurst& shot = panel.state.shot;
  preset_row(panel, shot);
  shape_rows(panel, shot);
  number_row<ProjectileBurst>(panel, "projectile/speed", "Speed", "speed", shot.speed);
  mass_rows(panel, shot);
  number_field_row(panel,
                   {.tag = "projectile/count",
                    .label = "Burst",
                    .numbers = range_of<ProjectileBurst>("count"),
                    .tooltip = "Number of projectiles, fired one after the other."},
                   shot.count);
  if (shot.count > 1) {
    number_row<ProjectileBurst>(panel, "projectile/interval", "Interval", "interval", shot.interval);
  }
  hint(panel, "Right-click in the view, or press F, to fire at the cursor.");
  if (!panel.state.last_shot) return;
  const CommandInfo& keep = command_info("simulation.keep_shot", panel);
  if (text_button(panel, "projectile/keep", keep.label.data())) issue(panel, {.name = keep.name});
  tooltip(keep.hint);
}

}  // namespace griffith::ui
