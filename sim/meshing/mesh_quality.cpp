#include "sim/meshing/mesh_quality.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "sim/mesh/topology.h"

namespace griffith {
namespace {

constexpr std::array<std::array<int, 2>, 6> kEdges = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
constexpr double kDegrees = 180 / std::numbers::pi, kDihedralBin = 10, kAspectBin = 0.5;

std::array<Vec3, 4> corners_of(const TetSoup& soup, std::size_t tet) {
  const auto& [a, b, c, d] = soup.tets[tet];
  return {soup.points[a], soup.points[b], soup.points[c], soup.points[d]};
}

/// Returns area vectors out of the tet, face i opposite corner i.
std::array<Vec3, 4> face_areas(const std::array<Vec3, 4>& corners) {
  std::array<Vec3, 4> areas;
  for (int face = 0; face < 4; ++face) {
    const auto& [a, b, c] = kTetFaces[face];
    areas[face] = (corners[b] - corners[a]).cross(corners[c] - corners[a]) / 2;
  }
  return areas;
}

int bin_of(double value, double width) {
  return std::clamp(static_cast<int>(value / width), 0, MeshQuality::kBins - 1);
}

void add_shape(const std::array<Vec3, 4>& corners, MeshQuality& quality) {
  for (const double radians : dihedral_angles(corners)) {
    const double angle = radians * kDegrees;
    quality.min_dihedral = std::min(quality.min_dihedral, angle);
    quality.max_dihedral = std::max(quality.max_dihedral, angle);
    ++quality.dihedrals[bin_of(angle, kDihedralBin)];
  }
  const double aspect = aspect_ratio(corners);
  quality.worst_aspect_ratio = std::max(quality.worst_aspect_ratio, aspect);
  quality.mean_aspect_ratio += aspect;
  ++quality.aspect_ratios[bin_of(aspect - 1, kAspectBin)];
  quality.volume += signed_volume(corners[0], corners[1], corners[2], corners[3]);
  for (const auto& [a, b] : kEdges) {
    const double length = (corners[a] - corners[b]).norm();
    quality.shortest_edge = std::min(quality.shortest_edge, length);
    quality.longest_edge = std::max(quality.longest_edge, length);
    quality.mean_edge += length / 6;
  }
}

std::string bar(int count, int maximum) {
  constexpr int kWidth = 40;
  return std::string(
      maximum > 0 ? static_cast<std::size_t>((static_cast<double>(count) * kWidth + maximum - 1) / maximum) : 0, '#');
}

/// Returns one line per bin, without empty ones before the first and after the last.
std::string histogram_text(const std::array<int, MeshQuality::kBins>& bins, double start, double width) {
  const auto filled = [](int count) { return count > 0; };
  const auto first = std::find_if(bins.begin(), bins.end(), filled) - bins.begin();
  const auto last = bins.rend() - std::find_if(bins.rbegin(), bins.rend(), filled);
  std::string text;
  for (auto i = first; i < last; ++i) {
    char line[64];
    const double low = start + static_cast<double>(i) * width;
    std::snprintf(line, sizeof line, "  %6.4g ..%6.4g %8d  ", low, low + width, bins[i]);
    text += line + bar(bins[i], *std::max_element(bins.begin(), bins.end())) + "\n";
  }
  return text;
}

}  // namespace

std::array<double, 6> dihedral_angles(const std::array<Vec3, 4>& corners) {
  const std::array<Vec3, 4> areas = face_areas(corners);
  std::array<double, 6> angles;
  for (std::size_t i = 0; i < kEdges.size(); ++i) {
    // The faces at an edge are opposite to the other two corners, which are the ends of the opposite edge.
    const auto& [a, b] = kEdges[kEdges.size() - 1 - i];
    angles[i] = std::atan2(areas[a].cross(areas[b]).norm(), -areas[a].dot(areas[b]));
  }
  return angles;
}

double aspect_ratio(const std::array<Vec3, 4>& corners) {
  double longest = 0, area = 0;
  for (const auto& [a, b] : kEdges) longest = std::max(longest, (corners[a] - corners[b]).norm());
  for (const Vec3& face : face_areas(corners)) area += face.norm();
  const double inradius = 3 * signed_volume(corners[0], corners[1], corners[2], corners[3]) / area;
  return longest / (std::sqrt(24.0) * inradius);
}

MeshQuality mesh_quality(const TetSoup& soup) {
  MeshQuality quality;
  quality.nodes = static_cast<int>(soup.points.size());
  quality.tets = static_cast<int>(soup.tets.size());
  quality.surface_triangles = static_cast<int>(surface_faces(build_mesh(soup)).size());
  quality.min_dihedral = quality.shortest_edge = std::numeric_limits<double>::infinity();
  quality.mean_aspect_ratio = 0;
  for (std::size_t tet = 0; tet < soup.tets.size(); ++tet) add_shape(corners_of(soup, tet), quality);
  quality.mean_aspect_ratio /= quality.tets;
  quality.mean_edge /= quality.tets;
  return quality;
}

std::string quality_text(const MeshQuality& quality) {
  char text[512];
  std::snprintf(text, sizeof text,
                "tetrahedra       %d\nnodes            %d\nsurface          %d triangles\nvolume           %.6g m3\n"
                "edges            %.3g .. %.3g m, %.3g m in the mean\ndihedral angles  %.2f .. %.2f degrees\n",
                quality.tets, quality.nodes, quality.surface_triangles, quality.volume, quality.shortest_edge,
                quality.longest_edge, quality.mean_edge, quality.min_dihedral, quality.max_dihedral);
  std::string result = text + histogram_text(quality.dihedrals, 0, kDihedralBin);
  std::snprintf(text, sizeof text, "aspect ratio     %.3g in the mean, %.3g at worst (1: regular)\n",
                quality.mean_aspect_ratio, quality.worst_aspect_ratio);
  return result + text + histogram_text(quality.aspect_ratios, 1, kAspectBin);
}

}  // namespace griffith
