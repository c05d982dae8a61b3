#pragma once

// Private to sim/contact: what ContactWorld keeps.

#include <functional>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "sim/contact/box_tree.h"
#include "sim/contact/bullet/shapes.h"
#include "sim/contact/bullet/sweep.h"
#include "sim/contact/contact_world.h"
#include "sim/contact/manifold.h"
#include "sim/contact/rigid_solver.h"

namespace griffith::contact {

struct Object;
double smaller_radius(const Object& a, const Object& b);
/// Returns the thickness of the thinner one; that of the other where one is the ground [m].
double smaller_thickness(const Object& a, const Object& b);
/// Returns the inertia of a free object about its center of mass, in the world frame [kg·m²].
Mat3 world_inertia(const Object& object);
/// Returns its inverse [1/(kg·m²)].
Mat3 inverse_world_inertia(const Object& object);
/// Returns the kinetic energy of a free object for these velocities at its present orientation [J].
double kinetic_energy(const Object& object, const Vec3& velocity, const Vec3& spin);
/// Returns the distance without the allowed overlap; a gap stays a gap.
double distance_beyond(double distance, double allowed_overlap);

enum class Kind { ground, projectile, proxy };

struct alignas(64) Object {
  // What a substep asks of every object, moving or not, in one line of the cache.
  Kind kind;
  Mobility mobility;
  bool asleep = false;      ///< at rest: neither moved nor examined until it is disturbed
  bool elastic = false;     ///< its owner answers the impulses of the present solve
  bool rebounds = true;     ///< in the present solve, by the coefficient of restitution
  int hinge = -1;           ///< index into those of the present solve, -1 without one
  bool fresh = true;        ///< true until detect() has used its shape
  bool parted = true;       ///< true if a fresh shape is that of another piece, not of the same one deformed
  bool exists = true;       ///< until removed
  bool active = true;       ///< what is not active is looked at only where something active comes near: sleepers, the
                            ///< ground, and what is held and was not just displaced
  bool carried = false;     ///< held, and something held pushed it in the last substep
  double inverse_mass = 0;  ///< 0 when held
  double impact_speed = std::numeric_limits<double>::infinity();  ///< least speed of a damaging impact [m/s]
  double still_time = 0;             ///< time for which it has hardly left its resting place [s]
  std::optional<bool> settled = {};  ///< true if it has come to rest; empty unless its owner reports it

  Shape shape;
  Place place = {};              ///< as `state` has it
  std::vector<int> leaves = {};  ///< per part, in the tree of boxes
  RigidState state = {};         ///< as its owner set it or, after advance(), with the solved velocities
  SurfaceProperties surface = {};
  Vec3 first_velocity = Vec3::Zero(), first_spin = Vec3::Zero();  ///< velocities at the start of the substep
  Vec3 spin_taken = Vec3::Zero();       ///< by rolling resistance, from the spin with which it turned [rad/s]
  Mat3 inverse_inertia = Mat3::Zero();  ///< in its own frame
  ContactWorld::Correction correction = {};
  Vec3 pushed_out = Vec3::Zero();  ///< projectiles: the correction that the last advance() made [m]
  Pose resting_place = {};         ///< place that it has hardly left
  double dissipated = 0;           ///< energy taken by contacts, less that returned by corrections [J]

