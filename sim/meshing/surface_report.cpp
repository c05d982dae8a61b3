#include "sim/meshing/surface_report.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/geometry/disjoint_sets.h"
#include "sim/meshing/orient_surface.h"
#include "sim/meshing/surface_edges.h"

namespace griffith {
namespace {

constexpr double kSmallest = 1e-3, kLargest = 1e3;  ///< sizes beyond suggest a wrong unit [m]
/// Largest area of flat triangles, relative to their longest edge squared.
constexpr double kFlatFraction = 1e-8;

/// Keeps the values that are marked with 1.
template <class T>
void keep(std::vector<T>& values, const std::vector<char>& kept) {
  if (values.empty()) return;
  std::size_t count = 0;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) values[count++] = values[i];
  values.resize(count);
}

int remove_repeated_triangles(TriangleSurface& surface) {
  std::vector<char> kept(surface.triangles.size(), 1);
  std::set<std::array<int, 3>> seen;
  int removed = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    auto corners = surface.triangles[i];
    std::sort(corners.begin(), corners.end());
    const bool has_twice = corners[0] == corners[1] || corners[1] == corners[2];
    kept[i] = !has_twice && seen.insert(corners).second;
    removed += !kept[i];
  }
  keep(surface.uvs, kept);
  keep(surface.normals, kept);
  keep(surface.triangles, kept);
  weld_points(surface);
  return removed;
}

int count_flat_triangles(const TriangleSurface& surface) {
  int count = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto corners = corners_of(surface, static_cast<int>(i));
    double longest = 0;
    for (int j = 0; j < 3; ++j) longest = std::max(longest, (corners[(j + 1) % 3] - corners[j]).squaredNorm());
    count += area_vector(corners).norm() < kFlatFraction * longest;
  }
  return count;
}

void count_edges(const TriangleSurface& surface, const std::vector<HalfEdge>& sides, SurfaceReport& report) {
  DisjointSets loops(static_cast<int>(surface.points.size()));
  std::vector<int> on_boundary;
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    const Vec3 middle = (surface.points[edge[0].low] + surface.points[edge[0].high]) / 2;
    if (edge.size() == 1) {
      if (report.boundary_edges++ == 0) report.first_boundary = middle;
      loops.join(edge[0].low, edge[0].high);
      on_boundary.push_back(edge[0].low);
    } else if (edge.size() > 2 && report.crowded_edges++ == 0) {
      report.first_crowded = middle;
    }
  });
  for (int& point : on_boundary) point = loops.find(point);
  std::sort(on_boundary.begin(), on_boundary.end());
  report.boundary_loops = static_cast<int>(std::unique(on_boundary.begin(), on_boundary.end()) - on_boundary.begin());
}

/// Returns the corner of `triangle` at `point`, counted over all triangles.
int corner_at(const TriangleSurface& surface, int triangle, int point) {
  const auto& corners = surface.triangles[triangle];
  return 3 * triangle + static_cast<int>(std::find(corners.begin(), corners.end(), point) - corners.begin());
}

/// Counts points with more than one fan: corners that triangles join across edges form a fan.
void count_pinched_points(const TriangleSurface& surface, const std::vector<HalfEdge>& sides, SurfaceReport& report) {
  DisjointSets fans(3 * static_cast<int>(surface.triangles.size()));
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    for (const HalfEdge& side : edge)
      for (const int point : {side.low, side.high})
        fans.join(corner_at(surface, edge[0].triangle, point), corner_at(surface, side.triangle, point));
  });
  std::vector<int> fans_at(surface.points.size(), 0);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (int corner = 0; corner < 3; ++corner) {
      const int index = 3 * static_cast<int>(i) + corner;
      fans_at[surface.triangles[i][corner]] += fans.find(index) == index;
    }
  for (std::size_t i = 0; i < fans_at.size(); ++i)
    if (fans_at[i] > 1 && report.pinched_points++ == 0) report.first_pinched = surface.points[i];
}

