#include "sim/contact/manifold.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/contact/edge_lanes.h"

namespace griffith::contact {
namespace {

using Feature = Manifold::Feature;

/// Fractions of the smaller radius: motion up to which a pair keeps its points; advantage that an edge needs over a
/// face; largest advantage of another feature that may go unnoticed.
constexpr double kHardlyMoved = 4e-4, kForFaces = 2e-3, kLargestMargin = 1e-1;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct FoundPoints {
  std::array<FoundPoint, kMostFound> points;
  int count = 0;
  bool beside = false;  ///< they do not meet over the face that parts them
  void add(const FoundPoint& point) {
    if (count < kMostFound) points[count++] = point;
  }
  std::span<const FoundPoint> listed() const { return {points.data(), static_cast<std::size_t>(count)}; }
};

int lowest_corner(const Hull& hull, const Vec3& direction) {
  const auto lowest =
      std::ranges::min_element(hull.corners, {}, [&](const Vec3& corner) { return direction.dot(corner); });
  return static_cast<int>(lowest - hull.corners.begin());
}

/// Two hulls, a at `place` in the frame of b, in which all directions are given.
class HullPair {
 public:
  HullPair(const Hull& a, const Hull& b, const Place& place)
      : a_(a), b_(b), place_(place), center_of_a_(place.to_world(a.center)) {}

  struct Axis {
    Feature feature = Feature::none;
    int of_a = 0, of_b = 0;
    double separation = -kInfinity, score = -kInfinity;  // the score favors faces
  };

  double separation_along(Feature feature, int of_a, int of_b) const {
    switch (feature) {
      case Feature::face_of_a:
        return separation_along_face_of_a(of_a);
      case Feature::face_of_b:
        return separation_along_face_of_b(of_b);
      case Feature::edges: {
        const Vec3 outward = edge_axis(of_a, of_b);
        return outward.isZero(0) ? -kInfinity
                                 : a_.lowest(place_.rotation.transpose() * outward) + outward.dot(place_.translation) +
                                       b_.lowest(-outward);
      }
      default:
        return -kInfinity;
    }
  }

  /// Returns the axis of largest separation, and its lead over the second if less than `margin` [m]. Any axis that
  /// separates them by more than `reach` suffices. Axes far behind the best are not computed.
  Axis best_axis(double reach, double for_faces, double& margin) const {
    Axis best;
    double second = -kInfinity;
    const double largest_margin = std::exchange(margin, -1);
    const auto consider = [&](const Axis& axis) {
      if (axis.score > best.score) {
        second = best.score;
        best = axis;
      } else {
        second = std::max(second, axis.score);
      }
      return axis.separation > reach;
    };
    const auto may_matter = [&](double largest_score) { return largest_score > best.score - largest_margin; };
    for (int i = 0; i < static_cast<int>(b_.faces.size()); ++i) {
      const Hull::Face& face = b_.faces[i];
      if (!may_matter(face.normal.dot(center_of_a_) - a_.inner_radius - face.offset)) continue;
      const double separation = separation_along_face_of_b(i);
      if (consider({Feature::face_of_b, 0, i, separation, separation})) return best;
    }
    const Vec3 center_of_b = place_.to_local(b_.center), apart = a_.center - center_of_b;
    for (int i = 0; i < static_cast<int>(a_.faces.size()); ++i) {
      const Hull::Face& face = a_.faces[i];
      if (!may_matter(face.normal.dot(center_of_b) - b_.inner_radius - face.offset)) continue;
      const double separation = separation_along_face_of_a(i);
      if (consider({Feature::face_of_a, i, 0, separation, separation})) return best;
    }
    const double inner = a_.inner_radius + b_.inner_radius + for_faces;
    const auto may_edge_matter = [&](const Hull& hull, int edge, const Vec3& from_other) {
      return may_matter(largest_along_edge(hull, edge, from_other) - inner);
    };
    const int edges_of_b = static_cast<int>(b_.edges.size());
    EdgeLanes chosen(b_);
    for (int j = 0; j < edges_of_b; chosen.clear()) {
      for (; j < edges_of_b && !chosen.is_full(); ++j)
        if (may_edge_matter(b_, j, b_.center - center_of_a_)) chosen.add(j);
      for (int i = 0; i < static_cast<int>(a_.edges.size()); ++i)
        if (may_edge_matter(a_, i, apart) && for_each_facing_edge(i, chosen, [&](int of_b, double separation) {
              return consider({Feature::edges, i, of_b, separation, separation - for_faces});
            }))
          return best;
    }
    margin = std::min(best.score - second, largest_margin);
    return best;
  }

