#include "sim/recording/assets.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "sim/core/error.h"
#include "sim/core/file_path.h"
#include "sim/core/read_file.h"
#include "sim/mesh/read_mesh.h"
#include "sim/mesh/write_mesh.h"
#include "sim/scene/scene_paths.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;

constexpr char kFilledSurface[] = "filled.msh";

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// Returns the distinct matches of the pattern's group in the text.
std::set<std::string> all_found(const std::string& text, const std::regex& pattern) {
  std::set<std::string> found;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), pattern); match != std::sregex_iterator(); ++match)
    found.insert((*match)[1]);
  return found;
}

/// Returns the JSON in the first chunk of a binary glTF file, after its header. Empty if there is none.
std::string json_of_glb(const std::string& content) {
  constexpr std::size_t kHeader = 20, kLengthAt = 12;
  std::uint32_t length = 0;
  if (content.size() < kHeader) return {};
  std::memcpy(&length, content.data() + kLengthAt, sizeof length);
  return content.substr(kHeader, length);
}

/// Returns the files that buffers and images of glTF name. Those with embedded data name none.
std::set<std::string> uris_in(const std::string& gltf) {
  const auto json = nlohmann::json::parse(gltf, nullptr, false);
  std::set<std::string> uris;
  for (const char* kind : {"buffers", "images"}) {
    if (!json.is_object() || !json.contains(kind) || !json[kind].is_array()) continue;
    for (const auto& item : json[kind])
      if (item.is_object() && item.contains("uri") && item["uri"].is_string())
        if (const auto uri = item["uri"].get<std::string>(); !uri.starts_with("data:")) uris.insert(uri);
  }
  return uris;
}

/// Returns the files beside `file` that it needs or names. Some may not exist.
std::set<std::string> named_in(const fs::path& file, const std::string& content) {
  static const std::regex kMaterials("mtllib[ \\t]+([^\\r\\n]{1,200})");
  const std::string kind = lower_case(file.extension().string());
  if (kind == ".node") return {file.stem().string() + ".ele"};
  if (kind == ".ele") return {file.stem().string() + ".node"};
  if (kind == ".gltf") return uris_in(content);
  if (kind == ".glb") return uris_in(json_of_glb(content));
  if (kind == ".obj") return all_found(content.substr(0, 10'000), kMaterials);
  return {};
}

/// True if it is a file in or below the folder of `file` after all links are resolved. Files elsewhere are not read for
/// a surface either.
bool is_beside(const fs::path& file, const std::string& name) {
  const fs::path plain = fs::path(name).lexically_normal();
  std::error_code ignored;
  return plain.is_relative() && !plain.empty() && *plain.begin() != ".." &&
         fs::is_regular_file(file.parent_path() / plain, ignored) &&
         is_within(file.parent_path(), file.parent_path() / plain);
}

class AssetCollector {
 public:
  AssetCollector(fs::path folder, OutsideFiles outside, FileTree& files)
      : folder_(std::move(folder)), outside_(outside), files_(files) {}

  /// Adds a file or folder. Returns its path in the recording. `filled`: null if it is not a surface.
  fs::path add(const fs::path& path, const TetSoup* filled) {
    const auto [known, is_new] = added_.try_emplace({path, filled});
    if (!is_new) return known->second;
    fs::path source = fs::absolute(file_path(folder_, path)).lexically_normal();
    if (!source.has_filename()) source = source.parent_path();  // "wall_csv/"
    const std::string folder = "assets/" + std::to_string(added_.size()) + "/";
    known->second = folder + source.filename().string();
    std::error_code ignored;
    if (fs::is_directory(source, ignored)) {
      for (const char* name : {"verts.csv", "tets.csv"})
        files_[known->second.string() + "/" + name] = content_of(source / name);
    } else {
      add_file(source, folder);
    }
    if (filled) files_[folder + kFilledSurface] = gmsh_text(*filled);
    return known->second;
  }

 private:
  void add_file(const fs::path& source, const std::string& folder) {
    const std::string content = content_of(source);
    for (const std::string& name : named_in(source, content))
      if (is_beside(source, name))
        files_[folder + fs::path(name).lexically_normal().generic_string()] = read_file(source.parent_path() / name);
    files_[folder + source.filename().string()] = content;
  }

  /// A scene without a folder came from no file, so its maker named the files.
  std::string content_of(const fs::path& file) const {
    std::error_code ignored;
    const bool outside = fs::exists(file, ignored) && !is_within(folder_, file);
    if (outside && !folder_.empty() && outside_ == OutsideFiles::refuse)
      throw InputError(
          file.string(), "is outside the scene's folder " + folder_.string() + ", and is not packed by default",
          "copy it into that folder and name it there, or pack it as it is: tick \"Pack files from outside the "
          "scene's folder\" where the editor asks for a name, or give --pack-outside");
    return read_file(file);
  }

  fs::path folder_;
  OutsideFiles outside_;
  FileTree& files_;
  std::map<std::pair<fs::path, const TetSoup*>, fs::path> added_;
};

}  // namespace

SceneWithAssets collect_assets(const World& world, OutsideFiles outside) {
  SceneWithAssets result{world.scene(), {}};
  Scene& scene = result.scene;
  std::map<const fs::path*, const TetSoup*> filled;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (auto* surface = std::get_if<SurfaceShape>(&scene.bodies[i].shape))
      filled[&surface->path] = world.filled_surface(static_cast<int>(i));
  AssetCollector collector(scene.folder, outside, result.files);
  for (fs::path* path : paths_in(scene)) *path = collector.add(*path, filled[path]);
  scene.folder.clear();
  scene.schema.clear();
  return result;
}

InMemoryMeshes filled_surfaces(const Scene& scene) {
  InMemoryMeshes meshes;
  for (const BodyDescription& body : scene.bodies) {
    const auto* surface = std::get_if<SurfaceShape>(&body.shape);
    if (!surface) continue;
    const fs::path filled = file_path(scene.folder, surface->path).parent_path() / kFilledSurface;
    std::error_code ignored;
    if (!meshes.contains(surface->path) && fs::exists(filled, ignored)) meshes[surface->path] = read_mesh(filled);
  }
  return meshes;
}

}  // namespace griffith