/// Returns "1 triangle" or "3 triangles".
std::string count_text(int count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// Returns "3 edges belong ..." or "1 edge belongs ...".
std::string sentence(int count, const char* noun, const char* one, const char* many) {
  return count_text(count, noun) + (count == 1 ? one : many);
}

void add_repairs(const SurfaceReport& report, std::vector<std::string>& list) {
  if (report.removed_triangles > 0)
    list.push_back(sentence(report.removed_triangles, "repeated or collapsed triangle", " was", " were") + " left out");
  if (report.flipped_triangles > 0)
    list.push_back(count_text(report.flipped_triangles, "triangle") +
                   " faced the other way than the surface round it: turned");
  if (report.inverted_shells > 0)
    list.push_back(sentence(report.inverted_shells, "shell", " was", " were") + " inside out: turned");
}

void add_defects(const SurfaceReport& report, std::vector<std::string>& list) {
  if (report.boundary_edges > 0)
    list.push_back("the surface is open: " + count_text(report.boundary_edges, "edge") + " in " +
                   count_text(report.boundary_loops, "loop") + " without a second triangle, the first near " +
                   place_text(report.first_boundary));
  if (report.crowded_edges > 0)
    list.push_back(sentence(report.crowded_edges, "edge", " belongs", " belong") +
                   " to more than two triangles, the first near " + place_text(report.first_crowded));
  if (report.pinched_points > 0)
    list.push_back(sentence(report.pinched_points, "point", " joins", " join") +
                   " parts that share no edge there, the first at " + place_text(report.first_pinched));
  if (report.one_sided_shells > 0)
    list.push_back(sentence(report.one_sided_shells, "shell", " has", " have") +
                   " one side only, as a Möbius strip, and cannot be oriented");
  const SelfIntersections& crossings = report.self_intersections;
  if (crossings.pairs > 0)
    list.push_back(std::string("the surface passes through itself: ") + (crossings.all_known ? "" : "at least ") +
                   count_text(crossings.pairs, "pair") + " of triangles, the first " +
                   std::to_string(crossings.first[0]) + " and " + std::to_string(crossings.first[1]) + " near " +
                   place_text(crossings.place));
  if (report.flat_triangles > 0)
    list.push_back(sentence(report.flat_triangles, "triangle", " has", " have") + " next to no area");
}

}  // namespace

SurfaceReport prepare_surface(TriangleSurface& surface, const std::string& name) {
  SurfaceReport report;
  report.removed_triangles = remove_repeated_triangles(surface);
  if (surface.triangles.empty())
    throw InputError(name, "has no triangle with three different corners", "export the surface again");
  const Orientation orientation = orient_surface(surface);
  report.flipped_triangles = orientation.flipped_triangles;
  report.inverted_shells = orientation.inverted_shells;
  report.one_sided_shells = orientation.one_sided_shells;
  const std::vector<HalfEdge> sides = half_edges(surface);
  count_edges(surface, sides, report);
  count_pinched_points(surface, sides, report);
  const std::vector<int> parts = edge_connected_parts(surface, sides, false);
  report.shells = 1 + *std::max_element(parts.begin(), parts.end());
  report.flat_triangles = count_flat_triangles(surface);
  report.self_intersections = find_self_intersections(surface);
  report.points = static_cast<int>(surface.points.size());
  report.triangles = static_cast<int>(surface.triangles.size());
  report.volume = enclosed_volume(surface);
  report.area = surface_area(surface);
  report.minimum = bounds(surface).min();
  report.maximum = bounds(surface).max();
  return report;
}

std::vector<std::string> findings(const SurfaceReport& report) {
  std::vector<std::string> list;
  add_repairs(report, list);
  add_defects(report, list);
  if (report.shells > 1) list.push_back("the surface has " + std::to_string(report.shells) + " separate shells");
  char size[64];
  std::snprintf(size, sizeof size, "the surface measures %.3g m across: ", report.size());
  if (report.size() < kSmallest) list.push_back(std::string(size) + "if its unit is not a meter, set a larger scale");
  if (report.size() > kLargest) list.push_back(std::string(size) + "if its unit is not a meter, set a smaller scale");
  return list;
}

}  // namespace griffith
