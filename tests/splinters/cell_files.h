#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/core/replace_file.h"

namespace griffith::testing {

/// Convex cell with the corners and sides of a box, which may be moved.
struct BoxCell {
  std::string name;
  std::array<Vec3, 8> corners;
};

inline BoxCell box_cell(const std::string& name, const Vec3& low, const Vec3& high) {
  BoxCell cell{name, {}};
  for (int i = 0; i < 8; ++i)
    cell.corners[i] = Vec3(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  return cell;
}

/// Writes one object per cell. `faces`: number of the six faces that are written.
inline std::filesystem::path write_cells(const std::filesystem::path& path, const std::vector<BoxCell>& cells,
                                         int faces = 6) {
  constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::ostringstream file;
  file.precision(9);
  int first = 1;
  for (const BoxCell& cell : cells) {
    file << "o " << cell.name << '\n';
    for (const Vec3& p : cell.corners) file << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (int face = 0; face < faces; ++face) {
      file << 'f';
      for (const int corner : kFaces[face]) file << ' ' << first + corner;
      file << '\n';
    }
    first += 8;
  }
  replace_file(path, file.str());
  return path;
}

/// Returns rotated bricks in running bond around the origin, 1.6 m wide each way. Their sides have several neighbors
/// and no coordinate is exact.
inline std::vector<BoxCell> turned_bond() {
  const Vec3 size(0.23, 0.17, 0.29);
  const Mat3 turn = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<BoxCell> cells;
  for (int z = -4; z < 4; ++z)
    for (int y = -6; y < 6; ++y)
      for (int x = -5; x < 5; ++x) {
        const Vec3 low = Vec3(x + 0.5 * (y & 1), y, z).cwiseProduct(size);
        BoxCell cell = box_cell("brick_" + std::to_string(cells.size()), low, low + size);
        for (Vec3& corner : cell.corners) corner = turn * corner;
        cells.push_back(cell);
      }
  return cells;
}

}  // namespace griffith::testing
