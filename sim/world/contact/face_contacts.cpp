#include "sim/world/contact/face_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "sim/core/sort_unique.h"
#include "sim/mesh/topology.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/contact/quasi_static.h"
#include "sim/world/contact/touched_body.h"

namespace griffith {
namespace {

constexpr double kAlike = 0.95;          // cosine between normals of one face
constexpr double kReach = 0.5;           // of an element: farther nodes do not touch
constexpr double kTouchingReach = 0.02;  // of an element: a gap that still counts as touching
constexpr double kForesight = 2;         // of the way of a node in a substep
constexpr double kClosing = 0.9;     // of it: the gap closes in the substep, which ends before what microsteps follow
constexpr double kSamePlace = 0.01;  // of an element

/// Coordinates in the contact plane and along the normal.
struct FaceFrame {
  Mat3 axes;  // rows: first, second, normal
  explicit FaceFrame(const Vec3& normal) {
    const Vec3 first = normal.unitOrthogonal();
    axes << first.transpose(), normal.cross(first).transpose(), normal.transpose();
  }
};

struct FaceNode {
  NodeId node;
  Vec3 place;  // in the frame
};

struct FaceTriangle {
  std::array<Vec3, 3> corners;  // in the frame
  double low, high;             // along the first axis
};

/// Part of a body's surface that faces the other side of a contact, sorted along the first axis.
struct Face {
  std::vector<FaceNode> nodes;
  std::vector<FaceTriangle> triangles;
  double widest = 0;
};

/// Two bodies whose faces meet, with the `normal` from b to a, an approximate place and the contacts there.
struct FacePair {
  ProxyId a, b;
  Vec3 normal;
  Eigen::AlignedBox3d patch;
  std::vector<int> contacts = {};
};

/// True if impulses deform an object together with its neighbors.
bool is_coupled(const WorldState& world, ProxyId object) {
  const BodyId id = world.body_of(object);
  return id.valid() && world.bodies[id].is_deformable() && !world.bodies[id].quasi_static;
}

bool is_any_coupled(const WorldState& world, const Contact& contact) {
  return is_coupled(world, contact.a) || is_coupled(world, contact.b);
}

/// True if two objects touch as rigid ones, and what they do deforms one of them afterwards.
bool is_any_quasi_static(const WorldState& world, const Contact& contact) {
  const auto is_quasi_static = [&](ProxyId object) {
    const BodyId id = world.body_of(object);
    return id.valid() && world.bodies[id].is_deformable() && world.bodies[id].quasi_static;
  };
  return !is_any_coupled(world, contact) && (is_quasi_static(contact.a) || is_quasi_static(contact.b));
}

/// Overlap of two bodies up to which their faces still meet [elements]: detection finds overlaps of rounding errors
/// between touching bodies.
constexpr double kNegligibleOverlap = 1e-6;

/// Returns groups of at least three detected contacts of two bodies with similar normals, of contacts that `matters`.
std::vector<FacePair> face_pairs(const WorldState& world, bool (*matters)(const WorldState&, const Contact&)) {
  struct FaceGroup {
    FacePair pair;
    bool spread = false;
  };
  std::map<std::pair<ProxyId, ProxyId>, std::vector<FaceGroup>> groups;
  const std::span<const Contact> contacts = world.contact_world.contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    const BodyId a = world.body_of(contact.a), b = world.body_of(contact.b);
    if (!a.valid() || !b.valid() || !matters(world, contact)) continue;
    const double overlap = world.contact_world.allowed_overlap(contact.a, contact.b);
    if (overlap > kNegligibleOverlap * world.bodies[a].element_size) continue;
    std::vector<FaceGroup>& of_pair = groups[{contact.a, contact.b}];
    auto group = std::ranges::find_if(
        of_pair, [&](const FaceGroup& other) { return other.pair.normal.dot(contact.normal) > kAlike; });
    if (group == of_pair.end())
      group = of_pair.insert(of_pair.end(), FaceGroup{{contact.a, contact.b, contact.normal, {}}});
    group->pair.patch.extend(contact.position);
    group->spread |= is_of_nodes(contact);
    group->pair.contacts.push_back(static_cast<int>(i));
  }
  std::vector<FacePair> pairs;
  for (const auto& [objects, of_pair] : groups)
    for (const FaceGroup& group : of_pair)
      if (group.pair.contacts.size() >= 3 && !group.spread) pairs.push_back(group.pair);
  return pairs;
}

/// Returns the faces of a side: 1 for those that face along the normal, −1 for those against it.
Face face_of(const WorldState& world, const std::vector<Vec3>& places, const Body& body, const FaceFrame& frame,
             double side, const Eigen::AlignedBox3d& region) {
  Face face;
  std::set<NodeId> nodes;
  for (const SurfaceFace& surface : body.surface) {
    const std::array<NodeId, 3> ids = face_nodes(world.mesh, surface.tet, surface.face);
    FaceTriangle triangle;
    Eigen::AlignedBox3d box;
    for (int i = 0; i < 3; ++i) box.extend(places[ids[i]]);
    if (!region.intersects(box)) continue;
    for (int i = 0; i < 3; ++i) triangle.corners[i] = frame.axes * places[ids[i]];
    const auto& [p, q, r] = triangle.corners;
    const Vec3 area = (q - p).cross(r - p);
    if (side * area.z() < kAlike * area.norm()) continue;
    triangle.low = std::min({p.x(), q.x(), r.x()});
    triangle.high = std::max({p.x(), q.x(), r.x()});
    face.widest = std::max(face.widest, triangle.high - triangle.low);
    face.triangles.push_back(triangle);
    for (int i = 0; i < 3; ++i)
      if (nodes.insert(ids[i]).second) face.nodes.push_back({ids[i], triangle.corners[i]});
  }
  std::ranges::sort(face.nodes, [](const FaceNode& a, const FaceNode& b) {
    return a.place.x() != b.place.x() ? a.place.x() < b.place.x() : a.node < b.node;
  });
  std::ranges::stable_sort(face.triangles, std::ranges::less(), &FaceTriangle::low);
  return face;
}

/// Returns the height of a triangle over the contact plane at a point; empty outside.
std::optional<double> height_at(const FaceTriangle& triangle, const Vec3& point) {
  constexpr double kOutside = -0.02;  // corners that meet corners touch though they shift a little
  const auto& [a, b, c] = triangle.corners;
  const auto area = [](const Vec3& u, const Vec3& v) { return u.x() * v.y() - u.y() * v.x(); };
  const double whole = area(b - a, c - a);
  const double u = area(c - b, point - b) / whole, v = area(a - c, point - c) / whole, w = 1 - u - v;
  if (u < kOutside || v < kOutside || w < kOutside) return {};
  return u * a.z() + v * b.z() + w * c.z();
}

std::optional<double> height_at(const Face& face, const Vec3& point) {
  auto triangle =
      std::ranges::lower_bound(face.triangles, point.x() - face.widest, std::ranges::less(), &FaceTriangle::low);
  for (; triangle != face.triangles.end() && triangle->low <= point.x(); ++triangle) {
    if (triangle->high < point.x()) continue;
    if (const std::optional<double> height = height_at(*triangle, point)) return height;
  }
  return {};
}

/// Returns the node at a point, seen along the normal, or null. Nodes are sorted.
const FaceNode* node_at(const std::vector<FaceNode>& nodes, const Vec3& point, double tolerance) {
  auto node = std::ranges::lower_bound(nodes, point.x() - tolerance, std::ranges::less(),
                                       [](const FaceNode& other) { return other.place.x(); });
  for (; node != nodes.end() && node->place.x() <= point.x() + tolerance; ++node)
    if ((node->place - point).head<2>().norm() <= tolerance) return &*node;
  return nullptr;
}

/// Adds contacts at nodes of both faces within reach of the other.
void add_face_contacts(const WorldState& world, const std::vector<Vec3>& places, const FacePair& pair,
                       std::vector<Contact>& added) {
  const Body &a = world.bodies[world.body_of(pair.a)], &b = world.bodies[world.body_of(pair.b)];
  const double size = std::min(a.element_size, b.element_size), reach = kReach * size;
  Eigen::AlignedBox3d region = pair.patch;
  region.extend(Vec3(pair.patch.min().array() - reach));
  region.extend(Vec3(pair.patch.max().array() + reach));
  const FaceFrame frame(pair.normal);
  const Face face_a = face_of(world, places, a, frame, -1, region),
             face_b = face_of(world, places, b, frame, 1, region);
  const bool acts_on_a = acts_on_first(world, pair.a, pair.b);
  const auto add = [&](const FaceNode& node, double distance, double across, NodeId node_a, NodeId node_b) {
    const Vec3 place = places[node.node] + across * pair.normal;
    if (std::abs(distance) < reach)
      added.push_back({pair.a, pair.b, place, pair.normal, distance, 0, Vec3::Zero(), node_a, node_b});
  };
  std::vector<FaceNode> touching;
  for (const FaceNode& node : face_a.nodes)
    if (const std::optional<double> height = height_at(face_b, node.place)) {
      const double distance = node.place.z() - *height;
      const FaceNode* met = node_at(face_b.nodes, node.place, kSamePlace * size);
      add(node, distance, acts_on_a ? 0 : -distance, node.node, met ? met->node : NodeId());
      touching.push_back(node);
    }
  for (const FaceNode& node : face_b.nodes)
    if (const std::optional<double> height = height_at(face_a, node.place)) {
      if (node_at(touching, node.place, kSamePlace * size)) continue;
      const double distance = *height - node.place.z();
      add(node, distance, acts_on_a ? distance : 0, NodeId(), node.node);
    }
}

/// True if the ground acts on a body and deforms it: where it stands still on supports, they carry it.
bool may_lie_on_ground(const WorldState& world, const Body& body, ProxyId ground) {
  if (!is_coupled(world, body.proxy) || body.explicit_state) return false;
  if (!body.supported()) return true;
  const auto is_this = [&](const Contact& contact) {
    return (contact.a == body.proxy && contact.b == ground) || (contact.b == body.proxy && contact.a == ground);
  };
  return std::ranges::any_of(world.contact_world.contacts(), is_this);
}

/// Returns, per face of a body's surface, true if it may face the ground within a substep of `dt` [s]: what looks up
/// has the body between itself and the ground. Not for soft bodies: they fold, so that any face may come to lie below.
std::vector<bool> faces_downward(const WorldState& world, const std::vector<Vec3>& places, const Body& body,
                                 double dt) {
  constexpr double kLevel = 1e-3;
  const double turned = dt * motion_of(world, body).angular_velocity.norm();
  std::vector<bool> downward(body.surface.size());
  for (std::size_t i = 0; i < body.surface.size(); ++i) {
    const auto [p, q, r] = face_nodes(world.mesh, body.surface[i].tet, body.surface[i].face);
    const Vec3 area = (places[q] - places[p]).cross(places[r] - places[p]);
    downward[i] = area.y() < (turned - kLevel) * area.norm();
  }
  return downward;
}

/// Adds the nodes of a body that touch the ground, or may in a substep of `dt` [s].
void add_ground_contacts(const WorldState& world, const std::vector<Vec3>& places, const Body& body, ProxyId ground,
                         double dt, std::vector<Contact>& added) {
  const double height = world.model->scene.ground->height, reach = kTouchingReach * body.element_size;
  const double fall = std::max(0.0, -dt * dt * world.model->scene.gravity.y());
  const bool has_microsteps = world.model->scene.simulation.integrator == Integrator::hybrid;
  const double left_to_microsteps =
      has_microsteps ? damage_speed(world, body) : std::numeric_limits<double>::infinity();
  double fastest = 0;  // of a soft body: its nodes pull one another down
  const bool is_soft = deforms_visibly(world, body);
  if (is_soft)
    for (const NodeId node : body.nodes) fastest = std::max(fastest, -world.nodes.velocities[node].y());
  std::vector<NodeId> nodes;
  const std::vector<bool> downward =
      is_soft ? std::vector<bool>(body.surface.size(), true) : faces_downward(world, places, body, dt);
  for (std::size_t i = 0; i < body.surface.size(); ++i)
    for (const NodeId node : face_nodes(world.mesh, body.surface[i].tet, body.surface[i].face)) {
      if (!downward[i]) break;
      const double speed = std::max(fastest, -world.nodes.velocities[node].y());
      const double foresight = speed < left_to_microsteps ? kForesight : kClosing;
      if (!world.nodes.has_support[node] && places[node].y() - height < reach + foresight * (dt * speed + fall))
        nodes.push_back(node);
    }
  sort_unique(nodes);
  for (const NodeId node : nodes) {
    const double distance = places[node].y() - height;
    added.push_back({body.proxy, ground, places[node], Vec3::UnitY(), distance, 0, Vec3::Zero(), node, NodeId()});
  }
}

/// Returns the contacts of a body with the ground as a patch.
FacePatch ground_patch(const WorldState& world, const std::vector<Vec3>& places, const Body& body, ProxyId ground,
                       std::vector<int> contacts) {
  FacePatch patch{std::move(contacts), {}};
  const double height = world.model->scene.ground->height;
  std::vector<NodeId> nodes;
  for (const SurfaceFace& face : body.surface)
    for (const NodeId node : face_nodes(world.mesh, face.tet, face.face))
      if (places[node].y() - height < kTouchingReach * body.element_size) nodes.push_back(node);
  sort_unique(nodes);
  for (const NodeId node : nodes)
    patch.nodes.push_back({body.proxy, ground, places[node], Vec3::UnitY(), 0, 0, Vec3::Zero(), node, NodeId()});
  return patch;
}

/// Adds what elastic bodies have on the ground, once for each, and marks what was detected there at the start.
void add_all_ground_contacts(const WorldState& world, const std::vector<Vec3>& places, double dt,
                             std::vector<Contact>& added, std::vector<bool>& replaced) {
  const std::optional<ProxyId> ground = world.contact_world.ground();
  if (!ground) return;
  const std::span<const Contact> contacts = world.contact_world.contacts();
  std::set<ProxyId> known, done;
  for (const Contact& contact : contacts)
    if (is_of_nodes(contact))
      for (const auto& [side, other] : {std::pair(contact.a, contact.b), std::pair(contact.b, contact.a)})
        if (other == *ground) known.insert(side);
  for (const Body& body : world.bodies)
    if (may_lie_on_ground(world, body, *ground) && !known.contains(body.proxy)) {
      add_ground_contacts(world, places, body, *ground, dt, added);
      done.insert(body.proxy);
    }
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (const auto& [side, other] : {std::pair(contacts[i].a, contacts[i].b), std::pair(contacts[i].b, contacts[i].a)})
      if (other == *ground && done.contains(side) && contacts[i].position_at == PositionTime::start) replaced[i] = true;
}

auto objects_of(const Contact& contact) { return std::pair(contact.a, contact.b); }

/// True if a detected contact is at one of the added ones, which are sorted by their objects.
bool is_doubled(const Contact& contact, std::span<const Contact> added, double tolerance) {
  return !is_of_nodes(contact) &&
         std::ranges::any_of(std::ranges::equal_range(added, objects_of(contact), std::ranges::less(), objects_of),
                             [&](const Contact& node) {
                               return node.normal.dot(contact.normal) > kAlike &&
                                      (node.position - contact.position).norm() < tolerance;
                             });
}

/// Returns the size of the smaller elements at a contact [m].
double element_size(const WorldState& world, const Contact& contact) {
  double size = std::numeric_limits<double>::infinity();
  for (const ProxyId side : {contact.a, contact.b})
    if (const BodyId id = world.body_of(side); id.valid()) size = std::min(size, world.bodies[id].element_size);
  return size;
}

}  // namespace

