#include "app/picture/element_picture.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sim/core/tet_edge_corners.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith::app {
namespace {

constexpr render::Rgb kWireColor = {0.30f, 0.34f, 0.40f};

PictureTriangle face_triangle(TetId tet, std::size_t face) {
  PictureTriangle triangle{tet, static_cast<std::int8_t>(face), render::kAllEdges, {}};
  for (std::size_t i = 0; i < 3; ++i)
    triangle.corners[i].a = triangle.corners[i].b = static_cast<std::int8_t>(kTetFaces[face][i]);
  return triangle;
}

Vec3 place_of(const EdgePlace& place, const std::array<Vec3, 4>& corners) {
  return (1 - place.t) * corners[place.a] + double(place.t) * corners[place.b];
}

std::array<Vec3, 4> shown_corners(const ShownMesh& shown, TetId tet, double shrink) {
  std::array<Vec3, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = shown.positions[shown.frame.elements.tets[tet][i]];
  if (shrink == 1) return corners;
  const Vec3 middle = shown.centroid(tet);
  for (Vec3& corner : corners) corner = middle + shrink * (corner - middle);
  return corners;
}

/// Returns the intersection of a plane with a tet whose corners have these heights above it: 3 or 4 points in order
/// around the section.
std::vector<EdgePlace> section(const std::array<double, 4>& heights) {
  std::vector<int> above, below;
  for (int i = 0; i < 4; ++i) (heights[i] > 0 ? above : below).push_back(i);
  std::vector<EdgePlace> places;
  const auto add = [&](int a, int b) {
    const double t = heights[a] / (heights[a] - heights[b]);
    places.push_back({static_cast<std::int8_t>(a), static_cast<std::int8_t>(b), static_cast<float>(t)});
  };
  if (above.size() == 2) {
    add(above[0], below[0]);
    add(above[0], below[1]);
    add(above[1], below[1]);
    add(above[1], below[0]);
  } else if (above.size() % 2 == 1) {
    const bool one_above = above.size() == 1;
    const int tip = one_above ? above[0] : below[0];
    for (const int base : one_above ? below : above) one_above ? add(tip, base) : add(base, tip);
  }
  return places;
}

/// Adds a polygon as a fan with marked outer edges, facing along `normal`.
void add_section(std::vector<EdgePlace> places, TetId tet, const std::array<Vec3, 4>& corners, const Vec3& normal,
                 std::vector<PictureTriangle>& triangles) {
  const Vec3 a = place_of(places[0], corners), b = place_of(places[1], corners), c = place_of(places[2], corners);
  if ((b - a).cross(c - a).dot(normal) < 0) std::reverse(places.begin(), places.end());
  const std::size_t last = places.size() - 1;
  for (std::size_t i = 1; i < last; ++i) {
    std::uint8_t edges = render::kEdge0;
    if (i == 1) edges |= render::kEdge2;
    if (i + 1 == last) edges |= render::kEdge1;
    triangles.push_back({tet, -1, edges, {places[0], places[i], places[i + 1]}});
  }
}

std::uint8_t flags_of(const PictureTriangle& triangle, const Frame& frame, TetId selected) {
  std::uint8_t flags = triangle.edges;
  const bool outer = triangle.face < 0 || frame.elements.neighbors[triangle.tet][triangle.face].valid() ||
                     (frame.elements.first_surface[triangle.tet] >> triangle.face & 1);
  if (!outer) flags |= render::kCrackFace;
  if (triangle.tet == selected) flags |= render::kSelected;
  return flags;
}

/// Returns the value of a linear field. `at`: its value at a corner.
template <class At>
float linear_scalar(const EdgePlace& place, const At& at) {
  return place.a == place.b ? at(place.a) : (1 - place.t) * at(place.a) + place.t * at(place.b);
}

/// Returns the mean value in a tet.
float mean_scalar(const QuantityValues& values, TetId tet) {
  if (values.place == ValuePlace::tet) return values.values[tet];
  const auto first = values.values.begin() + 4 * tet.index();
  return (first[0] + first[1] + first[2] + first[3]) / 4;
}

/// An edge of a tet with its nodes ascending.
struct TetEdge {
  NodeId a, b;
  TetId tet;
  bool operator<(const TetEdge& other) const { return std::tie(a, b, tet) < std::tie(other.a, other.b, other.tet); }
};

std::vector<TetEdge> sorted_edges(const ShownMesh& shown) {
  std::vector<TetEdge> edges;
  edges.reserve(6 * shown.frame.elements.tets.size());
  for (std::size_t i = 0; i < shown.frame.elements.tets.size(); ++i) {
    const TetId tet(static_cast<std::int64_t>(i));
    if (!shown.visible(shown.centroid(tet))) continue;
    for (const auto& [p, q] : kTetEdges) {
      const NodeId a = shown.frame.elements.tets[tet][p], b = shown.frame.elements.tets[tet][q];
      edges.push_back({std::min(a, b), std::max(a, b), tet});
    }
  }
  std::ranges::sort(edges, std::less());
  return edges;
}

}  // namespace

std::vector<PictureTriangle> surface_triangles(const Frame& frame, const FaceFilter& shows) {
  std::vector<PictureTriangle> triangles;
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet)
    for (std::size_t face = 0; face < 4; ++face)
      if (!frame.elements.neighbors[tet][face].valid() && shows(tet, face))
        triangles.push_back(face_triangle(TetId(static_cast<std::int64_t>(tet)), face));
  return triangles;
}