  bool is_free() const { return exists && mobility == Mobility::free; }
  bool moves() const { return is_free() && !asleep; }
  bool is_sphere() const { return shape.is_sphere(); }
  /// True if it is awake and could fall asleep.
  bool may_sleep() const { return moves() || (settled && !asleep); }
  /// Returns the number of its convex parts, 1 for the ground.
  std::size_t part_count() const { return kind == Kind::ground ? 1 : shape.parts.size(); }
  /// Returns the speed of its fastest point [m/s].
  double speed() const { return state.velocity.norm() + state.angular_velocity.norm() * shape.radius; }
  /// Returns its mean velocity in this substep of `dt` [s], including corrections [m/s].
  Vec3 mean_velocity(double dt) const { return state.velocity + correction.translation / dt; }
  /// True if impulses change its velocities in the present solve.
  bool responds() const { return elastic || moves(); }
  /// True in the same case, or if impulses rotate it about a hinge.
  bool yields() const { return responds() || hinge >= 0; }
};

/// Returns a convex part of an object at its place, or the ground.
PlacedShape placed(const Object& object, std::size_t part, const btTransform& place, double ground_height);
/// True if the bounding spheres of two objects come within `gap` [m] of each other while `a` is displaced from `start`.
bool may_touch(const Object& a, const Vec3& start, const Vec3& displacement, const Object& b, double gap,
               double ground_height);

/// True if a point of an object of this radius has moved farther than `distance` [m] from its previous position.
bool has_left(const Pose& then, const Pose& now, double distance, double radius);

/// Allowed overlap of a pair after a crack between the two. Ordered by the pair.
struct Allowance {
  ProxyId a, b;
  double overlap;  ///< [m], > 0
};

/// Contact set by the owner, its place [m], and the mean force on a there in the last substep [N].
struct NodeContact {
  ProxyId a, b;
  NodeId node_a, node_b;
  Vec3 position = Vec3::Zero(), force = Vec3::Zero();
  auto key() const { return std::tie(a, b, node_a, node_b); }
};

/// Two convex parts whose boxes overlap. Ordered by the objects, then the parts.
struct Pair {
  int a, b;            ///< objects, a < b
  int part_a, part_b;  ///< 0 in the ground
  int manifold;        ///< index into ContactState::manifolds; -1 while the two are too far from each other for one
  int count = 0;       ///< number of its points
  auto key() const { return std::tie(a, b, part_a, part_b); }
};

/// Returns the contact at a point of a manifold for these places of its objects.
Contact contact_at(const Pair& pair, const Manifold& manifold, const Manifold::Point& point, const Place& a,
                   const Place& b);

/// Objects outside their boxes in the tree within a step, by at most `distance` [m]. Those that move farther, or have
/// no box, are listed.
struct Strays {
  double distance = 0;
  std::vector<int> objects;
};

/// Location of the stored force of a contact: a pair's point, or a contact of the owner.
struct Memory {
  int manifold = -1, point = 0;
  int node_contact = -1;  ///< index into ContactState::node_contacts
};

/// Least speed of impacts that count [m/s], and accuracy of their times [s].
struct ImpactRule {
  double minimum_speed, tolerance;
};

/// Motion of an object in free flight: x + t (v + t g), with uniform rotation.
struct Course {
  Vec3 velocity, acceleration, spin;  ///< [m/s], [m/s²], [rad/s]
};

/// Lists that each substep fills, kept so that their memory is reused. They are no part of a world's value.
struct SubstepScratch {
  struct ClosePair {
    int pair;    ///< index into ContactState::pairs
    double gap;  ///< below which its points are listed [m]
  };
  std::vector<ClosePair> close_pairs;
  std::vector<Box> boxes;        ///< per leaf of the tree, of what is active: where it may be in this step
  std::vector<int> first_pairs;  ///< per object: its first pair as the first of the two; and the end
  std::vector<Pair> found;
  std::vector<bool> unlisted;           ///< per object: detect() has left out approaches of it that could cause damage
  bool is_solved = false;               ///< true once the contacts of the last detect() have been solved
  std::vector<RigidBody> rigid_bodies;  ///< per object, as the last solve() moved them
  std::vector<RigidContact> rigid_contacts;  ///< contacts of groups without deformable objects
  std::vector<int> contact_of_row;           ///< per rigid contact: index into ContactState::contacts

  void keep_box(int leaf, const Box& box) {
    if (leaf >= static_cast<int>(boxes.size())) boxes.resize(leaf + 1);
    boxes[leaf] = box;
  }

  SubstepScratch() = default;
  SubstepScratch(const SubstepScratch&) {}
  SubstepScratch& operator=(const SubstepScratch&) { return *this; }
};

/// State of a world between substeps: a value.
struct ContactState {
  Vec3 gravity = Vec3::Zero();
  double ground_height = 0;
  int ground = -1;              ///< the object that is the ground, -1 without one
  std::vector<Object> objects;  ///< by ProxyId
  std::vector<Allowance> allowances;
  std::vector<Contact> contacts;
  std::vector<NodeContact> node_contacts;       ///< contacts set by the owner
  std::vector<NodeContact> past_node_contacts;  ///< node contacts of the last substep, by key
  std::vector<Memory> memories;                 ///< per contact

  BoxTree tree;                     ///< boxes of all parts, with room to move in
  std::vector<Pair> pairs;          ///< in their order
  std::vector<Manifold> manifolds;  ///< manifolds of the pairs; those of parted pairs are reused
  std::vector<int> free_manifolds;
  Strays strays;  ///< state for the motion of the last advance()

