#include "sim/core/bytes.h"
#include "sim/meshing/surface_objects.h"

namespace griffith {
namespace {

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
  const auto count = static_cast<std::int64_t>(values.size());
  bytes.append(bytes_of(std::span(&count, 1))).append(bytes_of(values));
}

template <class Values>
bool take_all(std::string_view& bytes, Values& values) {
  std::int64_t count = 0;
  return take(bytes, &count, 1) && take_values(bytes, values, count);
}

}  // namespace

std::string encode(const std::vector<SurfaceObject>& objects) {
  std::string bytes;
  for (const auto& [name, surface] : objects) {
    append(bytes, std::vector<char>(name.begin(), name.end()));
    append(bytes, surface.points);
    append(bytes, surface.triangles);
    append(bytes, surface.uvs);
    append(bytes, surface.normals);
  }
  return bytes;
}

std::optional<std::vector<SurfaceObject>> decode_objects(std::string_view bytes) {
  std::vector<SurfaceObject> objects;
  while (!bytes.empty()) {
    auto& [name, surface] = objects.emplace_back();
    const bool whole = take_all(bytes, name) && take_all(bytes, surface.points) && take_all(bytes, surface.triangles) &&
                       take_all(bytes, surface.uvs) && take_all(bytes, surface.normals);
    if (!whole) return std::nullopt;
  }
  return objects;
}

}  // namespace griffith
