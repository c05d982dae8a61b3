#include "sim/mesh/vtk_cells.h"

#include <algorithm>

namespace griffith {
namespace {

/// Types of VTK's cells (vtkCellType.h). All begin with their corners.
struct VtkType {
  std::int64_t type;
  CellShape shape;
};

constexpr std::int64_t kEmptyCell = 0, kVoxel = 11;

constexpr VtkType kVtkTypes[] = {
    {1, CellShape::point},          {2, CellShape::point},          {3, CellShape::line},
    {4, CellShape::line},           {5, CellShape::triangle},       {6, CellShape::polygon},
    {7, CellShape::polygon},        {8, CellShape::quadrilateral},  {9, CellShape::quadrilateral},
    {10, CellShape::tetrahedron},   {11, CellShape::hexahedron},    {12, CellShape::hexahedron},
    {13, CellShape::prism},         {14, CellShape::pyramid},       {21, CellShape::line},
    {22, CellShape::triangle},      {23, CellShape::quadrilateral}, {24, CellShape::tetrahedron},
    {25, CellShape::hexahedron},    {26, CellShape::prism},         {27, CellShape::pyramid},
    {28, CellShape::quadrilateral}, {29, CellShape::hexahedron},    {30, CellShape::quadrilateral},
    {31, CellShape::prism},         {32, CellShape::prism},         {33, CellShape::hexahedron},
    {34, CellShape::triangle},      {35, CellShape::line},          {36, CellShape::polygon},
    {37, CellShape::pyramid},       {68, CellShape::line},          {69, CellShape::triangle},
    {70, CellShape::quadrilateral}, {71, CellShape::tetrahedron},   {72, CellShape::hexahedron},
    {73, CellShape::prism},         {74, CellShape::pyramid},       {75, CellShape::line},
    {76, CellShape::triangle},      {77, CellShape::quadrilateral}, {78, CellShape::tetrahedron},
    {79, CellShape::hexahedron},    {80, CellShape::prism},         {81, CellShape::pyramid}};

const VtkType* vtk_type(std::int64_t type) {
  const auto* found = std::ranges::find(kVtkTypes, type, &VtkType::type);
  return found == std::end(kVtkTypes) ? nullptr : found;
}

/// Returns the order of corners. Those of a voxel are numbered along its axes, not around its faces.
std::array<std::int64_t, 8> corner_order(std::int64_t type) {
  if (type == kVoxel) return {0, 1, 3, 2, 4, 5, 7, 6};
  return {0, 1, 2, 3, 4, 5, 6, 7};
}

/// Adds a cell with a volume. Returns a problem, or an empty text.
std::string add_cell(const VtkType& type, std::span<const std::int64_t> points, int first_point,
                     std::int64_t point_count, MeshFile& file) {
  const int count = corner_count(type.shape);
  if (std::ssize(points) < count)
    return " has " + std::to_string(points.size()) + " points, not " + std::to_string(count);
  std::array<int, 8> corners = {};
  for (int corner = 0; corner < count; ++corner) {
    const std::int64_t point = points[corner_order(type.type)[corner]];
    if (point < 0 || point >= point_count)
      return " names point " + std::to_string(point) + " of " + std::to_string(point_count);
    corners[corner] = first_point + static_cast<int>(point);
  }
  file.add(type.shape, corners, std::ssize(points));
  return {};
}

/// Returns a problem if there are polyhedra or other unsupported cells of VTK; else an empty text.
std::string unknown_cells(const VtkCells& cells) {
  const auto is_unknown = [](std::int64_t type) { return type != kEmptyCell && vtk_type(type) == nullptr; };
  const auto first = std::ranges::find_if(cells.types, is_unknown);
  if (first == cells.types.end()) return {};
  return "cell " + std::to_string(first - cells.types.begin()) + " has VTK's type " + std::to_string(*first) +
         ", which is not split here (" + std::to_string(std::ranges::count_if(cells.types, is_unknown)) + " such)";
}

}  // namespace

std::string add_vtk_cells(const VtkCells& cells, int first_point, std::int64_t point_count, MeshFile& file) {
  if (cells.types.size() != cells.offsets.size())
    return std::to_string(cells.types.size()) + " cell types for " + std::to_string(cells.offsets.size()) + " cells";
  if (std::string unknown = unknown_cells(cells); !unknown.empty()) return unknown;
  std::int64_t begin = 0;
  for (std::size_t i = 0; i < cells.types.size(); ++i) {
    const std::int64_t end = cells.offsets[i];
    const std::string cell = "cell " + std::to_string(i);
    if (end < begin || end > static_cast<std::int64_t>(cells.connectivity.size())) return cell + " has a wrong offset";
    const VtkType* type = vtk_type(cells.types[i]);
    if (type != nullptr && !has_volume(type->shape)) file.skip(type->shape);
    if (type != nullptr && has_volume(type->shape)) {
      const auto points = cells.connectivity.subspan(begin, end - begin);
      if (std::string problem = add_cell(*type, points, first_point, point_count, file); !problem.empty())
        return cell + problem;
    }
    begin = end;
  }
  return {};
}

}  // namespace griffith
