#include "sim/mesh/vtk_cells.h"

#include <algorithm>

namespace griffith {
namespace {

/// Types of VTK's cells (vtkCellType.h); all begin with their corners.
struct VtkType {
  std::int64_t type;
  CellShape shape;
};

constexpr std::int64_t kEmptyCell = 0, kVoxel = 11;

const VtkType* vtk_type(std::int64_t type) {
  using enum CellShape;
  static constexpr VtkType kTypes[] = {
      {1, point},          {2, point},          {3, line},          {4, line},           {5, triangle},
      {6, polygon},        {7, polygon},        {8, quadrilateral}, {9, quadrilateral},  {10, tetrahedron},
      {11, hexahedron},    {12, hexahedron},    {13, prism},        {14, pyramid},       {21, line},
      {22, triangle},      {23, quadrilateral}, {24, tetrahedron},  {25, hexahedron},    {26, prism},
      {27, pyramid},       {28, quadrilateral}, {29, hexahedron},   {30, quadrilateral}, {31, prism},
      {32, prism},         {33, hexahedron},    {34, triangle},     {35, line},          {36, polygon},
      {37, pyramid},       {68, line},          {69, triangle},     {70, quadrilateral}, {71, tetrahedron},
      {72, hexahedron},    {73, prism},         {74, pyramid},      {75, line},          {76, triangle},
      {77, quadrilateral}, {78, tetrahedron},   {79, hexahedron},   {80, prism},         {81, pyramid}};
  const auto* found = std::ranges::find(kTypes, type, &VtkType::type);
  return found == std::end(kTypes) ? nullptr : found;
}

/// A voxel's corners are numbered along its axes, not around its faces.
std::array<std::int64_t, 8> corner_order(std::int64_t type) {
  if (type == kVoxel) return {0, 1, 3, 2, 4, 5, 7, 6};
  return {0, 1, 2, 3, 4, 5, 6, 7};
}

/// Adds a cell with a volume; returns what is wrong with it, or nothing.
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

/// Polyhedra, and what VTK may have besides.
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
