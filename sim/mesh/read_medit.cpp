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

void read_tetrahedra(FileCursor& cursor, TetSoup& soup) {
  const int count = cursor.number<int>("the number of tetrahedra");
  cursor.require_room(count, 5, 0, "tetrahedra");
  const auto point_count = static_cast<int>(soup.points.size());
  for (int i = 0; i < count; ++i) {
    std::array<int, 4> tet;
    for (int& corner : tet) {
      corner = cursor.number<int>("a vertex's number");
      if (corner < 1 || corner > point_count)
        cursor.fail("no vertex " + std::to_string(corner), "vertices are 1 to " + std::to_string(point_count));
      --corner;
    }
    cursor.number<int>("the tetrahedron's reference");
    soup.tets.push_back(tet);
  }
}

/// Passes over the numbers up to the next keyword.
void skip_numbers(FileCursor& cursor) {
  while (!cursor.at_end()) {
    const std::size_t start = cursor.offset();
    double ignored;
    if (!parse_number(cursor.word("a number"), ignored)) {
      cursor.seek(start);
      return;
    }
  }
}

bool is_other_element(std::string_view keyword) {
  return keyword == "Edges" || keyword == "Triangles" || keyword == "Quadrilaterals" || keyword == "Hexahedra" ||
         keyword == "Prisms" || keyword == "Pyramids";
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
    } else if (keyword == "Tetrahedra") {
      read_tetrahedra(cursor, file.soup);
    } else if (keyword == "Dimension") {
      const int dimension = cursor.number<int>("the dimension");
      if (dimension != 3) cursor.fail("dimension " + std::to_string(dimension), "expected 3");
    } else {
      if (is_other_element(keyword)) {
        const int count = cursor.number<int>("the number of elements");
        cursor.require_room(count, 2, 0, "elements");
        file.skipped_elements += count;
      }
      skip_numbers(cursor);
    }
  }
  return file;
}

}  // namespace griffith
