#include <algorithm>
#include <cmath>
#include <numeric>
#include <ranges>
#include <span>
#include <utility>

#include "sim/contact/bullet/contact_world.h"
#include "sim/contact/bullet/sweep.h"
#include "sim/core/parallel.h"

namespace griffith {

using namespace contact;

namespace {

/// Distance that a box may move before it enters the tree again, as a fraction of the object's radius.
constexpr double kSlack = 0.1;

double contact_reach(const Object& object) { return kContactReach * object.shape.radius; }

/// Distance along its motion, in steps.
constexpr double kStepsAhead = 3;

/// Returns the largest speed of its points by rotation [m/s].
double turning_speed(const Object& object) {
  return object.is_sphere() ? 0 : object.state.angular_velocity.norm() * object.shape.radius;
}

/// Finds the contact point of two convex parts that are not both solid hulls.
void find_point(Manifold& manifold, const PlacedShape& a, const PlacedShape& b, const Place& place_a,
                const Place& place_b, double reach) {
  const Separation apart = a.convex ? separation(a, b) : separation(b, a);
  const bool found = apart.distance < reach && !apart.normal.isZero();
  if (!found) return void(manifold.count = 0);
  const Vec3 other = apart.point_on_b + apart.distance * apart.normal,
             normal = a.convex ? apart.normal : Vec3(-apart.normal);
  const FoundPoint point{place_b.to_local(a.convex ? other : apart.point_on_b),
                         place_b.to_local(a.convex ? apart.point_on_b : other), apart.distance};
  set_points(manifold, {&point, 1}, place_b.rotation.transpose() * normal, relative(place_a, place_b),
             std::numeric_limits<double>::max());
}

/// Returns the face of a hull most opposed to `up`, in the hull's frame; null for a hull without faces.
const Hull::Face* lower_face(const Hull& hull, const Vec3& up) {
  const auto lowest =
      std::ranges::min_element(hull.faces, {}, [&](const Hull::Face& face) { return up.dot(face.normal); });
  return lowest == hull.faces.end() ? nullptr : &*lowest;
}

/// Corners of a hull that touch the ground first: those of its lower half, and those of the face on which it may come
/// to rest. The upper side of a thin slab is near the ground but does not touch it.
class LowerCorners {
 public:
  LowerCorners(const Hull& hull, const Vec3& up) : hull_(hull), up_(up), face_(lower_face(hull, up)) {
    const auto height = [&](const Vec3& corner) { return up.dot(corner); };
    const auto [lowest, highest] = std::ranges::minmax(hull.corners | std::views::transform(height));
    lowest_ = lowest;
    middle_ = (lowest + highest) / 2;
  }

  double lowest() const { return lowest_; }
  bool contain(int corner) const {
    if (up_.dot(hull_.corners[corner]) <= middle_) return true;
    return face_ && std::ranges::count(std::span(hull_.loops).subspan(face_->first, face_->count), corner) > 0;
  }

