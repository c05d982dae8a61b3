#include "app/picture/projectile_picture.h"

#include <cmath>
#include <numbers>

namespace griffith::app {
namespace {

/// Look of a material of some density; painted by default.
struct ProjectileLook {
  render::Rgb color = {0.25f, 0.25f, 0.26f};
  float metal = 0, roughness = 0.3f, mottle = 0;  ///< as render::Sphere
};

ProjectileLook look_of_density(double density) {
  constexpr double kLead = 9500, kSteel = 6000, kStone = 1800;  // least densities [kg/m³]
  if (density > kLead) return {{0.42f, 0.43f, 0.47f}, 0.9f, 0.55f, 0};
  if (density > kSteel) return {{0.72f, 0.73f, 0.74f}, 1, 0.12f, 0};
  if (density > kStone) return {{0.50f, 0.48f, 0.45f}, 0, 0.8f, 1};
  return {};
}

/// Returns the volume of a sphere, or that within the faces of another projectile [m³].
double volume_of(const ProjectileView& projectile) {
  if (projectile.corners.empty()) return 4.0 / 3 * std::numbers::pi * std::pow(projectile.radius, 3);
  double sum = 0;
  for (const std::vector<int>& face : projectile.faces)
    for (std::size_t i = 2; i < face.size(); ++i) {
      const auto corner = [&](std::size_t place) { return projectile.corners[static_cast<std::size_t>(face[place])]; };
      sum += corner(0).dot(corner(i - 1).cross(corner(i))) / 6;
    }
  return sum;
}

render::Sphere ball_of(const ProjectileView& projectile) {
  const ProjectileLook look = look_of_density(projectile.mass / volume_of(projectile));
  const Quat& turn = projectile.rotation;
  render::Sphere ball{projectile.position.cast<float>(),
                      static_cast<float>(projectile.radius),
                      look.color,
                      render::kNoId,
                      look.metal,
                      look.roughness,
                      look.mottle};
  ball.rotation = Eigen::Vector4d(turn.x(), turn.y(), turn.z(), turn.w()).cast<float>();
  return ball;
}

/// Returns the surface of such a material on flat faces. `size`: of the projectile [m].
render::EmbeddedMaterial projectile_surface(const ProjectileLook& look, float size) {
  render::EmbeddedMaterial material;
  material.color = look.color;
  material.mottle = 0.25f * look.mottle;
  material.roughness = 0.1f * look.mottle;
  material.noise_size = 0.1f * size;
  material.gloss = look.metal;
  material.blur = look.roughness;
  material.metal = look.metal;
  return material;
}

/// Appends a triangle that belongs to no body, with places for its corners at rest if the surface shows materials.
/// `matter`: index of its material; negative: none.
void add_plain_triangle(const render::Rgb& color, int matter, render::Surface& surface) {
  const std::size_t triangles = surface.positions.size() / 3;
  const std::size_t scalars = triangles > 0 ? surface.scalars.size() / triangles : 0;
  surface.colors.resize(triangles, surface.color);
  surface.ids.resize(triangles, render::kNoId);
  surface.flags.resize(triangles, 0);
  surface.scalars.resize(surface.scalars.size() + scalars, 0);
  if (matter >= 0 || !surface.matters.empty()) {
    surface.matters.resize(triangles, -1);
    surface.rests.resize(3 * triangles, Eigen::Vector3f::Zero());
    surface.matters.push_back(matter);
  }
  surface.colors.push_back(color);
  surface.ids.push_back(render::kNoId);
  surface.flags.push_back(render::kPlain);
}

void add_hull(const ProjectileView& projectile, bool natural, render::DrawScene& picture) {
  render::Surface& surface = picture.surface;
  const ProjectileLook look = natural ? look_of_density(projectile.mass / volume_of(projectile)) : ProjectileLook();
  const auto matter = natural ? static_cast<int>(picture.embedded.materials.size()) : -1;
  if (natural) picture.embedded.materials.push_back(projectile_surface(look, static_cast<float>(projectile.radius)));
  for (const std::vector<int>& face : projectile.faces)
    for (std::size_t i = 2; i < face.size(); ++i) {
      add_plain_triangle(look.color, matter, surface);
      for (const int index : {face[0], face[i - 1], face[i]}) {
        const Vec3& corner = projectile.corners[static_cast<std::size_t>(index)];
        surface.positions.emplace_back((projectile.position + projectile.rotation * corner).cast<float>());
        if (!surface.matters.empty()) surface.rests.emplace_back(corner.cast<float>());
      }
    }
}

}  // namespace

void add_projectiles(const Frame& frame, bool natural, render::DrawScene& picture) {
  for (const ProjectileView& projectile : frame.projectiles) {
    if (projectile.corners.empty())
      picture.spheres.push_back(ball_of(projectile));
    else
      add_hull(projectile, natural, picture);
  }
}

}  // namespace griffith::app
