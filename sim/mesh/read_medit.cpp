#include <algorithm>
#include <optional>
#include <span>

#include "sim/mesh/file_cursor.h"
#include "sim/mesh/mesh_formats.h"

namespace griffith {
namespace {

void read_vertices(FileCursor& cursor, TetSoup& soup) {
  const int count = cursor.number<int>("the number of vertices");
  cursor.require_room(count, 4, 0, "vertices");
  for (int i = 0; i < count; ++i) {
    Vec3 point;
    for (double& coordinate : point) coordinate = cursor.number<double>("x, y, z");
    cursor.number<double>("the vertex's reference");
    soup.points.push_back(point);
  }
}

/// Skips the numbers up to the next keyword. Returns their count.
std::int64_t skip_numbers(FileCursor& cursor) {
  std::int64_t count = 0;
  for (double ignored = 0; !cursor.at_end(); ++count) {
    const std::size_t start = cursor.offset();
    if (parse_number(cursor.word("a number"), ignored)) continue;
    cursor.seek(start);
    break;
  }
  return count;
}

/// Returns the number of nodes of each of the following cells: their numbers, less the reference, divided by the cells.
std::int64_t nodes_each(FileCursor& cursor, std::int64_t cells, int corners) {
  const std::size_t start = cursor.offset();
  const std::int64_t numbers = skip_numbers(cursor);
  cursor.seek(start);
  return cells > 0 && numbers % cells == 0 ? std::max<std::int64_t>(numbers / cells - 1, corners) : corners;
}

void read_cells(FileCursor& cursor, CellShape shape, MeshFile& file) {
  const int count = cursor.number<int>("the number of elements"), corners = corner_count(shape);
  cursor.require_room(count, corners + 1, 0, "elements");
  if (!has_volume(shape)) {
    file.skip(shape, count);
    skip_numbers(cursor);
    return;
  }
  const std::int64_t nodes = nodes_each(cursor, count, corners);
  const auto point_count = static_cast<int>(file.soup.points.size());
  for (int i = 0; i < count; ++i) {
    std::array<int, 8> cell = {};
    for (int& corner : std::span(cell).first(corners)) {
      corner = cursor.number<int>("a vertex's number");
      if (corner < 1 || corner > point_count)
        cursor.fail("no vertex " + std::to_string(corner), "vertices are 1 to " + std::to_string(point_count));
      --corner;
    }
    for (std::int64_t rest = corners; rest <= nodes; ++rest) cursor.number<int>("a further node, or the reference");
    file.add(shape, cell, nodes);
  }
}

/// Returns the shape of the cells that a keyword begins, "Hexahedra" or, of higher order, "HexahedraQ2"; none for other
/// keywords.
std::optional<CellShape> cells_of(std::string_view keyword) {
  using enum CellShape;
  constexpr std::pair<std::string_view, CellShape> kCells[] = {
      {"Edges", line},       {"Triangles", triangle}, {"Quadrilaterals", quadrilateral}, {"Tetrahedra", tetrahedron},
      {"Pyramids", pyramid}, {"Prisms", prism},       {"Hexahedra", hexahedron}};
  for (const auto& [name, shape] : kCells) {
    if (!keyword.starts_with(name)) continue;
    const std::string_view order = keyword.substr(name.size());
    if (order.empty() || (order.size() == 2 && (order[0] == 'P' || order[0] == 'Q'))) return shape;
  }
  return std::nullopt;
}

}  // namespace

MeshFile read_medit(const std::filesystem::path& path) {
  FileCursor cursor(path, "", '#');
  MeshFile file;
  cursor.expect("MeshVersionFormatted");
  cursor.number<int>("the version");
  while (!cursor.at_end()) {
    const std::string_view keyword = cursor.word("a keyword");
    if (keyword == "End") break;
    if (keyword == "Vertices") {
      read_vertices(cursor, file.soup);
    } else if (keyword == "Dimension") {
      const int dimension = cursor.number<int>("the dimension");
      if (dimension != 3) cursor.fail("dimension " + std::to_string(dimension), "expected 3");
    } else if (const auto shape = cells_of(keyword)) {
      read_cells(cursor, *shape, file);
    } else {
      skip_numbers(cursor);
    }
  }
  return file;
}

}  // namespace griffith