 private:
  const Hull& hull_;
  Vec3 up_;
  const Hull::Face* face_;
  double lowest_, middle_;  // [m]
};

/// Finds where a hull meets the ground: in its lower corners, whatever their depth.
void find_ground_points(Manifold& manifold, const Hull& hull, const Place& place, double height, bool hull_is_a,
                        double reach, double tolerance) {
  const double lift = place.translation.y() - height;
  const Vec3 up = place.rotation.row(1).transpose();
  const LowerCorners lower(hull, up);
  if (!(lower.lowest() + lift < reach)) return void(manifold.count = 0);
  std::array<FoundPoint, kMostFound> found;
  std::size_t count = 0;
  for (int i = 0; i < static_cast<int>(hull.corners.size()) && count < found.size(); ++i) {
    const Vec3& corner = hull.corners[i];
    const double y = up.dot(corner) + lift;
    if (y > reach || !lower.contain(i)) continue;
    const Vec3 point = place.to_world(corner), foot(point.x(), height, point.z());
    found[count++] = hull_is_a ? FoundPoint{point, foot, y} : FoundPoint{place.to_local(foot), corner, y};
  }
  const Place ground, a_in_b = hull_is_a ? relative(place, ground) : relative(ground, place);
  set_points(manifold, {found.data(), count}, hull_is_a ? Vec3(Vec3::UnitY()) : Vec3(-up), a_in_b, tolerance);
}

/// True if the bounding spheres of two objects come within `gap` [m] of each other.
bool spheres_meet(const Object& a, const Object& b, double gap) {
  const double reach = a.shape.radius + b.shape.radius + gap;
  return (a.place.translation - b.place.translation).squaredNorm() < reach * reach;
}

}  // namespace

/// Returns an approach speed plus that of a fall for `dt` [s]. Objects that hardly move are supported [m/s].
double ContactWorld::Impl::with_fall(double speed, double dt) const {
  return speed + std::clamp(speed, 0.0, dt * gravity.norm());
}

/// Returns the gap below which two objects touch, or may within `dt` [s] [m].
double ContactWorld::Impl::reach(const Object& a, const Object& b, double dt) const {
  const double radius = a.kind == Kind::ground   ? b.shape.radius
                        : b.kind == Kind::ground ? a.shape.radius
                                                 : std::min(a.shape.radius, b.shape.radius);
  if (a.kind == Kind::projectile || b.kind == Kind::projectile) return kContactReach * radius;  // it is swept
  if (dt == 0) return kContactReach * radius;
  const Vec3 &of_a = a.state.velocity, &of_b = b.state.velocity;
  const double square = std::max({(of_a - of_b).squaredNorm(), of_a.squaredNorm(), of_b.squaredNorm()});
  const double speed = std::sqrt(square) + turning_speed(a) + turning_speed(b);
  return kContactReach * radius + std::min(dt * with_fall(speed, dt), radius);
}

/// Returns the box that a part does not leave within `dt` [s].
Box ContactWorld::Impl::box_of(const Object& object, int part, double dt) const {
  Vec3 center = object.place.translation, half = Vec3::Constant(object.shape.radius);
  if (!object.is_sphere()) {
    const Hull& hull = object.shape.hull(part);
    center = object.place.to_world(hull.box_center);
    half = object.place.rotation.cwiseAbs() * hull.box_half;
  }
  half.array() += contact_reach(object) + std::min(dt * turning_speed(object), object.shape.radius);
  const Vec3 way = dt * object.state.velocity;
  return {center - half + way.cwiseMin(0), center + half + way.cwiseMax(0)};
}

/// Returns the distance by which an object may leave its boxes in the tree within `dt` [s] at its present motion, 0 if
/// it stays in them [m].
double ContactWorld::Impl::way_out(const Object& object, double dt) const {
  if (object.leaves.empty()) return std::numeric_limits<double>::infinity();
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t part = 0; part < object.leaves.size(); ++part) {
    const Box box = box_of(object, static_cast<int>(part), dt), &room = tree.box(object.leaves[part]);
    farthest = std::max({farthest, (room.low - box.low).maxCoeff(), (box.high - room.high).maxCoeff()});
  }
  const double corrected =
      object.correction.translation.norm() + object.correction.rotation.norm() * object.shape.radius;
  return std::max(0.0, farthest + corrected + dt * dt * gravity.norm());
}

Strays ContactWorld::Impl::find_strays(double dt) const {
  Strays found;
  for (int i = 0; i < static_cast<int>(objects.size()); ++i) {
    if (!objects[i].exists || i == ground) continue;
    const double out = way_out(objects[i], dt);
    if (out > objects[i].shape.radius)
      found.objects.push_back(i);
    else
      found.distance = std::max(found.distance, out);
  }
  return found;
}

/// Calls use(a, b) for all objects that may meet within `dt` [s] at their present motions, a < b, some of them twice.
void ContactWorld::Impl::for_each_near(double dt, const std::function<void(int, int)>& use) const {
  struct Stray {
    int object;
    Box box;
  };
  std::vector<Stray> leaving;
  const auto use_ordered = [&](int a, int b) { use(std::min(a, b), std::max(a, b)); };
  for (const Pair& pair : pairs) use(pair.a, pair.b);
  for (int i = 0; i < static_cast<int>(objects.size()); ++i) {
    const Object& object = objects[i];
    if (!object.exists || i == ground || way_out(object, dt) == 0) continue;
    const double reach = object.shape.radius + dt * object.speed() + dt * dt * gravity.norm();
    const Vec3 &center = object.place.translation, room = Vec3::Constant(reach);
    leaving.push_back({i, {center - room, center + room}});
  }
  for (const Stray& stray : leaving) {
    if (ground >= 0 && stray.box.low.y() <= ground_height) use_ordered(stray.object, ground);
    tree.for_each(stray.box, [&](const BoxTree::Item& item) {
      if (item.object != stray.object) use_ordered(stray.object, item.object);
    });
  }
  for (auto a = leaving.begin(); a != leaving.end(); ++a)
    for (auto b = a + 1; b != leaving.end(); ++b)
      if (a->box.meets(b->box)) use(a->object, b->object);
}

