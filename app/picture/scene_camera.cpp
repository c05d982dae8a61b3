#include "app/picture/scene_camera.h"

#include <array>
#include <charconv>

#include "sim/core/error.h"
#include "sim/scene/scene_fields.h"

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

/// Returns the double with the fewest decimal digits that rounds to the same float.
double with_few_digits(float number) {
  std::array<char, 32> text;
  const char* end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  double result = 0;
  std::from_chars(text.data(), end, result);
  return result;
}

Vec3 place_in_limits(const Eigen::Vector3f& place) {
  const Vec3 exact(with_few_digits(place.x()), with_few_digits(place.y()), with_few_digits(place.z()));
  return exact.cwiseMax(kPlace.minimum).cwiseMin(kPlace.maximum);
}

}  // namespace

Camera described(const render::Camera& camera) {
  Camera result;
  result.position = place_in_limits(camera.position);
  result.target = place_in_limits(camera.target);
  result.field_of_view_degrees = with_few_digits(camera.vertical_fov);
  return result;
}

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
