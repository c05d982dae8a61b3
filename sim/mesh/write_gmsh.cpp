#include "sim/core/number_text.h"
#include "sim/core/replace_file.h"
#include "sim/mesh/write_mesh.h"

namespace griffith {

std::string gmsh_text(const TetSoup& soup) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n";
  append_number(text, soup.points.size(), '\n');
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    append_number(text, i + 1, ' ');
    for (int axis = 0; axis < 3; ++axis) append_number(text, soup.points[i][axis], axis < 2 ? ' ' : '\n');
  }
  text += "$EndNodes\n$Elements\n";
  append_number(text, soup.tets.size(), '\n');
  for (std::size_t i = 0; i < soup.tets.size(); ++i) {
    append_number(text, i + 1, ' ');
    text += "4 2 1 1 ";  // a tet with two tags: physical group and entity
    for (int corner = 0; corner < 4; ++corner) append_number(text, soup.tets[i][corner] + 1, corner < 3 ? ' ' : '\n');
  }
  text += "$EndElements\n";
  return text;
}

void write_gmsh(const std::filesystem::path& path, const TetSoup& soup) { replace_file(path, gmsh_text(soup)); }

}  // namespace griffith