std::vector<PictureTriangle> element_triangles(const ShownMesh& shown) {
  std::vector<PictureTriangle> triangles;
  triangles.reserve(4 * shown.frame.elements.tets.size());
  for (std::size_t i = 0; i < shown.frame.elements.tets.size(); ++i) {
    const TetId tet(static_cast<std::int64_t>(i));
    if (!shown.visible(shown.centroid(tet))) continue;
    for (std::size_t face = 0; face < 4; ++face) triangles.push_back(face_triangle(tet, face));
  }
  return triangles;
}

std::vector<PictureTriangle> cap_triangles(const ShownMesh& shown) {
  std::vector<PictureTriangle> triangles;
  if (!shown.view.slice) return triangles;
  const Vec3 normal = shown.view.slice->normal.normalized();
  for (std::size_t i = 0; i < shown.frame.elements.tets.size(); ++i) {
    const TetId tet(static_cast<std::int64_t>(i));
    const std::array<Vec3, 4> corners = shown_corners(shown, tet, 1);
    std::array<double, 4> heights;
    for (std::size_t k = 0; k < 4; ++k) heights[k] = normal.dot(corners[k]) - shown.view.slice->offset;
    std::vector<EdgePlace> places = section(heights);
    if (!places.empty()) add_section(std::move(places), tet, corners, normal, triangles);
  }
  return triangles;
}

render::Surface surface_of(const std::vector<PictureTriangle>& triangles, const ShownMesh& shown, double shrink,
                           TetId selected) {
  render::Surface surface;
  surface.positions.reserve(3 * triangles.size());
  surface.ids.reserve(triangles.size());
  surface.flags.reserve(triangles.size());
  for (const PictureTriangle& triangle : triangles) {
    const std::array<Vec3, 4> corners = shown_corners(shown, triangle.tet, shrink);
    for (const EdgePlace& place : triangle.corners)
      surface.positions.push_back((place.a == place.b ? corners[place.a] : place_of(place, corners)).cast<float>());
    surface.ids.push_back(triangle.tet.index());
    surface.flags.push_back(flags_of(triangle, shown.frame, selected));
  }
  return surface;
}

std::vector<Eigen::Vector3f> rest_corners(const std::vector<PictureTriangle>& triangles, const Frame& frame) {
  std::vector<Eigen::Vector3f> places;
  places.reserve(3 * triangles.size());
  for (const PictureTriangle& triangle : triangles) {
    std::array<Vec3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = frame.nodes.rest_positions[frame.elements.tets[triangle.tet][i]];
    for (const EdgePlace& place : triangle.corners)
      places.push_back((place.a == place.b ? corners[place.a] : place_of(place, corners)).cast<float>());
  }
  return places;
}

void add_scalars(const std::vector<PictureTriangle>& triangles, const Frame& frame, const QuantityValues& values,
                 render::Surface& surface) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const PictureTriangle& triangle = triangles[i];
    const std::array<NodeId, 4>& nodes = frame.elements.tets[triangle.tet];
    const auto at_corner = [&](std::size_t corner) {
      return values.place == ValuePlace::node ? values.values[nodes[corner]]
                                              : values.values[4 * triangle.tet.index() + corner];
    };
    if (values.place == ValuePlace::node || values.place == ValuePlace::corner) {
      for (const EdgePlace& place : triangle.corners) surface.scalars.push_back(linear_scalar(place, at_corner));
    } else if (values.place == ValuePlace::tet) {
      surface.scalars.push_back(values.values[triangle.tet]);
    } else {
      const float value = triangle.face < 0 ? NAN : values.values[4 * triangle.tet.index() + triangle.face];
      surface.scalars.push_back(value);
      if (std::isnan(value)) surface.flags[i] |= render::kPlain;
    }
  }
}

bool show_rigid(const std::vector<PictureTriangle>& triangles, const Frame& frame, render::Surface& surface) {
  bool any = false;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!frame.bodies[frame.elements.bodies[triangles[i].tet]].rigid) continue;
    surface.flags[i] = static_cast<std::uint8_t>((surface.flags[i] & ~render::kCrackFace) | render::kPlain);
    any = true;
  }
  return any;
}

std::vector<render::Line> wireframe(const ShownMesh& shown, const QuantityValues* values,
                                    const render::ScalarStyle& style) {
  std::vector<render::Line> lines;
  const std::vector<TetEdge> edges = sorted_edges(shown);
  for (std::size_t i = 0; i < edges.size();) {
    const TetEdge& edge = edges[i];
    float sum = 0;
    std::size_t end = i;
    for (; end < edges.size() && edges[end].a == edge.a && edges[end].b == edge.b; ++end)
      if (values && (values->place == ValuePlace::tet || values->place == ValuePlace::corner))
        sum += mean_scalar(*values, edges[end].tet);
    float value = sum / static_cast<float>(end - i);
    if (values && values->place == ValuePlace::node) value = 0.5f * (values->values[edge.a] + values->values[edge.b]);
    const float t = (value - style.minimum) / (style.maximum - style.minimum);
    lines.push_back({shown.positions[edge.a].cast<float>(), shown.positions[edge.b].cast<float>(),
                     values ? render::color_map_color(style.color_map, t) : kWireColor, edge.tet.index()});
    i = end;
  }
  return lines;
}

}  // namespace griffith::app