/// Returns the objects that may enter a box within the step of the last advance(), ascending.
std::vector<int> ContactWorld::Impl::objects_near(const Box& box) const {
  std::vector<int> near = strays.objects;
  if (ground >= 0 && box.low.y() <= ground_height) near.push_back(ground);
  const Vec3 room = Vec3::Constant(strays.distance);
  tree.for_each({box.low - room, box.high + room}, [&](const BoxTree::Item& item) { near.push_back(item.object); });
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

/// Returns what has left its box, or had none, with a new one.
std::vector<BoxTree::Item> ContactWorld::Impl::update_boxes(double dt) {
  std::vector<BoxTree::Item> moved;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    Object& object = objects[i];
    if (!object.exists || object.kind == Kind::ground || !(object.active || object.fresh)) continue;
    const bool is_new = object.leaves.empty();
    if (is_new) object.leaves.resize(object.shape.parts.size());
    for (std::size_t part = 0; part < object.leaves.size(); ++part) {
      const Box box = box_of(object, static_cast<int>(part), dt);
      if (is_new || !tree.box(object.leaves[part]).holds(box)) {
        const Vec3 slack = Vec3::Constant(kSlack * object.shape.radius), way = kStepsAhead * dt * object.state.velocity;
        const BoxTree::Item item{static_cast<int>(i), static_cast<int>(part)};
        if (!is_new) tree.remove(object.leaves[part]);
        object.leaves[part] =
            tree.insert({box.low - slack + way.cwiseMin(0), box.high + slack + way.cwiseMax(0)}, item);
        moved.push_back(item);
      }
      scratch.keep_box(object.leaves[part], box);
    }
  }
  return moved;
}

void ContactWorld::Impl::erase_pairs(const std::function<bool(const Pair&)>& gone) {
  std::erase_if(pairs, [&](const Pair& pair) {
    if (!gone(pair)) return false;
    give_back_manifold(pair.manifold);
    return true;
  });
}

int ContactWorld::Impl::take_manifold() {
  if (free_manifolds.empty()) {
    manifolds.emplace_back();
    return static_cast<int>(manifolds.size()) - 1;
  }
  const int taken = free_manifolds.back();
  free_manifolds.pop_back();
  return taken;
}

void ContactWorld::Impl::give_back_manifold(int manifold) {
  if (manifold < 0) return;
  manifolds[manifold] = {};
  free_manifolds.push_back(manifold);
}

/// Moves the manifolds in use together once most are not in use: debris that flies apart needs many for a moment, and
/// every copy of the world would keep their memory.
void ContactWorld::Impl::compact_manifolds() {
  if (2 * free_manifolds.size() <= manifolds.size()) return;
  std::vector<Manifold> used;
  used.reserve(manifolds.size() - free_manifolds.size());
  for (Pair& pair : pairs) {
    if (pair.manifold < 0) continue;
    used.push_back(manifolds[pair.manifold]);
    pair.manifold = static_cast<int>(used.size()) - 1;
  }
  manifolds = std::move(used);
  free_manifolds.clear();
}

/// Removes pairs whose boxes have separated, of objects with new boxes.
void ContactWorld::Impl::drop_parted_pairs(const std::vector<bool>& moved) {
  const auto low = [&](int object, int part) { return tree.box(objects[object].leaves[part]).low.y(); };
  erase_pairs([&](const Pair& pair) {
    if (!moved[pair.a] && !moved[pair.b]) return false;
    const Object &a = objects[pair.a], &b = objects[pair.b];
    if (a.kind == Kind::ground) return low(pair.b, pair.part_b) > ground_height;
    if (b.kind == Kind::ground) return low(pair.a, pair.part_a) > ground_height;
    return !tree.box(a.leaves[pair.part_a]).meets(tree.box(b.leaves[pair.part_b]));
  });
}

/// Finds where the pairs of each object begin of which it is the first.
void ContactWorld::Impl::find_first_pairs() {
  scratch.first_pairs.assign(objects.size() + 1, 0);
  for (const Pair& pair : pairs) ++scratch.first_pairs[pair.a + 1];
  std::partial_sum(scratch.first_pairs.begin(), scratch.first_pairs.end(), scratch.first_pairs.begin());
}

void ContactWorld::Impl::add_pairs_of(const BoxTree::Item& item, std::vector<Pair>& found) const {
  const Object& object = objects[item.object];
  const auto add = [&](const BoxTree::Item& other) {
    if (other.object == item.object) return;
    const bool first = item.object < other.object;
    const BoxTree::Item &a = first ? item : other, &b = first ? other : item;
    const Pair pair{a.object, b.object, a.part, b.part, -1, 0};
    const auto of_a = std::span(pairs).subspan(scratch.first_pairs[a.object],
                                               scratch.first_pairs[a.object + 1] - scratch.first_pairs[a.object]);
    if (!std::ranges::binary_search(of_a, pair.key(), std::ranges::less(), &Pair::key)) found.push_back(pair);
  };
  const Box& box = tree.box(object.leaves[item.part]);
  tree.for_each(box, add);
  if (ground >= 0 && box.low.y() <= ground_height) add({ground, 0});
}

