#include "app/picture/scene_camera.h"

#include "sim/core/error.h"

namespace griffith::app {
namespace {

render::Camera converted(const Camera& camera) {
  return {camera.position.cast<float>(), camera.target.cast<float>(), static_cast<float>(camera.field_of_view_degrees)};
}

std::string camera_names(const Scene& scene) {
  if (scene.cameras.empty()) return "the scene has none: leave the name out";
  std::string names = "the scene has ";
  for (const Camera& camera : scene.cameras) names += (&camera == &scene.cameras.front() ? "" : ", ") + camera.name;
  return names;
}

}  // namespace

render::Camera scene_camera(const Scene& scene, const std::string& name, const render::DrawScene& picture,
                            float aspect) {
  for (const Camera& camera : scene.cameras) {
    if (name.empty() || camera.name == name) return converted(camera);
  }
  if (!name.empty()) throw InputError("--camera", "there is no camera \"" + name + "\"", camera_names(scene));
  render::Camera camera;
  camera.position = camera.target + Eigen::Vector3f(1.6f, 1.0f, 3.0f);
  return render::frame_bounds(camera, render::bounds(picture), aspect);
}

}  // namespace griffith::app
