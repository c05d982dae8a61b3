#include "sim/scene/scene.h"

#include <cmath>
#include <cstdlib>

#include "bindings/c/guarded.h"
#include "bindings/c/handles.h"
#include "sim/scene/edit_scene.h"
#include "sim/scene/scene_reader.h"

using namespace griffith;
using namespace griffith::c;

namespace {

constexpr char kScene[] = "scene";

/// Returns the pointer with its leading slash; "" stays the whole document.
std::string pointer_of(const char* pointer) {
  const std::string text = text_of(pointer, "pointer");
  return text.empty() ? text : scene_pointer(text, "pointer");
}

/// Returns a copy for free().
char* c_string(const std::string& text) {
  char* copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (!copy) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

TetSoup soup_of(const double* points, std::int64_t point_count, const std::int32_t* tets, std::int64_t tet_count) {
  constexpr std::int64_t kMax = 100'000'000;
  require(point_count >= 0 && point_count <= kMax, "point_count", "is out of range", "0 to 100 million");
  require(tet_count >= 0 && tet_count <= kMax, "tet_count", "is out of range", "0 to 100 million");
  require(points || point_count == 0, "points", "is null", "pass 3 coordinates per point");
  require(tets || tet_count == 0, "tets", "is null", "pass 4 indices per tetrahedron");
  TetSoup soup;
  soup.points.reserve(point_count);
  soup.tets.reserve(tet_count);
  for (std::int64_t i = 0; i < point_count; ++i)
    soup.points.push_back({points[3 * i], points[3 * i + 1], points[3 * i + 2]});
  for (const Vec3& point : soup.points) require(point.allFinite(), "points", "has a coordinate that is not finite");
  for (std::int64_t i = 0; i < tet_count; ++i)
    soup.tets.push_back({tets[4 * i], tets[4 * i + 1], tets[4 * i + 2], tets[4 * i + 3]});
  for (const auto& tet : soup.tets)
    for (const int corner : tet)
      require(corner >= 0 && corner < point_count, "tets", "has an index out of range", "0 to point_count - 1");
  return soup;
}

}  // namespace

griffith_status griffith_scene_read(const char* path, griffith_scene** scene, griffith_error* error) {
  return guarded(error, [&] { object_of(scene, kScene) = new griffith_scene{read_scene(text_of(path, "path")), {}}; });
}

griffith_status griffith_scene_parse(const char* json, const char* folder, griffith_scene** scene,
                                     griffith_error* error) {
  return guarded(error, [&] {
    griffith_scene*& made = object_of(scene, kScene);
    Scene parsed = scene_from_json_alone(text_of(json, "json"), kScene);
    parsed.folder = folder && *folder ? std::filesystem::absolute(folder) : std::filesystem::current_path();
    made = new griffith_scene{std::move(parsed), {}};
  });
}

griffith_status griffith_scene_copy(const griffith_scene* scene, griffith_scene** copy, griffith_error* error) {
  return guarded(error, [&] { object_of(copy, "copy") = new griffith_scene(object_of(scene, kScene)); });
}

void griffith_scene_destroy(griffith_scene* scene) { delete scene; }

griffith_status griffith_scene_set(griffith_scene* scene, const char* pointer, const char* json,
                                   griffith_error* error) {
  return guarded(error, [&] {
    griffith_scene& changed = object_of(scene, kScene);
    const SceneSetting setting{scene_pointer(text_of(pointer, "pointer"), "pointer"), text_of(json, "json")};
    changed.scene = edited(changed.scene, {&setting, 1});
  });
}

griffith_status griffith_scene_get(const griffith_scene* scene, const char* pointer, char** json,
                                   griffith_error* error) {
  return guarded(error, [&] {
    char*& text = object_of(json, "json");
    text = c_string(value_of(object_of(scene, kScene).scene, pointer_of(pointer)));
  });
}

griffith_status griffith_scene_set_mesh(griffith_scene* scene, const char* name, const double* points,
                                        std::int64_t point_count, const std::int32_t* tets, std::int64_t tet_count,
                                        griffith_error* error) {
  return guarded(error, [&] {
    TetSoup soup = soup_of(points, point_count, tets, tet_count);
    object_of(scene, kScene).meshes.insert_or_assign(text_of(name, "name"), std::move(soup));
  });
}

void griffith_string_free(char* text) { std::free(text); }
