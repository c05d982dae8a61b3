#include "sim/mesh/read_mesh.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

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

using MeshReader = MeshFile (*)(const std::filesystem::path&);

struct MeshFormat {
  std::string_view extension;
  MeshReader read;
};

constexpr MeshFormat kFormats[] = {{".node", read_tetgen}, {".ele", read_tetgen}, {".msh", read_gmsh},
                                   {".mesh", read_medit},  {".vtk", read_vtk},    {".vtu", read_vtu}};

/// Returns null for a path that is not a mesh.
MeshReader reader_of(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return read_csv_pair;
  const auto* format = std::ranges::find(kFormats, lower_case_extension(path), &MeshFormat::extension);
  return format == std::end(kFormats) ? nullptr : format->read;
}

}  // namespace

bool is_mesh_path(const std::filesystem::path& path) { return reader_of(path) != nullptr; }

TetSoup read_mesh(const std::filesystem::path& path, CellReport* report) {
  const MeshReader read = reader_of(path);
  if (read == nullptr && !std::filesystem::exists(path))
    throw InputError(path.string(), "no such file or folder", "check the path");
  if (read == nullptr)
    throw InputError(path.string(), "is not a known mesh format",
                     ".node, .ele, .msh, .mesh, .vtk, .vtu or a folder with verts.csv and tets.csv");
  MeshFile file = read(path);
  split_cells(file, path.string());
  if (const std::string flat = count_list(file.report.skipped); file.soup.tets.empty() && !flat.empty())
    throw InputError(path.string(), "has no cells with a volume, only " + flat,
                     "mesh its volume, too; the shape \"surface\" fills .obj, .stl, .ply, .off and glTF");
  if (report != nullptr) *report = file.report;
  return std::move(file.soup);
}

}  // namespace griffith
