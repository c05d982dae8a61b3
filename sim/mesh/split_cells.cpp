#include <algorithm>

#include "sim/core/error.h"
#include "sim/core/sort_unique.h"
#include "sim/mesh/mesh_cells.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"

namespace griffith {
namespace {

using Triangle = std::array<int, 3>;
using Tet = std::array<int, 4>;
using FaceLoop = std::vector<int>;

/// Faces by their corners, counterclockwise seen from outside.
std::span<const std::vector<int>> face_table(CellShape shape) {
  static const std::vector<std::vector<int>> kPyramid = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  static const std::vector<std::vector<int>> kPrism = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  static const std::vector<std::vector<int>> kHexahedron = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                            {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return shape == CellShape::pyramid ? kPyramid : shape == CellShape::prism ? kPrism : kHexahedron;
}

/// Returns the faces of a cell by its points, without collapsed edges and faces.
std::vector<FaceLoop> faces_of(const VolumeCell& cell) {
  std::vector<FaceLoop> faces;
  for (const std::vector<int>& corners : face_table(cell.shape)) {
    FaceLoop face;
    for (const int corner : corners)
      if (face.empty() || face.back() != cell.corners[corner]) face.push_back(cell.corners[corner]);
    if (face.front() == face.back()) face.pop_back();
    if (face.size() > 2) faces.push_back(std::move(face));
  }
  return faces;
}

Triangle sorted_corners(Triangle triangle) {
  std::ranges::sort(triangle);
  return triangle;
}

/// Triangles on faces of cells that other items of the file have as faces: tets, or triangular faces of cells. They
/// determine the diagonal of a quadrilateral.
class GivenTriangles {
 public:
  explicit GivenTriangles(const MeshFile& file) {
    for (const VolumeCell& cell : file.cells)
      for (const FaceLoop& face : faces_of(cell))
        if (face.size() == 4)
          for (std::size_t left_out = 0; left_out < 4; ++left_out) wanted_.push_back(without(face, left_out));
    sort_unique(wanted_);
    given_.resize(wanted_.size(), 0);
    for (const Tet& tet : file.soup.tets)
      for (const auto& face : kTetFaces) mark({tet[face[0]], tet[face[1]], tet[face[2]]});
    for (const VolumeCell& cell : file.cells)
      for (const FaceLoop& face : faces_of(cell))
        if (face.size() == 3) mark({face[0], face[1], face[2]});
  }

  bool contain(const Triangle& triangle) const {
    const auto found = std::ranges::lower_bound(wanted_, sorted_corners(triangle));
    return found != wanted_.end() && *found == sorted_corners(triangle) && given_[found - wanted_.begin()] != 0;
  }

 private:
  static Triangle without(const FaceLoop& quad, std::size_t left_out) {
    return sorted_corners({quad[(left_out + 1) % 4], quad[(left_out + 2) % 4], quad[(left_out + 3) % 4]});
  }
  void mark(const Triangle& triangle) {
    const auto found = std::ranges::lower_bound(wanted_, sorted_corners(triangle));
    if (found != wanted_.end() && *found == sorted_corners(triangle)) given_[found - wanted_.begin()] = 1;
  }

  std::vector<Triangle> wanted_;  ///< halves of all quadrilaterals, ascending
  std::vector<char> given_;
};

/// Cuts a face the same way in both cells: only its points and the file's triangles matter.
void cut_face(FaceLoop face, const GivenTriangles& given, std::vector<Triangle>& triangles) {
  if (face.size() == 3) return triangles.push_back({face[0], face[1], face[2]});
  std::ranges::rotate(face, std::ranges::min_element(face));
  const auto [a, b, c, d] = std::array{face[0], face[1], face[2], face[3]};
  const bool by_smallest = given.contain({a, b, c}) || given.contain({a, c, d});
  const bool by_other = given.contain({a, b, d}) || given.contain({b, c, d});
  if (by_other && !by_smallest) {
    triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
  } else {
    triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
  }
}

std::vector<Tet> fan(const std::vector<Triangle>& surface, int apex) {
  std::vector<Tet> tets;
  for (const auto& [a, b, c] : surface)
    if (a != apex && b != apex && c != apex) tets.push_back({apex, a, b, c});
  return tets;
}

double quality_of(const std::vector<Vec3>& points, const Tet& tet) {
  return tet_quality(points[tet[0]], points[tet[1]], points[tet[2]], points[tet[3]]);
}

/// Returns the least quality of the tets of a fan for either numbering of the cell: not above 0 if tets overlap.
double worst_quality(const std::vector<Vec3>& points, const std::vector<Tet>& tets) {
  double least = 1, most = -1;
  for (const Tet& tet : tets) {
    least = std::min(least, quality_of(points, tet));
    most = std::max(most, quality_of(points, tet));
  }
  return tets.empty() ? 0 : std::max(least, -most);
}

/// Splits one cell after another.
class CellSplitter {
 public:
  explicit CellSplitter(TetSoup& soup) : soup_(soup) {}

  /// Returns false if the cell overlaps itself.
  bool split(const std::vector<Triangle>& surface) {
    std::vector<int> corners;
    for (const Triangle& triangle : surface) corners.insert(corners.end(), triangle.begin(), triangle.end());
    sort_unique(corners);
    best_.clear();
    best_quality_ = 0;
    for (std::size_t i = 0; i < corners.size() && best_quality_ < kSliverQuality; ++i)
      try_apex(surface, corners[i], best_quality_);
    if (best_quality_ < kSliverQuality) try_middle(surface, corners);
    for (Tet tet : best_) {
      if (quality_of(soup_.points, tet) < 0) std::swap(tet[1], tet[2]);
      soup_.tets.push_back(tet);
    }
    return !best_.empty();
  }

 private:
  /// Takes the fan around `apex` if its quality is above `least`. Returns false if not.
  bool try_apex(const std::vector<Triangle>& surface, int apex, double least) {
    std::vector<Tet> tets = fan(surface, apex);
    const double quality = worst_quality(soup_.points, tets);
    if (!(quality > least)) return false;
    best_quality_ = quality;
    best_ = std::move(tets);
    return true;
  }

  /// An added node must improve the quality, so thin cells stay without.
  void try_middle(const std::vector<Triangle>& surface, const std::vector<int>& corners) {
    constexpr double kGain = 2;
    Vec3 sum = Vec3::Zero();
    for (const int corner : corners) sum += soup_.points[corner];
    const int middle = static_cast<int>(soup_.points.size());
    soup_.points.push_back(sum / std::max<double>(1, static_cast<double>(corners.size())));
    if (!try_apex(surface, middle, kGain * best_quality_)) soup_.points.pop_back();
  }

  TetSoup& soup_;
  std::vector<Tet> best_;
  double best_quality_ = 0;
};

std::string node_list(const VolumeCell& cell) {
  std::string list;
  for (int i = 0; i < corner_count(cell.shape); ++i) list += (i == 0 ? "" : ", ") + std::to_string(cell.corners[i]);
  return list;
}

}  // namespace

void split_cells(MeshFile& file, const std::string& name) {
  if (file.cells.empty()) return;
  const GivenTriangles given(file);
  const std::size_t before = file.soup.tets.size();
  CellSplitter splitter(file.soup);
  const VolumeCell* first_folded = nullptr;
  int folded = 0;
  for (const VolumeCell& cell : file.cells) {
    std::vector<Triangle> surface;
    for (const FaceLoop& face : faces_of(cell)) cut_face(face, given, surface);
    if (splitter.split(surface)) continue;
    ++folded;
    if (first_folded == nullptr) first_folded = &cell;
  }
  if (folded > 0)
    throw InputError(name,
                     "the cell of nodes " + node_list(*first_folded) + " overlaps itself or has no volume; " +
                         std::to_string(folded) + " such in total",
                     "generate the mesh again, or as tetrahedra");
  file.report.tets_of_split = static_cast<std::int64_t>(file.soup.tets.size() - before);
  file.cells.clear();
}

}  // namespace griffith
