#include "sim/mesh/hex_mesh.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <tuple>

namespace griffith {
namespace {

/// Faces of a cell, corners counterclockwise seen from outside.
constexpr std::array<std::array<int, 4>, 6> kHexFaces = {
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

using Quad = std::array<int, 4>;
using Triangle = std::array<int, 3>;

Quad cell_face(const std::array<int, 8>& cell, int face) {
  Quad quad;
  for (int i = 0; i < 4; ++i) quad[i] = cell[kHexFaces[face][i]];
  return quad;
}

/// Returns the two triangles of a quad, split through its smallest node, so that both cells at the face agree.
std::array<Triangle, 2> split_quad(const HexMesh& hexes, Quad quad) {
  const auto original = [&](int node) { return hexes.original(node); };
  std::rotate(quad.begin(), std::ranges::min_element(quad, {}, original), quad.end());
  return {{{quad[0], quad[1], quad[2]}, {quad[0], quad[2], quad[3]}}};
}

std::vector<std::array<int, 4>> cut_kuhn(const HexMesh& hexes) {
  std::vector<std::array<int, 4>> tets;
  tets.reserve(6 * hexes.cells.size());
  for (const auto& cell : hexes.cells) {
    const int apex = *std::ranges::min_element(cell, {}, [&](int node) { return hexes.original(node); });
    for (int face = 0; face < 6; ++face) {
      const Quad quad = cell_face(cell, face);
      if (std::find(quad.begin(), quad.end(), apex) != quad.end()) continue;
      for (const auto& [a, b, c] : split_quad(hexes, quad)) tets.push_back({apex, a, b, c});
    }
  }
  return tets;
}

/// Returns 0 or 1 per node, different at the two ends of every cell edge.
std::vector<std::int8_t> alternate_colors(const HexMesh& hexes) {
  std::vector<std::vector<int>> cells_of_node(hexes.points.size());
  for (int i = 0; i < static_cast<int>(hexes.cells.size()); ++i)
    for (int node : hexes.cells[i]) cells_of_node[node].push_back(i);
  std::vector<std::int8_t> colors(hexes.points.size(), -1);
  std::vector<int> queue;
  for (int seed = 0; seed < static_cast<int>(colors.size()); ++seed) {
    if (colors[seed] >= 0) continue;
    colors[seed] = 0;
    queue.assign(1, seed);
    while (!queue.empty()) {
      const int node = queue.back();
      queue.pop_back();
      for (int i : cells_of_node[node]) {
        const auto& cell = hexes.cells[i];
        const auto corner = static_cast<unsigned>(std::find(cell.begin(), cell.end(), node) - cell.begin());
        for (unsigned axis : {1u, 2u, 4u}) {
          const int other = cell[corner ^ axis];
          assert(colors[other] != colors[node] && "an edge cycle of odd length");
          if (colors[other] >= 0) continue;
          colors[other] = static_cast<std::int8_t>(1 - colors[node]);
          queue.push_back(other);
        }
      }
    }
  }
  return colors;
}

std::vector<std::array<int, 4>> cut_five_tet(const HexMesh& hexes) {
  // The inner tet joins corners 0, 3, 5, 6 or, mirrored, 1, 2, 4, 7; the others cut off the remaining corners.
  constexpr int kCuts[2][5][4] = {{{0, 5, 3, 6}, {0, 1, 3, 5}, {0, 3, 2, 6}, {0, 6, 4, 5}, {3, 6, 5, 7}},
                                  {{1, 7, 2, 4}, {0, 1, 2, 4}, {1, 3, 2, 7}, {1, 5, 7, 4}, {2, 6, 4, 7}}};
  const auto colors = alternate_colors(hexes);
  std::vector<std::array<int, 4>> tets;
  tets.reserve(5 * hexes.cells.size());
  for (const auto& cell : hexes.cells)
    for (const auto& cut : kCuts[colors[cell[0]]])
      tets.push_back({cell[cut[0]], cell[cut[1]], cell[cut[2]], cell[cut[3]]});
  return tets;
}

struct CellFace {
  Quad key;  ///< the face's nodes, ascending
  int cell, face;
  bool operator<(const CellFace& other) const { return std::tie(key, cell) < std::tie(other.key, other.cell); }
};

/// Returns all faces of all cells, with the two sides of an inner face in sequence.
std::vector<CellFace> sorted_faces(const HexMesh& hexes) {
  std::vector<CellFace> faces;
  faces.reserve(6 * hexes.cells.size());
  for (int cell = 0; cell < static_cast<int>(hexes.cells.size()); ++cell)
    for (int face = 0; face < 6; ++face) {
      Quad key = cell_face(hexes.cells[cell], face);
      std::sort(key.begin(), key.end());
      faces.push_back({key, cell, face});
    }
  std::sort(faces.begin(), faces.end());
  return faces;
}

TetSoup cut_bcc(const HexMesh& hexes) {
  TetSoup soup;
  soup.points = hexes.points;
  const int first_center = static_cast<int>(hexes.points.size());
  for (const auto& cell : hexes.cells) {
    Vec3 sum = Vec3::Zero();
    for (int node : cell) sum += hexes.points[node];
    soup.points.push_back(sum / 8);
  }
  const auto faces = sorted_faces(hexes);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Quad quad = cell_face(hexes.cells[faces[i].cell], faces[i].face);
    const int center = first_center + faces[i].cell;
    if (i + 1 < faces.size() && faces[i].key == faces[i + 1].key) {
      const int other = first_center + faces[++i].cell;
      for (int edge = 0; edge < 4; ++edge) soup.tets.push_back({center, quad[edge], quad[(edge + 1) % 4], other});
    } else {
      for (const auto& [a, b, c] : split_quad(hexes, quad)) soup.tets.push_back({center, a, b, c});
    }
  }
  return soup;
}

}  // namespace

TetSoup cut_into_tets(const HexMesh& hexes, BoxPattern pattern) {
  switch (pattern) {
    case BoxPattern::kuhn:
      return {hexes.points, cut_kuhn(hexes)};
    case BoxPattern::five_tet:
      return {hexes.points, cut_five_tet(hexes)};
    case BoxPattern::bcc:
      return cut_bcc(hexes);
  }
  assert(false && "unknown pattern");
  return {};
}

void open_slit(HexMesh& mesh, const Vec3& normal, const std::function<bool(const Vec3& point)>& inside) {
  for (int node = static_cast<int>(mesh.originals.size()); node < static_cast<int>(mesh.points.size()); ++node)
    mesh.originals.push_back(node);
  std::map<int, int> copies;
  for (std::array<int, 8>& cell : mesh.cells) {
    Vec3 center = Vec3::Zero();
    for (const int corner : cell) center += mesh.points[corner] / 8;
    for (int& corner : cell) {
      const Vec3 point = mesh.points[corner];
      if (!inside(point) || (center - point).dot(normal) < 0) continue;
      const auto [copy, is_new] = copies.emplace(corner, static_cast<int>(mesh.points.size()));
      if (is_new) {
        mesh.points.push_back(point);
        mesh.originals.push_back(mesh.originals[corner]);
      }
      corner = copy->second;
    }
  }
}

int HexMeshBuilder::node(const Key& key, const Vec3& position) {
  const auto [entry, is_new] = nodes_.emplace(key, static_cast<int>(mesh_.points.size()));
  if (is_new) mesh_.points.push_back(position);
  return entry->second;
}

void HexMeshBuilder::add_cell(std::array<int, 8> corners) {
  const Vec3& origin = mesh_.points[corners[0]];
  const Vec3 x = mesh_.points[corners[1]] - origin, y = mesh_.points[corners[2]] - origin,
             z = mesh_.points[corners[4]] - origin;
  if (x.cross(y).dot(z) < 0) {
    for (int c = 0; c < 8; c += 2) std::swap(corners[c], corners[c + 1]);
  }
  mesh_.cells.push_back(corners);
}

}  // namespace griffith