  /// True if two edges may be where the hulls touch first: the arcs between the normals of their faces cross.
  bool face_each_other(int of_a, int of_b) const {
    EdgeLanes edge(b_);
    edge.add(of_b);
    return for_each_facing_edge(of_a, edge, [](int, double) { return true; });
  }

  /// Returns the unit normal of a feature, from b to a; zero for parallel edges.
  Vec3 normal(Feature feature, int of_a, int of_b) const {
    if (feature == Feature::face_of_b) return b_.faces[of_b].normal;
    if (feature == Feature::face_of_a) return -(place_.rotation * a_.faces[of_a].normal);
    return edge_axis(of_a, of_b);
  }

  /// Returns the points where they are closer than `reach`; at least one for overlapping hulls.
  FoundPoints find_points(Feature feature, int of_a, int of_b, double reach) const {
    if (feature == Feature::edges) return find_points_at_edges(of_a, of_b, reach);
    FoundPoints found;
    const bool on_b = feature == Feature::face_of_b;
    const Vec3 outward = (on_b ? 1 : -1) * normal(feature, of_a, of_b);
    const double offset = on_b ? b_.faces[of_b].offset : a_.faces[of_a].offset + outward.dot(place_.translation);
    const Polygon face = on_b ? polygon_of_b(of_b) : polygon_of_a(of_a);
    const Hull& other = on_b ? a_ : b_;
    const Vec3 outward_in_other = on_b ? Vec3(place_.rotation.transpose() * outward) : outward;
    const int lowest = lowest_corner(other, outward_in_other), facing = facing_face(other, lowest, outward_in_other);
    Polygon shared = on_b ? polygon_of_a(facing) : polygon_of_b(facing);
    clip(shared, face, outward);
    const auto add = [&](const Vec3& point) {
      const double distance = outward.dot(point) - offset;
      if (distance >= reach) return;
      const Vec3 beneath = point - distance * outward;
      found.add(on_b ? FoundPoint{point, beneath, distance} : FoundPoint{beneath, point, distance});
    };
    for (int i = 0; i < shared.count; ++i) add(shared.corners[i]);
    const Vec3 deepest = on_b ? corner_of_a(lowest) : b_.corners[lowest];
    const double depth = offset - outward.dot(deepest);
    found.beside = found.count == 0;
    if (found.beside && depth > 0) add(deepest);
    return found;
  }

 private:
  double separation_along_face_of_b(int face) const {
    const Vec3& normal = b_.faces[face].normal;
    return a_.lowest(place_.rotation.transpose() * normal) + normal.dot(place_.translation) - b_.faces[face].offset;
  }

  double separation_along_face_of_a(int face) const {
    const Vec3 normal = place_.rotation * a_.faces[face].normal;
    return b_.lowest(normal) - normal.dot(place_.translation) - a_.faces[face].offset;
  }

  Vec3 corner_of_a(int corner) const { return place_.to_world(a_.corners[corner]); }

  /// Returns an upper bound of the distance from the other's center, in the hull's frame, along any axis of one of its
  /// edges: these are perpendicular to the normals of its faces.
  static double largest_along_edge(const Hull& hull, int index, const Vec3& from_other) {
    const Hull::Edge& edge = hull.edges[index];
    if (hull.faces[edge.left].normal.dot(from_other) >= 0 && hull.faces[edge.right].normal.dot(from_other) >= 0)
      return 0;
    const Vec3 along = hull.corners[edge.to] - hull.corners[edge.from];
    const double shared = along.dot(from_other);
    return std::sqrt(std::max(0.0, from_other.squaredNorm() - shared * shared / along.squaredNorm()));
  }

