#include "sim/core/error.h"
#include "sim/mesh/file_cursor.h"
#include "sim/mesh/mesh_formats.h"
#include "sim/mesh/read_mesh.h"

namespace griffith {
namespace {

/// Skips a heading: a first line that does not start with a number.
void skip_heading(FileCursor& cursor) {
  if (cursor.at_end()) return;
  const std::size_t start = cursor.offset();
  double ignored;
  if (parse_number(cursor.word("a number"), ignored))
    cursor.seek(start);
  else
    cursor.rest_of_line();
}

/// Calls read_row(cursor) for each line with content and checks that it uses up the line.
template <class ReadRow>
void read_rows(const std::filesystem::path& path, ReadRow read_row) {
  FileCursor cursor(path, ",;", '#');
  skip_heading(cursor);
  while (!cursor.at_end()) {
    const std::size_t start = cursor.offset();
    const std::size_t line_end = cursor.text().find('\n', start);
    read_row(cursor);
    if (cursor.offset() > line_end) cursor.fail("a row with too few numbers ends before this line", "one row per line");
    if (!cursor.at_end() && cursor.offset() < line_end)
      cursor.fail_expecting("the end of the row", cursor.rest_of_line());
  }
}

}  // namespace

std::vector<Vec3> read_points(const std::filesystem::path& path) {
  std::vector<Vec3> points;
  read_rows(path, [&](FileCursor& cursor) {
    Vec3 point;
    for (double& coordinate : point) coordinate = cursor.number<double>("x, y, z");
    points.push_back(point);
  });
  if (points.empty()) throw InputError(path.string(), "holds no points", "write x, y, z in each line");
  return points;
}

MeshFile read_csv_pair(const std::filesystem::path& folder) {
  MeshFile file;
  file.soup.points = read_points(folder / "verts.csv");
  const int point_count = static_cast<int>(file.soup.points.size());
  read_rows(folder / "tets.csv", [&](FileCursor& cursor) {
    std::array<int, 4> tet;
    for (int& corner : tet) {
      corner = cursor.number<int>("four 0-based indices of verts.csv");
      if (corner < 0 || corner >= point_count)
        cursor.fail("no point " + std::to_string(corner), "points are 0 to " + std::to_string(point_count - 1));
    }
    file.soup.tets.push_back(tet);
  });
  return file;
}

}  // namespace griffith
