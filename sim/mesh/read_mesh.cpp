#include "sim/mesh/read_mesh.h"

#include <algorithm>
#include <cctype>

#include "sim/core/error.h"
#include "sim/mesh/mesh_formats.h"

namespace griffith {
namespace {

std::string lower_case_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

MeshFile read_by_extension(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) return read_csv_pair(path);
  const std::string extension = lower_case_extension(path);
  if (extension == ".node" || extension == ".ele") return read_tetgen(path);
  if (extension == ".msh") return read_gmsh(path);
  if (extension == ".mesh") return read_medit(path);
  if (extension == ".vtk") return read_vtk(path);
  if (extension == ".vtu") return read_vtu(path);
  if (!std::filesystem::exists(path)) throw InputError(path.string(), "no such file or folder", "check the path");
  throw InputError(path.string(), "is no mesh format known here",
                   ".node, .ele, .msh, .mesh, .vtk, .vtu or a folder with verts.csv and tets.csv");
}

}  // namespace

TetSoup read_mesh(const std::filesystem::path& path, std::int64_t* skipped_elements) {
  MeshFile file = read_by_extension(path);
  if (skipped_elements != nullptr) *skipped_elements = file.skipped_elements;
  return std::move(file.soup);
}

}  // namespace griffith