  /// Returns the common normal of two edges, from b to a.
  Vec3 edge_axis(int of_a, int of_b) const {
    constexpr double kParallel = 5e-3;  // the sine
    const Hull::Edge &edge_a = a_.edges[of_a], &edge_b = b_.edges[of_b];
    const Vec3 along_a = place_.rotation * (a_.corners[edge_a.to] - a_.corners[edge_a.from]);
    const Vec3 along_b = b_.corners[edge_b.to] - b_.corners[edge_b.from];
    const Vec3 across = along_a.cross(along_b);
    const double square = across.squaredNorm();
    if (square < kParallel * kParallel * along_a.squaredNorm() * along_b.squaredNorm()) return Vec3::Zero();
    const Vec3 axis = across / std::sqrt(square);
    return axis.dot(b_.corners[edge_b.from] - b_.center) >= 0 ? axis : Vec3(-axis);
  }

  /// Calls use(edge of b, separation) for those edges of b that may be closest to an edge of a: their faces' normals
  /// cross on the sphere. Stops when it returns true, and returns that.
  template <class Use>
  bool for_each_facing_edge(int of_a, const EdgeLanes& edges_of_b, Use use) const {
    constexpr double kCrossing = 1e-12;  // arcs of one great circle would cross by rounding errors
    const Hull::Edge& edge = a_.edges[of_a];
    const Triple left(place_.rotation * a_.faces[edge.left].normal),
        right(place_.rotation * a_.faces[edge.right].normal);
    const Triple along((place_.rotation * (a_.corners[edge.to] - a_.corners[edge.from])).normalized());
    int first_lane = 0;
    for (const EdgeLanes::Four& four : edges_of_b.fours()) {
      const simd::DoubleLanes first = -dot(along, four.left), second = -dot(along, four.right);
      const simd::DoubleLanes third = dot(left, four.along), fourth = dot(right, four.along);
      const simd::DoubleMask facing =
          (first * second < -kCrossing) & (third * fourth < -kCrossing) & (first * fourth > 0.0);
      const int lanes = std::min(simd::kDoubleLanes, edges_of_b.count() - first_lane);
      first_lane += simd::kDoubleLanes;
      if (!simd::any_of(facing)) continue;
      for (int lane = 0; lane < lanes; ++lane) {
        if (!facing[lane]) continue;
        const Vec3 axis = edge_axis(of_a, four.edges[lane]);
        const Vec3& from_b = b_.corners[b_.edges[four.edges[lane]].from];
        if (!axis.isZero(0) && use(four.edges[lane], axis.dot(corner_of_a(edge.from) - from_b))) return true;
      }
    }
    return false;
  }

  /// Returns the face at a corner that is most opposed to a direction; searches all faces if the corner lies within a
  /// flat side.
  static int facing_face(const Hull& hull, int corner, const Vec3& direction) {
    const auto is_at_corner = [&](const Hull::Face& face) {
      return std::ranges::count(std::span(hull.loops).subspan(face.first, face.count), corner) > 0;
    };
    int best = -1, of_all = 0;
    for (int i = 0; i < static_cast<int>(hull.faces.size()); ++i) {
      const double along = direction.dot(hull.faces[i].normal);
      if (along < direction.dot(hull.faces[of_all].normal)) of_all = i;
      if ((best < 0 || along < direction.dot(hull.faces[best].normal)) && is_at_corner(hull.faces[i])) best = i;
    }
    return best < 0 ? of_all : best;
  }

  /// Returns the polygon of a face, without some of its corners if these are very many.
  template <class Corner>
  static Polygon polygon(const Hull& hull, int face, Corner corner) {
    Polygon made;
    const int stride = 1 + hull.faces[face].count / (Polygon::kMaxCorners / 2);
    for (int i = 0; i < hull.faces[face].count; i += stride) made.add(corner(hull.loops[hull.faces[face].first + i]));
    return made;
  }
  Polygon polygon_of_a(int face) const {
    return polygon(a_, face, [&](int corner) { return corner_of_a(corner); });
  }
  Polygon polygon_of_b(int face) const {
    return polygon(b_, face, [&](int corner) { return b_.corners[corner]; });
  }

