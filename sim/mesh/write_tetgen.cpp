#include "sim/core/number_text.h"
#include "sim/core/replace_file.h"
#include "sim/mesh/write_mesh.h"

namespace griffith {

void write_tetgen(const std::filesystem::path& path, const TetSoup& soup) {
  std::string points, tets;
  append_number(points, soup.points.size(), ' ');
  points += "3 0 0\n";
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    append_number(points, i, ' ');
    for (int axis = 0; axis < 3; ++axis) append_number(points, soup.points[i][axis], axis < 2 ? ' ' : '\n');
  }
  append_number(tets, soup.tets.size(), ' ');
  tets += "4 0\n";
  for (std::size_t i = 0; i < soup.tets.size(); ++i) {
    append_number(tets, i, ' ');
    for (int corner = 0; corner < 4; ++corner) append_number(tets, soup.tets[i][corner], corner < 3 ? ' ' : '\n');
  }
  replace_file(std::filesystem::path(path).replace_extension(".node"), points);
  replace_file(std::filesystem::path(path).replace_extension(".ele"), tets);
}

}  // namespace griffith
