#include "tests/mesh/cell_files.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>

#include "sim/mesh/topology.h"
#include "tests/random_values.h"

namespace griffith::testing {
namespace {

using enum CellShape;

/// The corners of hexahedron (i, j, k) in the order of files.
std::array<int, 8> hexahedron_at(int i, int j, int k, int n) {
  const auto node = [&](int x, int y, int z) { return i + x + (n + 1) * (j + y + (n + 1) * (k + z)); };
  return {node(0, 0, 0), node(1, 0, 0), node(1, 1, 0), node(0, 1, 0),
          node(0, 0, 1), node(1, 0, 1), node(1, 1, 1), node(0, 1, 1)};
}

void add_part(CellMesh& mesh, CellShape shape, const std::array<int, 8>& c, std::initializer_list<int> corners) {
  std::vector<int> nodes;
  for (const int corner : corners) nodes.push_back(corner < 8 ? c[corner] : static_cast<int>(mesh.points.size()) - 1);
  mesh.add(shape, nodes);
}

void add_pyramids(CellMesh& mesh, const std::array<int, 8>& c) {
  Vec3 sum = Vec3::Zero();
  for (const int node : c) sum += mesh.points[node];
  mesh.points.push_back(sum / 8);
  constexpr int kFaces[6][4] = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
  for (const auto& f : kFaces) add_part(mesh, pyramid, c, {f[0], f[1], f[2], f[3], 8});
}

void add_tets(CellMesh& mesh, const std::array<int, 8>& c, bool mirrored) {
  constexpr int kTets[2][5][4] = {{{0, 5, 2, 7}, {0, 1, 2, 5}, {0, 2, 3, 7}, {0, 7, 4, 5}, {2, 7, 5, 6}},
                                  {{1, 6, 3, 4}, {0, 1, 3, 4}, {1, 2, 3, 6}, {1, 6, 4, 5}, {3, 6, 7, 4}}};
  for (const auto& t : kTets[mirrored ? 1 : 0]) add_part(mesh, tetrahedron, c, {t[0], t[1], t[2], t[3]});
}

void add_prisms(CellMesh& mesh, const std::array<int, 8>& c, bool mirrored) {
  if (mirrored) {
    add_part(mesh, prism, c, {0, 1, 3, 4, 5, 7});
    add_part(mesh, prism, c, {1, 2, 3, 5, 6, 7});
  } else {
    add_part(mesh, prism, c, {0, 1, 2, 4, 5, 6});
    add_part(mesh, prism, c, {0, 2, 3, 4, 6, 7});
  }
}

/// Column by column: prisms cut their tops, so all of a column are cut alike.
void add_cells(CellMesh& mesh, int n, RandomValues& random) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int column = random.index(4);
      for (int k = 0; k < n; ++k) {
        const auto c = hexahedron_at(i, j, k, n);
        const int kind = random.index(3);
        if (column < 2)
          add_prisms(mesh, c, column == 1);
        else if (kind == 0 && (i + j + k) % 2 == 0)
          add_tets(mesh, c, random.index(2) == 1);
        else if (kind == 1)
          add_pyramids(mesh, c);
        else
          mesh.add(hexahedron, {c.begin(), c.end()});
      }
    }
}

void renumber(CellMesh& mesh, RandomValues& random) {
  std::vector<int> number(mesh.points.size());
  std::iota(number.begin(), number.end(), 0);
  for (std::size_t i = number.size(); i > 1; --i) std::swap(number[i - 1], number[random.index(static_cast<int>(i))]);
  std::vector<Vec3> points(mesh.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[number[i]] = mesh.points[i];
  mesh.points = std::move(points);
  for (VolumeCell& cell : mesh.cells)
    for (int i = 0; i < corner_count(cell.shape); ++i) cell.corners[i] = number[cell.corners[i]];
}

struct FileType {
  int gmsh, vtk;
  const char* medit;
};

FileType type_of(CellShape shape) {
  switch (shape) {
    case tetrahedron:
      return {4, 10, "Tetrahedra"};
    case pyramid:
      return {7, 14, "Pyramids"};
    case prism:
      return {6, 13, "Prisms"};
    default:
      return {5, 12, "Hexahedra"};
  }
}

std::string numbers(const VolumeCell& cell, int first) {
  std::string text;
  for (int i = 0; i < corner_count(cell.shape); ++i) text += " " + std::to_string(cell.corners[i] + first);
  return text;
}

std::string points_text(const CellMesh& mesh, bool numbered, const char* end) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (numbered) out << i + 1 << " ";
    out << mesh.points[i].x() << " " << mesh.points[i].y() << " " << mesh.points[i].z() << end;
  }
  return out.str();
}

std::string gmsh_2(const CellMesh& mesh) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(mesh.points.size()) + "\n" +
                     points_text(mesh, true, "\n") + "$EndNodes\n$Elements\n" + std::to_string(mesh.cells.size() + 2) +
                     "\n1 2 2 1 1 1 2 3\n2 1 2 1 1 1 2\n";
  for (const VolumeCell& cell : mesh.cells)
    text += "3 " + std::to_string(type_of(cell.shape).gmsh) + " 2 1 1" + numbers(cell, 1) + "\n";
  return text + "$EndElements\n";
}

