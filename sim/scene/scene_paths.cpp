#include "sim/scene/scene_paths.h"

namespace griffith {
namespace {

/// Adds the path of the held alternative if it has one.
template <class Variant>
void add_path(Variant& held, std::vector<std::filesystem::path*>& paths) {
  std::visit(
      [&](auto& value) {
        if constexpr (requires { value.path; }) paths.push_back(&value.path);
      },
      held);
}

}  // namespace

std::vector<std::filesystem::path*> paths_in(Scene& scene) {
  std::vector<std::filesystem::path*> paths;
  for (BodyDescription& body : scene.bodies) {
    add_path(body.shape, paths);
    if (body.splinters) add_path(*body.splinters, paths);
    if (body.residual_stress) add_path(*body.residual_stress, paths);
  }
  for (ProjectileBurst& burst : scene.projectiles)
    if (burst.shape) add_path(*burst.shape, paths);
  return paths;
}

std::filesystem::path path_from_scene(const std::filesystem::path& file, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  const fs::path start = folder.empty() ? fs::current_path() : fs::absolute(folder);
  return fs::absolute(file).lexically_normal().lexically_proximate(start.lexically_normal());
}

}  // namespace griffith