  /// Returns the point where two edges meet and the other corners of the area that their faces share, seen along the
  /// edges' normal, if both lie across it: long bodies that cross would rock through one another on a single point.
  FoundPoints find_points_at_edges(int of_a, int of_b, double reach) const {
    constexpr double kAcross = 0.9;  // cosine
    FoundPoints found;
    found.add(edge_point(of_a, of_b));
    const Vec3 axis = edge_axis(of_a, of_b);
    const int face_a = face_at_edge(a_, of_a, -(place_.rotation.transpose() * axis)),
              face_b = face_at_edge(b_, of_b, axis);
    const Vec3& normal_b = b_.faces[face_b].normal;
    const double along = normal_b.dot(axis);
    if (along < kAcross || -(place_.rotation * a_.faces[face_a].normal).dot(axis) < kAcross) return found;
    Polygon shared = polygon_of_a(face_a);
    clip(shared, polygon_of_b(face_b), axis);
    const std::span<const Vec3> corners(shared.corners.data(), static_cast<std::size_t>(shared.count));
    const auto same = std::ranges::min_element(
        corners, {}, [&](const Vec3& corner) { return (corner - found.points[0].on_a).squaredNorm(); });
    for (auto corner = corners.begin(); corner != corners.end(); ++corner) {
      const double distance = (normal_b.dot(*corner) - b_.faces[face_b].offset) / along;
      if (corner != same && distance < reach) found.add({*corner, *corner - distance * axis, distance});
    }
    return found;
  }

  /// Returns that face beside an edge which faces more in a direction.
  static int face_at_edge(const Hull& hull, int edge, const Vec3& direction) {
    const int left = hull.edges[edge].left, right = hull.edges[edge].right;
    return hull.faces[left].normal.dot(direction) > hull.faces[right].normal.dot(direction) ? left : right;
  }

  /// Returns the closest point of two edges.
  FoundPoint edge_point(int of_a, int of_b) const {
    const Hull::Edge &edge_a = a_.edges[of_a], &edge_b = b_.edges[of_b];
    const Vec3 start_a = corner_of_a(edge_a.from), along_a = corner_of_a(edge_a.to) - start_a;
    const Vec3 start_b = b_.corners[edge_b.from], along_b = b_.corners[edge_b.to] - start_b;
    const Vec3 apart = start_a - start_b;
    const double aa = along_a.squaredNorm(), bb = along_b.squaredNorm(), ab = along_a.dot(along_b);
    const double on_a = along_a.dot(apart), on_b = along_b.dot(apart), determinant = aa * bb - ab * ab;
    const double share_a = std::clamp((ab * on_b - bb * on_a) / determinant, 0.0, 1.0);
    const double share_b = std::clamp((ab * share_a + on_b) / bb, 0.0, 1.0);
    const Vec3 point_a = start_a + share_a * along_a, point_b = start_b + share_b * along_b;
    return {point_a, point_b, edge_axis(of_a, of_b).dot(point_a - point_b)};
  }

