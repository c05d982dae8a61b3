#include "sim/mesh/mesh_report.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/core/tet_edge_corners.h"
#include "sim/mesh/topology.h"

namespace griffith {
namespace {

constexpr double kFlatVolume = 1e-12;  ///< fraction of the longest edge cubed

using Tet = std::array<int, 4>;

Tet sorted(Tet tet) {
  std::sort(tet.begin(), tet.end());
  return tet;
}

std::string list_nodes(std::span<const int> nodes) {
  std::string text;
  for (int node : nodes) text += (text.empty() ? "" : ", ") + std::to_string(node);
  return text;
}

void check_corners(const TetSoup& soup, const std::string& name) {
  if (soup.tets.empty()) throw InputError(name, "has no tetrahedra", "a volume mesh of tetrahedra is needed");
  const int points = static_cast<int>(soup.points.size());
  for (std::size_t i = 0; i < soup.tets.size(); ++i) {
    const std::string tet = "tet " + std::to_string(i);
    for (int corner : soup.tets[i]) {
      if (corner < 0 || corner >= points)
        throw InputError(name, tet + " has the corner " + std::to_string(corner),
                         "nodes are 0 to " + std::to_string(points - 1));
      if (!soup.points[corner].allFinite())
        throw InputError(name, "node " + std::to_string(corner) + " is not finite", "coordinates are finite numbers");
    }
    const Tet corners = sorted(soup.tets[i]);
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
      throw InputError(name, tet + " has the same corner twice: " + list_nodes(soup.tets[i]), "four different nodes");
  }
}

/// Moves the kept elements forward. Returns the new index of each element, or -1.
template <class T>
std::vector<int> keep_only(std::vector<T>& elements, const std::vector<char>& keep) {
  std::vector<int> new_index(elements.size(), -1);
  int kept = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (!keep[i]) continue;
    elements[kept] = elements[i];
    new_index[i] = kept++;
  }
  elements.resize(kept);
  return new_index;
}

void remove_duplicate_tets(TetSoup& soup, MeshReport& report) {
  std::vector<std::pair<Tet, int>> order;
  for (std::size_t i = 0; i < soup.tets.size(); ++i) order.emplace_back(sorted(soup.tets[i]), static_cast<int>(i));
  std::sort(order.begin(), order.end());
  std::vector<char> keep(soup.tets.size(), 1);
  for (std::size_t i = 1; i < order.size(); ++i)
    if (order[i].first == order[i - 1].first) keep[order[i].second] = 0;
  report.removed_tets = static_cast<int>(std::count(keep.begin(), keep.end(), 0));
  report.tet_of_element = keep_only(soup.tets, keep);
}

void remove_unused_points(TetSoup& soup, MeshReport& report) {
  std::vector<char> keep(soup.points.size(), 0);
  for (const Tet& tet : soup.tets)
    for (int corner : tet) keep[corner] = 1;
  report.removed_nodes = static_cast<int>(std::count(keep.begin(), keep.end(), 0));
  const std::vector<int> node_of_point = keep_only(soup.points, keep);
  for (std::size_t point = 0; point < keep.size(); ++point)
    if (keep[point]) report.point_of_node.push_back(static_cast<int>(point));
  for (Tet& tet : soup.tets)
    for (int& corner : tet) corner = node_of_point[corner];
}

double longest_edge(const std::array<Vec3, 4>& corners) {
  double longest = 0;
  for (auto [a, b] : kTetEdges) longest = std::max(longest, (corners[b] - corners[a]).norm());
  return longest;
}

std::array<Vec3, 4> corner_positions(const TetSoup& soup, const Tet& tet) {
  return {soup.points[tet[0]], soup.points[tet[1]], soup.points[tet[2]], soup.points[tet[3]]};
}

void check_volumes_and_orient(TetSoup& soup, const std::string& name, MeshReport& report) {
  int flat = 0, first_flat = -1;
  for (std::size_t i = 0; i < soup.tets.size(); ++i) {
    const auto x = corner_positions(soup, soup.tets[i]);
    const double volume = signed_volume(x[0], x[1], x[2], x[3]);
    // Not (a > b): a volume that overflowed to infinity or NaN is as unusable as none.
    if (!(std::abs(volume) >= kFlatVolume * std::pow(longest_edge(x), 3) && volume != 0 && std::isfinite(volume))) {
      if (flat++ == 0) first_flat = static_cast<int>(i);
    } else if (volume < 0) {
      std::swap(soup.tets[i][1], soup.tets[i][2]);
      ++report.reoriented_tets;
    }
  }
  if (flat > 0)
    throw InputError(name,
                     "tet " + std::to_string(first_flat) + " (nodes " + list_nodes(soup.tets[first_flat]) +
                         ") has no volume; " + std::to_string(flat) + " such in total",
                     "remove flat tetrahedra or mesh again");
}

struct Face {
  std::array<int, 3> key;
  int tet;
  bool flipped;  ///< the outward order of its nodes is an odd permutation of `key`
  bool operator<(const Face& other) const { return std::tie(key, tet) < std::tie(other.key, other.tet); }
};

Face make_face(const Tet& tet, int index, int face) {
  std::array<int, 3> nodes;
  for (int i = 0; i < 3; ++i) nodes[i] = tet[kTetFaces[face][i]];
  const bool flipped = (nodes[0] > nodes[1]) ^ (nodes[1] > nodes[2]) ^ (nodes[0] > nodes[2]);
  std::sort(nodes.begin(), nodes.end());
  return {nodes, index, flipped};
}

void check_faces(const TetSoup& soup, const std::string& name, MeshReport& report) {
  std::vector<Face> faces;
  faces.reserve(4 * soup.tets.size());
  for (std::size_t i = 0; i < soup.tets.size(); ++i)
    for (int face = 0; face < 4; ++face) faces.push_back(make_face(soup.tets[i], static_cast<int>(i), face));
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (faces[i].key != faces[i - 1].key) continue;
    if (i + 1 < faces.size() && faces[i + 1].key == faces[i].key)
      throw InputError(name, "the face of nodes " + list_nodes(faces[i].key) + " belongs to more than two tets",
                       "a face has one tet on either side; remove overlapping tetrahedra");
    if (faces[i].flipped == faces[i - 1].flipped) ++report.overlapping_faces;
  }
}

