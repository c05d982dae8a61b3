#include <array>
#include <cmath>

#include "sim/splinters/convex_cells.h"

namespace griffith {
namespace {

/// Cuts across an axis, the same in every period of brick and joint.
struct Cuts {
  double origin = 0, period = 1;
  std::vector<double> offsets;  ///< positions within a period, ascending, the first 0
  std::int64_t first_period = 0, periods = 0;

  std::int64_t parts() const { return std::ssize(offsets); }
  std::int64_t slabs() const { return periods * parts(); }
  std::int64_t period_of(std::int64_t slab) const { return first_period + slab / parts(); }
  std::int64_t part_of(std::int64_t slab) const { return slab % parts(); }
  /// Returns the start of a slab.
  double begin(std::int64_t slab) const {
    return origin + static_cast<double>(period_of(slab)) * period + offsets[part_of(slab)];
  }
};

/// `halved`: adds cuts for courses that are shifted by half a period, so that cells of both meet face to face.
Cuts make_cuts(const BrickSplinters& pattern, int axis, bool halved, const Eigen::AlignedBox3d& bounds) {
  const double length = pattern.size[axis], joint = pattern.mortar;
  Cuts cuts{pattern.origin[axis], length + joint, {0}};
  if (halved && joint > 0) cuts.offsets.push_back((length - joint) / 2);
  if (halved) cuts.offsets.push_back((length + joint) / 2);
  if (joint > 0) cuts.offsets.push_back(length);
  const double low = std::floor((bounds.min()[axis] - cuts.origin) / cuts.period) - 1;
  const double high = std::floor((bounds.max()[axis] - cuts.origin) / cuts.period) + 2;
  check_cell_count(high - low);
  cuts.first_period = static_cast<std::int64_t>(low);
  cuts.periods = static_cast<std::int64_t>(high - low);
  return cuts;
}

/// Lattice of boxes. In odd courses the second half of a period begins a brick.
class BrickLattice {
 public:
  BrickLattice(const BrickSplinters& pattern, const Eigen::AlignedBox3d& bounds)
      : mortar_(pattern.mortar > 0),
        cuts_{make_cuts(pattern, 0, true, bounds), make_cuts(pattern, 1, false, bounds),
              make_cuts(pattern, 2, false, bounds)} {
    check_cell_count(double(cuts_[0].slabs()) * double(cuts_[1].slabs()) * double(cuts_[2].slabs()));
  }

  CellPartition cells() const {
    CellPartition cells;
    for (std::int64_t z = 0; z < cuts_[2].slabs(); ++z)
      for (std::int64_t y = 0; y < cuts_[1].slabs(); ++y)
        for (std::int64_t x = 0; x < cuts_[0].slabs(); ++x) cells.push_back(cell({x, y, z}));
    return cells;
  }

 private:
  using Place = std::array<std::int64_t, 3>;

  std::int64_t index(const Place& place) const {
    return (place[2] * cuts_[1].slabs() + place[1]) * cuts_[0].slabs() + place[0];
  }

  bool shifted(const Place& place) const { return cuts_[1].period_of(place[1]) % 2 != 0; }

  /// True for the joint at the end of a course, a wythe or a brick.
  bool in_mortar(const Place& place) const {
    if (!mortar_) return false;
    if (cuts_[1].part_of(place[1]) == 1 || cuts_[2].part_of(place[2]) == 1) return true;
    return cuts_[0].part_of(place[0]) == (shifted(place) ? 1 : 3);
  }

  int brick(const Place& place) const {
    const std::int64_t half = mortar_ ? 2 : 1;  // part at which the second half of a period begins
    std::int64_t column = place[0] / cuts_[0].parts() + 1;
    if (shifted(place) && cuts_[0].part_of(place[0]) < half) --column;
    const std::int64_t course = place[1] / cuts_[1].parts(), wythe = place[2] / cuts_[2].parts();
    return static_cast<int>((wythe * cuts_[1].periods + course) * (cuts_[0].periods + 1) + column);
  }

  ConvexCell cell(const Place& place) const {
    ConvexCell cell;
    cell.splinter = brick(place);
    cell.matter = in_mortar(place) ? SplinterMatter::mortar : SplinterMatter::body;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Place beyond = place;
        beyond[axis] += side;
        if (beyond[axis] < 0 || beyond[axis] >= cuts_[axis].slabs()) continue;
        HalfSpace inside{Vec3::Unit(axis), cuts_[axis].begin(std::max(place[axis], beyond[axis]))};
        cell.walls.push_back({side > 0 ? inside : inside.opposite(), static_cast<int>(index(beyond))});
      }
    }
    return cell;
  }

  bool mortar_;
  std::array<Cuts, 3> cuts_;
};

}  // namespace

CellPartition make_brick_cells(const BrickSplinters& pattern, const Eigen::AlignedBox3d& bounds) {
  return BrickLattice(pattern, bounds).cells();
}

}  // namespace griffith