  std::vector<ContactWorld::Law> laws;   ///< laws of contacts in groups with a deformable object, of the last solve()
  std::vector<int> law_of_contact;       ///< per contact: index into `laws`, -1 where all is rigid
  std::vector<HingedObject> hinged;      ///< input of the last solve()
  std::vector<RigidGroup> rigid_groups;  ///< groups in which nothing deforms, of the last solve()
  std::vector<bool> moves_rigidly;       ///< per object: in one of these
  std::vector<int> elastic_contacts;     ///< all others
};

}  // namespace griffith::contact

namespace griffith {

struct ContactWorld::Impl : contact::ContactState {
  explicit Impl(const Vec3& world_gravity) { gravity = world_gravity; }

  contact::SubstepScratch scratch;

  // Objects.
  ProxyId add(contact::Object object, const RigidMass& mass);
  void attach(ProxyId id, const RigidMass& mass);
  void retire(ProxyId id);
  void place(contact::Object& object);

  // Detection.
  void detect(double dt);
  bool all_at_rest() const;
  std::vector<contact::BoxTree::Item> update_boxes(double dt);
  contact::Box box_of(const contact::Object& object, int part, double dt) const;
  double way_out(const contact::Object& object, double dt) const;
  contact::Strays find_strays(double dt) const;
  std::vector<int> objects_near(const contact::Box& box) const;
  void for_each_near(double dt, const std::function<void(int, int)>& use) const;
  void update_pairs(std::span<const contact::BoxTree::Item> moved);
  void drop_parted_pairs(const std::vector<bool>& moved);
  void add_pairs_of(const contact::BoxTree::Item& item, std::vector<contact::Pair>& found) const;
  void find_first_pairs();
  int take_manifold();
  void give_back_manifold(int manifold);
  void compact_manifolds();
  const contact::Box& present_box(const contact::Object& object, int part) const;
  bool parts_may_touch(const contact::Pair& pair, double gap) const;
  void list_close_pairs(double dt);
  void erase_pairs(const std::function<bool(const contact::Pair&)>& gone);
  void find_points(double dt);
  struct Placement {
    const Pose& pose;
    const contact::Place& place;  ///< the same
  };
  void find_points(const contact::Pair& pair, contact::Manifold& manifold, const Placement& at_a, const Placement& at_b,
                   double gap) const;
  double with_fall(double speed, double dt) const;
  double reach(const contact::Object& a, const contact::Object& b, double dt) const;
  void update_allowances();
  double allowance(ProxyId a, ProxyId b) const;
  double closing_speed(const contact::Pair& pair, const Contact& contact) const;
  enum class Nearness { away, near, left_out };
  Nearness nearness_of(const contact::Pair& pair, const Contact& contact, double dt) const;
  void wake_disturbed(double dt);
  void list_contacts(double dt);
  void list_pair(std::span<const contact::Pair> of_pair, double dt);
  void drop_opposing_overlaps(std::size_t first);
  void drop_contacts(std::size_t first, const std::vector<bool>& drops);
  void inherit_forces();
  void inherit_forces(std::size_t first, std::size_t end);
  void replace_contacts(const std::vector<bool>& taken_out, std::span<const Contact> put_in);
  Vec3 remembered_force(const contact::Memory& memory) const;
  void remember_force(const contact::Memory& memory, const Vec3& force);

  // Solving.
  void drop_contacts_of(const std::vector<bool>& dropped);
  std::vector<int> drop_near_misses(double dt, std::span<const double> approach);
  int solve(double dt, std::span<const ElasticObject> elastic, std::span<const HingedObject> hinges);
  void prepare_elastic_groups(double dt, std::span<const ElasticObject> elastic);
  void add_law(int contact, double dt);
  void set_target(int contact, double dt);
  bool is_unsettled(const contact::RigidGroup& group, double dt) const;
  void leave_unsettled_groups(double dt);
  std::vector<std::vector<int>> elastic_groups() const;
  void split_groups();
  int solve_rigid_groups(double dt);
  contact::RigidBody rigid_body(const contact::Object& object, double dt) const;
  const Vec3& center(const contact::Object& object) const;
  RigidMass hinged_mass(const contact::Object& object) const;
  contact::RigidContact rigid_contact(std::size_t contact, double dt) const;
  Law law_of(const Contact& contact, const contact::Memory& memory, double dt) const;
  Vec3 rigid_velocity(ProxyId id, const Vec3& arm, double dt) const;
  double target_velocity(const Contact& contact, double dt) const;
  bool falls(const contact::Object& object, double dt) const;
  double rebound_speed(const Contact& contact, double dt) const;
  bool strikes(const Contact& contact, double dt) const;
  std::vector<std::pair<int, int>> touching_pairs() const;
  void advance(double dt);
  void remember_impulses(double dt);
  void note_carried();
  struct Momentum {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
  };
  std::vector<Momentum> impulse_sums() const;
  void read_back_impulses(double dt);
  void move_rigid_groups(double dt);
  void push_elastic_groups_apart(double dt);
  contact::RigidContact overlap_contact(const Contact& contact) const;
  void limit_lift(double dt);