  const Hull &a_, &b_;
  const Place& place_;
  Vec3 center_of_a_;
};

/// Returns the largest displacement of a point of the smaller of two objects in the frame of the other [m].
double moved(const Place& then, const Place& now, double radius_a, double radius_b) {
  const double turned = (now.rotation - then.rotation).norm();
  if (radius_a <= radius_b) return (now.translation - then.translation).norm() + radius_a * turned;
  const Vec3 b_then = then.rotation.transpose() * then.translation, b_now = now.rotation.transpose() * now.translation;
  return (b_now - b_then).norm() + radius_b * turned;
}

/// Selects the four that span the area: a deep one, the one farthest from it, and the farthest on both sides of these.
int spanning_four(std::span<const FoundPoint> found, const Vec3& normal, std::array<int, 4>& kept) {
  constexpr double kSlope = 0.01;  // how much outer ones may be less deep
  const Vec3 outward = normal.unitOrthogonal();
  const auto best = [&](auto score) {
    int index = 0;
    double most = -kInfinity;
    for (int i = 0; i < static_cast<int>(found.size()); ++i)
      if (const double value = score(found[i]); value > most) {
        most = value;
        index = i;
      }
    return index;
  };
  kept[0] = best([&](const FoundPoint& point) { return kSlope * outward.dot(point.on_b) - point.distance; });
  const Vec3& first = found[kept[0]].on_b;
  kept[1] = best([&](const FoundPoint& point) { return (point.on_b - first).squaredNorm(); });
  const Vec3 across = (found[kept[1]].on_b - first).cross(normal);
  kept[2] = best([&](const FoundPoint& point) { return across.dot(point.on_b - first); });
  kept[3] = best([&](const FoundPoint& point) { return -across.dot(point.on_b - first); });
  std::ranges::sort(kept);
  return static_cast<int>(std::unique(kept.begin(), kept.end()) - kept.begin());
}

}  // namespace

void set_points(Manifold& manifold, std::span<const FoundPoint> found, const Vec3& normal_in_b, const Place& a_in_b,
                double tolerance) {
  std::array<int, 4> kept = {0, 1, 2, 3};
  const int count = found.size() <= 4 ? static_cast<int>(found.size()) : spanning_four(found, normal_in_b, kept);
  const std::array<Manifold::Point, 4> before = manifold.points;
  std::array<bool, 4> handed_on = {};
  for (int i = 0; i < count; ++i) {
    Manifold::Point& point = manifold.points[i];
    point = {a_in_b.to_local(found[kept[i]].on_a), found[kept[i]].on_b};
    int nearest = -1;
    double least = tolerance * tolerance;
    for (int k = 0; k < manifold.count; ++k) {
      const double distance =
          std::min((before[k].on_a - point.on_a).squaredNorm(), (before[k].on_b - point.on_b).squaredNorm());
      if (handed_on[k] || distance >= least) continue;
      least = distance;
      nearest = k;
    }
    if (nearest < 0) continue;
    handed_on[nearest] = true;
    point.force = before[nearest].force;
  }
  manifold.count = count;
  manifold.normal_in_b = normal_in_b;
}

namespace {

/// Examines all features of a pair; an edge must separate it better than a face by `for_faces` [m].
void take_best_axis(Manifold& manifold, const HullPair& pair, double reach, double for_faces, double largest_margin) {
  double margin = 2 * largest_margin;
  const HullPair::Axis axis = pair.best_axis(reach, for_faces, margin);
  manifold.feature = axis.feature;
  manifold.of_a = axis.of_a;
  manifold.of_b = axis.of_b;
  manifold.separation = axis.separation;
  manifold.margin = 0.5 * margin;
  manifold.drift = 0;
}

}  // namespace

void find_contacts(Manifold& manifold, const SizedHull& a, const SizedHull& b, const Place& a_in_b, double reach) {
  const double since = moved(manifold.seen, a_in_b, a.radius, b.radius), radius = std::min(a.radius, b.radius);
  if (manifold.feature != Feature::none) {
    if (manifold.count > 0 && since < kHardlyMoved * radius && reach <= manifold.seen_reach) return;
    if (manifold.count == 0 && manifold.separation - since > reach) return;
  }
  const HullPair pair(a.hull, b.hull, a_in_b);
  manifold.drift += since;
  manifold.seen = a_in_b;
  manifold.seen_reach = reach;
  manifold.separation = pair.separation_along(manifold.feature, manifold.of_a, manifold.of_b);
  const bool lost = manifold.separation == -kInfinity ||
                    (manifold.feature == Feature::edges && !pair.face_each_other(manifold.of_a, manifold.of_b));
  if (!(manifold.separation > reach) && (lost || !(manifold.drift < manifold.margin)))
    take_best_axis(manifold, pair, reach, kForFaces * radius, kLargestMargin * radius);
  if (manifold.separation > reach) return void(manifold.count = 0);
  FoundPoints found = pair.find_points(manifold.feature, manifold.of_a, manifold.of_b, reach);
  if (found.beside && manifold.feature != Feature::edges) {  // edges may cross beside the face that was preferred
    take_best_axis(manifold, pair, reach, 0, kLargestMargin * radius);
    found = pair.find_points(manifold.feature, manifold.of_a, manifold.of_b, reach);
  }
  set_points(manifold, found.listed(), pair.normal(manifold.feature, manifold.of_a, manifold.of_b), a_in_b,
             0.1 * radius);
}

}  // namespace griffith::contact