int count_coincident_points(const std::vector<Vec3>& points) {
  std::vector<std::array<double, 3>> sorted_points;
  for (const Vec3& p : points)
    sorted_points.push_back({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0});  // +0.0 removes negative zeros
  std::sort(sorted_points.begin(), sorted_points.end());
  int coincident = 0;
  for (std::size_t i = 1; i < sorted_points.size(); ++i) coincident += sorted_points[i] == sorted_points[i - 1];
  return coincident;
}

/// Counts edges at which more than two surface faces meet. Such an edge joins parts that have no other contact there.
int count_pinched_edges(const TetMesh& mesh) {
  std::vector<std::array<NodeId, 2>> edges;
  for (const auto& [tet, face] : surface_faces(mesh)) {
    const auto nodes = face_nodes(mesh, tet, face);
    for (int i = 0; i < 3; ++i)
      edges.push_back({std::min(nodes[i], nodes[(i + 1) % 3]), std::max(nodes[i], nodes[(i + 1) % 3])});
  }
  std::sort(edges.begin(), edges.end());
  int pinched = 0;
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    pinched += next - edge > 2;
    edge = next;
  }
  return pinched;
}

/// Gives each part of a node's star that shares no face there with the rest a separate node.
void part_pinched_nodes(TetSoup& soup, const TetMesh& mesh, MeshReport& report) {
  for (int node = 0; node < mesh.node_count(); ++node) {
    const std::vector<std::vector<TetId>> parts = star_components(mesh, NodeId(node));
    if (parts.size() == 1) continue;
    if (report.pinched_nodes++ == 0) report.first_pinched = soup.points[node];
    for (std::size_t i = 1; i < parts.size(); ++i) {
      for (TetId tet : parts[i])
        soup.tets[tet][local_corner(mesh, tet, NodeId(node))] = static_cast<int>(soup.points.size());
      soup.points.push_back(Vec3(soup.points[node]));
      report.point_of_node.push_back(int(report.point_of_node[node]));
    }
  }
}

void measure(const TetSoup& soup, MeshReport& report) {
  report.nodes = static_cast<int>(soup.points.size());
  report.tets = static_cast<int>(soup.tets.size());
  report.minimum = report.maximum = soup.points[0];
  for (const Vec3& point : soup.points) {
    report.minimum = report.minimum.cwiseMin(point);
    report.maximum = report.maximum.cwiseMax(point);
  }
  for (const Tet& tet : soup.tets) {
    const auto x = corner_positions(soup, tet);
    const double quality = tet_quality(x[0], x[1], x[2], x[3]);
    report.worst_quality = std::min(report.worst_quality, quality);
    report.slivers += quality < kSliverQuality;
    report.volume += signed_volume(x[0], x[1], x[2], x[3]);
  }
}

}  // namespace

double tet_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<Vec3, 4> x = {a, b, c, d};
  double sum = 0;
  for (auto [i, j] : kTetEdges) sum += (x[j] - x[i]).squaredNorm();
  const double rms_edge = std::sqrt(sum / 6);
  return 6 * std::sqrt(2.0) * signed_volume(a, b, c, d) / (rms_edge * rms_edge * rms_edge);
}

MeshReport prepare(TetSoup& soup, const std::string& name, TetMesh* mesh) {
  MeshReport report;
  // Checks come before points are removed, so that messages number nodes as the file does.
  check_corners(soup, name);
  check_volumes_and_orient(soup, name, report);
  remove_duplicate_tets(soup, report);
  check_faces(soup, name, report);
  remove_unused_points(soup, report);
  report.coincident_nodes = count_coincident_points(soup.points);
  TetMesh built = build_mesh(soup);
  part_pinched_nodes(soup, built, report);
  if (report.pinched_nodes > 0) built = build_mesh(soup);
  measure(soup, report);
  report.pinched_edges = count_pinched_edges(built);
  report.pieces = static_cast<int>(connected_components(built).size());
  if (mesh != nullptr) *mesh = std::move(built);
  return report;
}

std::vector<std::string> findings(const MeshReport& report) {
  std::vector<std::string> list;
  const auto add = [&](int count, const std::string& what) {
    if (count > 0) list.push_back(std::to_string(count) + what);
  };
  add(report.reoriented_tets, " tets had their corners in the wrong order; repaired");
  add(report.removed_tets, " tets repeated an earlier one; removed");
  add(report.removed_nodes, " nodes belonged to no tet; removed");
  add(report.coincident_nodes, " nodes lie on another node: a slit, or parts that are not joined");
  add(report.overlapping_faces, " faces have both tets on the same side: material overlaps");
  add(report.pinched_nodes,
      " nodes joined parts that share no face there; parted, the first at " + place_text(report.first_pinched));
  add(report.pinched_edges, " edges join parts that share no face there");
  add(report.slivers, " slivers: slow to solve, with poor stresses");
  add(report.pieces > 1 ? report.pieces : 0, " separate pieces");
  return list;
}

}  // namespace griffith
