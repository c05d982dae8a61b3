#include "sim/meshing/orient_surface.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "sim/meshing/surface_edges.h"
#include "sim/meshing/triangle_tree.h"

namespace griffith {
namespace {

/// Neighbor across an edge, and whether its orientation agrees.
struct Neighbor {
  int triangle = 0;
  bool agrees = true;
};

std::vector<std::vector<Neighbor>> neighbors_of(const TriangleSurface& surface, const std::vector<HalfEdge>& sides) {
  std::vector<std::vector<Neighbor>> neighbors(surface.triangles.size());
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 2) return;
    const bool agrees = edge[0].forward != edge[1].forward;
    neighbors[edge[0].triangle].push_back({edge[1].triangle, agrees});
    neighbors[edge[1].triangle].push_back({edge[0].triangle, agrees});
  });
  return neighbors;
}

/// Part of the surface connected through edges of two triangles.
struct Shell {
  std::vector<int> triangles;
  bool closed = true;
  bool one_sided = false;
};

/// Collects the part of `start` and assigns a side (1 or −1) to each of its triangles.
Shell flood(int start, const std::vector<std::vector<Neighbor>>& neighbors, std::vector<int>& side) {
  Shell shell;
  shell.triangles = {start};
  side[start] = 1;
  for (std::size_t i = 0; i < shell.triangles.size(); ++i) {
    const int triangle = shell.triangles[i];
    shell.closed = shell.closed && neighbors[triangle].size() == 3;
    for (const Neighbor& next : neighbors[triangle]) {
      const int wanted = next.agrees ? side[triangle] : -side[triangle];
      if (side[next.triangle] == 0) {
        side[next.triangle] = wanted;
        shell.triangles.push_back(next.triangle);
      }
      shell.one_sided = shell.one_sided || side[next.triangle] != wanted;
    }
  }
  std::sort(shell.triangles.begin(), shell.triangles.end());
  return shell;
}

/// Flips triangles of a shell until they agree. Returns the number of flips.
int make_consistent(TriangleSurface& surface, const Shell& shell, const std::vector<int>& side) {
  double balance = 0;
  for (const int triangle : shell.triangles)
    balance += side[triangle] * area_vector(corners_of(surface, triangle)).norm();
  const int wrong = balance < 0 ? 1 : -1;
  int turned = 0;
  for (const int triangle : shell.triangles) {
    if (side[triangle] != wrong) continue;
    flip_triangle(surface, triangle);
    ++turned;
  }
  return turned;
}

TriangleSurface part_of(const TriangleSurface& surface, const Shell& shell) {
  TriangleSurface part;
  std::unordered_map<int, int> renumbered;
  for (const int triangle : shell.triangles) {
    std::array<int, 3>& corners = part.triangles.emplace_back(surface.triangles[triangle]);
    for (int& corner : corners) {
      const auto [entry, is_new] = renumbered.try_emplace(corner, static_cast<int>(part.points.size()));
      if (is_new) part.points.push_back(surface.points[corner]);
      corner = entry->second;
    }
  }
  return part;
}

/// Shell as a separate surface, with data to find other shells inside it.
struct ShellBody {
  TriangleSurface surface;
  TriangleTree tree;
  Eigen::AlignedBox3d box;
  double volume = 0;

  explicit ShellBody(TriangleSurface part)
      : surface(std::move(part)), tree(surface), box(bounds(surface)), volume(enclosed_volume(surface)) {}

  bool holds(const ShellBody& other) const {
    const Vec3& point = other.surface.points.front();
    return std::abs(volume) > std::abs(other.volume) && box.contains(point) &&
           std::abs(tree.winding_number(point)) > 0.5;
  }
};

/// Returns the largest of `bodies` that contains the body, or the body itself.
const ShellBody& outermost(const ShellBody& body, const std::vector<ShellBody>& bodies) {
  const ShellBody* result = &body;
  for (const ShellBody& other : bodies)
    if (other.holds(body) && std::abs(other.volume) > std::abs(result->volume)) result = &other;
  return *result;
}

/// Inverts the closed shells that are inside out. Returns their number.
int turn_inside_out_shells(TriangleSurface& surface, std::vector<Shell> shells) {
  std::erase_if(shells, [](const Shell& shell) { return !shell.closed || shell.one_sided; });
  std::vector<ShellBody> bodies;
  for (const Shell& shell : shells) bodies.emplace_back(part_of(surface, shell));
  int turned = 0;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (outermost(bodies[i], bodies).volume >= 0) continue;
    for (const int triangle : shells[i].triangles) flip_triangle(surface, triangle);
    ++turned;
  }
  return turned;
}

}  // namespace

void flip_triangle(TriangleSurface& surface, int triangle) {
  std::swap(surface.triangles[triangle][1], surface.triangles[triangle][2]);
  if (!surface.uvs.empty()) std::swap(surface.uvs[triangle][1], surface.uvs[triangle][2]);
  if (surface.normals.empty()) return;
  std::swap(surface.normals[triangle][1], surface.normals[triangle][2]);
  for (Vec3& normal : surface.normals[triangle]) normal = -normal;
}

Orientation orient_surface(TriangleSurface& surface) {
  const auto neighbors = neighbors_of(surface, half_edges(surface));
  std::vector<int> side(surface.triangles.size(), 0);
  std::vector<Shell> shells;
  Orientation result;
  for (std::size_t i = 0; i < side.size(); ++i) {
    if (side[i] != 0) continue;
    shells.push_back(flood(static_cast<int>(i), neighbors, side));
    if (shells.back().one_sided)
      ++result.one_sided_shells;
    else
      result.flipped_triangles += make_consistent(surface, shells.back(), side);
  }
  constexpr std::size_t kMaxShells = 2000;  // beyond this, nesting is not examined and orientations are kept
  if (shells.size() <= kMaxShells) result.inverted_shells = turn_inside_out_shells(surface, shells);
  return result;
}

}  // namespace griffith