void ContactWorld::Impl::update_pairs(std::span<const BoxTree::Item> moved) {
  if (moved.empty()) return;
  std::vector<bool> has_moved(objects.size(), false);
  for (const BoxTree::Item& item : moved) has_moved[item.object] = true;
  drop_parted_pairs(has_moved);
  find_first_pairs();
  std::vector<Pair>& found = scratch.found;
  found.clear();
  for (const BoxTree::Item& item : moved) add_pairs_of(item, found);
  if (found.empty()) return;
  std::ranges::sort(found, std::ranges::less(), &Pair::key);
  const auto same = [](const Pair& left, const Pair& right) { return left.key() == right.key(); };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
  const auto middle = static_cast<std::ptrdiff_t>(pairs.size());
  pairs.insert(pairs.end(), found.begin(), found.end());
  std::inplace_merge(pairs.begin(), pairs.begin() + middle, pairs.end(),
                     [](const Pair& left, const Pair& right) { return left.key() < right.key(); });
}

/// Returns the box that a part does not leave in this step, with room in it if it stays where it is.
const Box& ContactWorld::Impl::present_box(const Object& object, int part) const {
  const int leaf = object.leaves[part];
  return object.active || object.fresh ? scratch.boxes[leaf] : tree.box(leaf);
}

/// True if two parts may touch whose objects are nearer than `gap` [m] then.
bool ContactWorld::Impl::parts_may_touch(const Pair& pair, double gap) const {
  const Object &a = objects[pair.a], &b = objects[pair.b];
  if (a.kind == Kind::ground) return present_box(b, pair.part_b).low.y() <= ground_height;
  if (b.kind == Kind::ground) return present_box(a, pair.part_a).low.y() <= ground_height;
  return spheres_meet(a, b, gap) && present_box(a, pair.part_a).meets(present_box(b, pair.part_b));
}

/// Lists the pairs that may touch and of which one side may have moved. Only these need a manifold, besides those at
/// rest: most boxes that overlap hold objects that stay apart.
void ContactWorld::Impl::list_close_pairs(double dt) {
  scratch.close_pairs.clear();
  for (int i = 0; i < static_cast<int>(pairs.size()); ++i) {
    Pair& pair = pairs[i];
    const Object &a = objects[pair.a], &b = objects[pair.b];
    if (!a.active && !b.active && !a.fresh && !b.fresh) continue;
    const double gap = reach(a, b, dt);
    if (pair.count > 0 || parts_may_touch(pair, gap)) {
      if (pair.manifold < 0) pair.manifold = take_manifold();
      scratch.close_pairs.push_back({i, gap});
    } else {
      give_back_manifold(std::exchange(pair.manifold, -1));
    }
  }
}

/// Finds the contact points of each close pair.
void ContactWorld::Impl::find_points(double dt) {
  constexpr int kPairsAtOnce = 32;
  list_close_pairs(dt);
  parallel_for(static_cast<int>(scratch.close_pairs.size()), kPairsAtOnce, [&](int begin, int end) {
    for (const auto& [index, gap] : std::span(scratch.close_pairs).subspan(begin, end - begin)) {
      Pair& pair = pairs[index];
      find_points(pair, manifolds[pair.manifold], {objects[pair.a].state.pose, objects[pair.a].place},
                  {objects[pair.b].state.pose, objects[pair.b].place}, gap);
      pair.count = manifolds[pair.manifold].count;
    }
  });
}

void ContactWorld::Impl::find_points(const Pair& pair, Manifold& manifold, const Placement& at_a, const Placement& at_b,
                                     double gap) const {
  const Object &a = objects[pair.a], &b = objects[pair.b];
  const auto is_hull = [](const Object& object) { return object.kind != Kind::ground && !object.is_sphere(); };
  if (is_hull(a) && is_hull(b) && a.shape.hull(pair.part_a).is_solid() && b.shape.hull(pair.part_b).is_solid())
    return find_contacts(manifold, {a.shape.hull(pair.part_a), a.shape.radius},
                         {b.shape.hull(pair.part_b), b.shape.radius}, relative(at_a.place, at_b.place), gap);
  if (b.kind == Kind::ground && is_hull(a))
    return find_ground_points(manifold, a.shape.hull(pair.part_a), at_a.place, ground_height, true, gap,
                              0.1 * a.shape.radius);
  if (a.kind == Kind::ground && is_hull(b))
    return find_ground_points(manifold, b.shape.hull(pair.part_b), at_b.place, ground_height, false, gap,
                              0.1 * b.shape.radius);
  const auto shape = [&](const Object& object, int part, const Pose& pose) {
    return placed(object, part, to_bullet(pose), ground_height);
  };
  find_point(manifold, shape(a, pair.part_a, at_a.pose), shape(b, pair.part_b, at_b.pose), at_a.place, at_b.place, gap);
}

}  // namespace griffith
