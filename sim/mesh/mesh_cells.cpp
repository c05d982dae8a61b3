#include "sim/mesh/mesh_cells.h"

#include <algorithm>

#include "sim/core/number_text.h"

namespace griffith {
namespace {

struct ShapeInfo {
  int corners;
  const char *one, *many;
};

constexpr std::array<ShapeInfo, kCellShapes> kShapes = {{{1, "point", "points"},
                                                         {2, "line", "lines"},
                                                         {3, "triangle", "triangles"},
                                                         {4, "quadrilateral", "quadrilaterals"},
                                                         {0, "polygon", "polygons"},
                                                         {4, "tetrahedron", "tetrahedra"},
                                                         {5, "pyramid", "pyramids"},
                                                         {6, "prism", "prisms"},
                                                         {8, "hexahedron", "hexahedra"}}};

}  // namespace

int corner_count(CellShape shape) { return kShapes[static_cast<std::size_t>(shape)].corners; }

std::string count_list(const std::array<std::int64_t, kCellShapes>& counts) {
  std::vector<std::string> parts;
  for (std::size_t i = counts.size(); i-- > 0;)
    if (counts[i] > 0)
      parts.push_back(count_text(counts[i]) + " " + (counts[i] == 1 ? kShapes[i].one : kShapes[i].many));
  std::string list;
  for (std::size_t i = 0; i < parts.size(); ++i)
    list += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return list;
}

std::vector<std::string> findings(const CellReport& report) {
  std::vector<std::string> list;
  if (const std::string split = count_list(report.split); !split.empty())
    list.push_back(split + " split into " + count_text(report.tets_of_split) + " tetrahedra; no volume is skipped");
  if (const std::string skipped = count_list(report.skipped); !skipped.empty())
    list.push_back(skipped + " skipped: no volume");
  if (const std::string curved = count_list(report.higher_order); !curved.empty())
    list.push_back(curved + " of second or higher order taken with straight edges, by their corners alone");
  return list;
}

void MeshFile::add(CellShape shape, std::span<const int> corners, std::int64_t nodes) {
  if (nodes > corner_count(shape)) ++report.higher_order[static_cast<std::size_t>(shape)];
  if (shape == CellShape::tetrahedron) {
    soup.tets.push_back({corners[0], corners[1], corners[2], corners[3]});
    return;
  }
  VolumeCell& cell = cells.emplace_back(VolumeCell{shape, {}});
  std::copy_n(corners.begin(), corner_count(shape), cell.corners.begin());
  ++report.split[static_cast<std::size_t>(shape)];
}

}  // namespace griffith