std::string gmsh_4(const CellMesh& mesh) {
  const std::string count = std::to_string(mesh.points.size()), cells = std::to_string(mesh.cells.size() + 2);
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 " + count + " 1 " + count + "\n3 1 0 " + count;
  for (std::size_t i = 1; i <= mesh.points.size(); ++i) text += "\n" + std::to_string(i);
  text += "\n" + points_text(mesh, false, "\n") + "$EndNodes\n$Elements\n" + cells + " " + cells + " 1 " + cells +
          "\n2 1 2 1\n1 1 2 3\n1 1 1 1\n2 1 2\n";
  for (const VolumeCell& cell : mesh.cells)
    text += "3 1 " + std::to_string(type_of(cell.shape).gmsh) + " 1\n3" + numbers(cell, 1) + "\n";
  return text + "$EndElements\n";
}

std::string medit(const CellMesh& mesh) {
  std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices " + std::to_string(mesh.points.size()) + "\n" +
                     points_text(mesh, false, " 0\n") + "Triangles 1\n1 2 3 0\nEdges 1\n1 2 0\n";
  for (const CellShape shape : {tetrahedron, pyramid, prism, hexahedron}) {
    text += std::string(type_of(shape).medit) + " " +
            std::to_string(std::ranges::count(mesh.cells, shape, &VolumeCell::shape)) + "\n";
    for (const VolumeCell& cell : mesh.cells)
      if (cell.shape == shape) text += numbers(cell, 1) + " 0\n";
  }
  return text + "End\n";
}

std::string vtk(const CellMesh& mesh) {
  std::string cells = "3 0 1 2\n2 0 1\n", types = "5 3";
  int size = 7;
  for (const VolumeCell& cell : mesh.cells) {
    const int corners = corner_count(cell.shape);
    cells += std::to_string(corners) + numbers(cell, 0) + "\n";
    types += " " + std::to_string(type_of(cell.shape).vtk);
    size += corners + 1;
  }
  const std::string count = std::to_string(mesh.cells.size() + 2);
  return "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
         std::to_string(mesh.points.size()) + " double\n" + points_text(mesh, false, "\n") + "CELLS " + count + " " +
         std::to_string(size) + "\n" + cells + "CELL_TYPES " + count + "\n" + types + "\n";
}

std::string vtu(const CellMesh& mesh) {
  std::string connectivity = "0 1 2 0 1", types = "5 3", offsets = "3 5";
  int end = 5;
  for (const VolumeCell& cell : mesh.cells) {
    connectivity += numbers(cell, 0);
    types += " " + std::to_string(type_of(cell.shape).vtk);
    offsets += " " + std::to_string(end += corner_count(cell.shape));
  }
  const auto array = [](const std::string& attributes, const std::string& values) {
    return "<DataArray " + attributes + " format=\"ascii\">" + values + "</DataArray>\n";
  };
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
         std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" + std::to_string(mesh.cells.size() + 2) +
         "\">\n<Points>" + array("type=\"Float64\" NumberOfComponents=\"3\"", points_text(mesh, false, "\n")) +
         "</Points>\n<Cells>" + array("type=\"Int32\" Name=\"connectivity\"", connectivity) +
         array("type=\"Int32\" Name=\"offsets\"", offsets) + array("type=\"UInt8\" Name=\"types\"", types) +
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace

void CellMesh::add(CellShape shape, std::vector<int> corners) {
  VolumeCell& cell = cells.emplace_back(VolumeCell{shape, {}});
  std::ranges::copy(corners, cell.corners.begin());
}

CellMesh mixed_block(int n, double jitter, int seed) {
  RandomValues random(seed);
  CellMesh mesh;
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        Vec3 point(i, j, k);
        const Vec3 moved = random.vector(jitter);
        for (int axis = 0; axis < 3; ++axis)
          if (point[axis] > 0 && point[axis] < n) point[axis] += moved[axis];
        mesh.points.push_back(point / n);
      }
  add_cells(mesh, n, random);
  renumber(mesh, random);
  return mesh;
}

std::vector<SampleFile> cell_files(const CellMesh& mesh) {
  return {{"cells, gmsh 2", "a.msh", {{"a.msh", gmsh_2(mesh)}}, 2},
          {"cells, gmsh 4", "a.msh", {{"a.msh", gmsh_4(mesh)}}, 2},
          {"cells, medit", "a.mesh", {{"a.mesh", medit(mesh)}}, 2},
          {"cells, vtk", "a.vtk", {{"a.vtk", vtk(mesh)}}, 2},
          {"cells, vtu", "a.vtu", {{"a.vtu", vtu(mesh)}}, 2}};
}

}  // namespace griffith::testing