  // Rest.
  double quiet_speed(const contact::Object& object) const;
  double touching_speed(const contact::Object& a, const contact::Object& b, double dt) const;
  void resist_rolling();
  void resist_rolling(const Contact& contact, double limit);
  void fall_asleep(double dt);
  void wake_up(ProxyId id);
  void wake_neighbors(ProxyId id);

  // Motion.
  bool move_projectiles(double dt);
  void turn_free(contact::Object& object, double dt);
  double deepest_overlap(const contact::Object& object) const;
  struct TouchAhead {
    double fraction;  ///< fraction of the substep
    const contact::Object* met;
    Vec3 normal;       ///< unit normal, toward the projectile
    std::size_t part;  ///< convex part of the other object
  };
  /// Surface that a projectile has touched and along which it slides or from which it moves away.
  struct LeftSurface {
    const contact::Object* object;
    std::size_t part;
    Vec3 normal;  ///< in the object's frame
    /// True for this surface. Parts with continuous surfaces count as one.
    bool is(const contact::Object& other, std::size_t other_part, const Vec3& other_normal) const;
  };
  /// Contacts that a sweep ignores: approaches of less than `slow` [m], and objects that do not stop it.
  struct SweepRule {
    double slow = 0;
    std::function<bool(ProxyId)> stops;  ///< all do where it is empty
  };
  /// An object that a projectile pushes ahead of itself.
  struct Pushed {
    std::size_t object;
    Vec3 displacement;  ///< [m]
  };
  Vec3 swept_end(const contact::Object& projectile, double dt, const SweepRule& rule,
                 std::vector<Pushed>& pushed) const;
  Vec3 velocity_after(const Vec3& velocity, const Vec3& displacement, double dt) const;
  double allowed_depth(const contact::Object& projectile, const contact::Object& other) const;
  void add_touches(const contact::Object& projectile, const contact::Object& other, const Vec3& center,
                   const Vec3& velocity, double fraction, double dt, double slow,
                   std::vector<TouchAhead>& touches) const;
  std::vector<TouchAhead> touches_ahead(const contact::Object& projectile, const Vec3& center, const Vec3& velocity,
                                        double fraction, double dt, const SweepRule& rule) const;
  Vec3 velocity_at_touch(const contact::Object& projectile, Vec3 velocity, const TouchAhead& touch, const Vec3& center,
                         double dt) const;

  // Impacts.
  contact::Course course_of(const contact::Object& object) const;
  std::optional<Encounter> expected_impact(const std::array<int, 2>& pair,
                                           const std::array<contact::Course, 2>& courses, double dt,
                                           const contact::ImpactRule& rule) const;
  double first_overlap(const contact::Pair& pair, const std::array<contact::Course, 2>& courses, double from,
                       double to) const;
  std::vector<Encounter> expected_impacts(double dt, const contact::ImpactRule& rule, const PairFilter& matters) const;
  struct EndOfStep;
  std::vector<Meeting> unlisted_meetings(double dt, const contact::ImpactRule& rule,
                                         const std::vector<bool>& left_out) const;
  EndOfStep end_of_step(std::size_t object, const Momentum& impulses, double dt) const;
  std::vector<EndOfStep> ends_of_step(double dt) const;
  std::vector<contact::Pair> pairs_at_end(const std::vector<EndOfStep>& ends) const;
  struct UnlistedPoints {
    std::vector<Contact> points;
    bool is_deep = false;  ///< as of Meeting
  };
  UnlistedPoints unlisted_points(const contact::Pair& pair, const std::vector<EndOfStep>& ends, double dt) const;
  bool is_listed(const Contact& contact) const;
  Meeting meeting_of(const contact::Pair& pair, const std::vector<EndOfStep>& ends, double dt,
                     const contact::ImpactRule& rule) const;
};

}  // namespace griffith
