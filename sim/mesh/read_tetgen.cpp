#include "sim/mesh/file_cursor.h"
#include "sim/mesh/mesh_formats.h"

namespace griffith {
namespace {

/// Reads X.node and returns the number of its first point, 0 or 1.
int read_points(FileCursor& cursor, TetSoup& soup) {
  const int count = cursor.number<int>("the number of points");
  const int dimension = cursor.number<int>("the dimension");
  if (dimension != 3) cursor.fail("dimension " + std::to_string(dimension), "expected 3");
  cursor.rest_of_line();  // numbers of attributes and markers: each point has its own line
  cursor.require_room(count, 4, 0, "points");
  int first = 0;
  for (int i = 0; i < count; ++i) {
    const int number = cursor.number<int>("a point's number");
    if (i == 0) first = number;
    if (first < 0 || first > 1 || number != first + i)
      cursor.fail("point number " + std::to_string(number), "points are numbered in turn from 0 or 1");
    Vec3 point;
    for (double& coordinate : point) coordinate = cursor.number<double>("x, y, z");
    soup.points.push_back(point);
    cursor.rest_of_line();
  }
  return first;
}

void read_tets(FileCursor& cursor, int first, MeshFile& file) {
  const int count = cursor.number<int>("the number of tetrahedra");
  const int corners = cursor.number<int>("the number of nodes per tetrahedron");
  if (corners != 4 && corners != 10)
    cursor.fail(std::to_string(corners) + " nodes per tetrahedron", "expected 4 or 10");
  cursor.rest_of_line();
  cursor.require_room(count, 5, 0, "tetrahedra");
  const int point_count = static_cast<int>(file.soup.points.size());
  for (int i = 0; i < count; ++i) {
    cursor.number<int>("a tetrahedron's number");
    std::array<int, 4> tet;
    for (int& corner : tet) {
      const int number = cursor.number<int>("a tetrahedron's corner");
      if (number < first || number - first >= point_count)
        cursor.fail("no point " + std::to_string(number),
                    "points are " + std::to_string(first) + " to " + std::to_string(point_count - 1 + first));
      corner = number - first;
    }
    file.add(CellShape::tetrahedron, tet, corners);
    cursor.rest_of_line();
  }
}

}  // namespace

MeshFile read_tetgen(const std::filesystem::path& path) {
  MeshFile file;
  FileCursor points(std::filesystem::path(path).replace_extension(".node"), "", '#');
  const int first = read_points(points, file.soup);
  FileCursor tets(std::filesystem::path(path).replace_extension(".ele"), "", '#');
  read_tets(tets, first, file);
  return file;
}

}  // namespace griffith