SpreadContacts spread_contacts(const WorldState& world, double dt) {
  const std::span<const Contact> contacts = world.contact_world.contacts();
  SpreadContacts result{std::vector<bool>(contacts.size(), false), {}};
  auto& [replaced, added] = result;
  const std::vector<Vec3> places = touching_places(world);
  add_all_ground_contacts(world, places, dt, added, replaced);
  for (const FacePair& pair : face_pairs(world, is_any_coupled)) add_face_contacts(world, places, pair, added);
  std::ranges::stable_sort(added, std::ranges::less(), objects_of);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (is_doubled(contacts[i], added, kSamePlace * element_size(world, contacts[i]))) replaced[i] = true;
  return result;
}

namespace {

/// Drops nodes that are farther from the other side than those that touch.
void keep_touching(const WorldState& world, std::vector<Contact>& nodes) {
  double least = std::numeric_limits<double>::infinity();
  for (const Contact& node : nodes) least = std::min(least, node.distance);
  std::erase_if(
      nodes, [&](const Contact& node) { return node.distance > least + kTouchingReach * element_size(world, node); });
}

}  // namespace

std::vector<FacePatch> rigid_patches(const WorldState& world) {
  std::vector<FacePatch> patches;
  const std::span<const Contact> contacts = world.contact_world.contacts();
  if (std::ranges::none_of(contacts, [&](const Contact& contact) { return is_any_quasi_static(world, contact); }))
    return patches;
  const std::vector<Vec3> places = touching_places(world);
  for (FacePair& pair : face_pairs(world, is_any_quasi_static)) {
    FacePatch& patch = patches.emplace_back();
    add_face_contacts(world, places, pair, patch.nodes);
    keep_touching(world, patch.nodes);
    patch.contacts = std::move(pair.contacts);
  }
  const std::optional<ProxyId> ground = world.contact_world.ground();
  std::map<BodyId, std::vector<int>> on_ground;
  for (std::size_t i = 0; ground && i < contacts.size(); ++i)
    if ((contacts[i].a == *ground || contacts[i].b == *ground) && is_any_quasi_static(world, contacts[i]))
      on_ground[world.body_of(contacts[i].a == *ground ? contacts[i].b : contacts[i].a)].push_back(static_cast<int>(i));
  for (auto& [body, of_body] : on_ground)
    patches.push_back(ground_patch(world, places, world.bodies[body], *ground, std::move(of_body)));
  return patches;
}

}  // namespace griffith
