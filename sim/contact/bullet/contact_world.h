#pragma once

// Private to sim/contact: what ContactWorld keeps.

#include <btBulletCollisionCommon.h>

#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "sim/contact/bullet/dispatcher.h"
#include "sim/contact/bullet/ground_contact.h"
#include "sim/contact/bullet/hull_contact.h"
#include "sim/contact/bullet/shapes.h"
#include "sim/contact/bullet/sphere_contact.h"
#include "sim/contact/bullet/sweep.h"
#include "sim/contact/contact_world.h"
#include "sim/contact/impulse_solver.h"

namespace griffith::contact {

/// Distance less the overlap that is allowed; a gap stays a gap.
double distance_beyond(double distance, double allowed_overlap);

enum class Kind { ground, projectile, proxy };

/// Bullet's object of one of ours. A copy has the same place and activity, and is in no world yet.
class OwnedObject {
 public:
  OwnedObject() = default;
  explicit OwnedObject(std::unique_ptr<btCollisionObject> object) : object_(std::move(object)) {}
  OwnedObject(OwnedObject&&) noexcept = default;
  OwnedObject& operator=(OwnedObject&&) noexcept = default;
  OwnedObject(const OwnedObject& other);
  OwnedObject& operator=(const OwnedObject& other) { return *this = OwnedObject(other); }
  btCollisionObject* get() const { return object_.get(); }
  btCollisionObject* operator->() const { return object_.get(); }
  explicit operator bool() const { return object_ != nullptr; }

 private:
  std::unique_ptr<btCollisionObject> object_;
};

struct alignas(64) Object {
  // What a substep asks of every object, moving or not, in one line of the cache.
  Kind kind;
  Mobility mobility;
  bool asleep = false;      ///< lies still: neither moved nor looked at until something disturbs it
  bool elastic = false;     ///< its owner answers the impulses of the present solve
  bool fresh = true;        ///< its shape has not yet been seen by detect()
  OwnedObject body = {};    ///< null once removed
  double inverse_mass = 0;  ///< 0 when held
  double impact_speed = std::numeric_limits<double>::infinity();  ///< from which it could be hurt [m/s]
  double still_time = 0;                                          ///< that it has hardly left its resting place [s]
  std::optional<bool> settled = {};  ///< whether it has come to rest, where its owner tells

  Shape shape;
  RigidState state = {};  ///< as its owner set it or, after advance(), with the solved velocities
  SurfaceProperties surface = {};
  Vec3 first_velocity = Vec3::Zero(), first_spin = Vec3::Zero();  ///< when the substep began
  Mat3 inverse_inertia = Mat3::Zero();                            ///< in its own frame
  ContactWorld::Correction correction = {};
  Vec3 pushed_out = Vec3::Zero();  ///< projectiles: the correction that the last advance() made [m]
  Pose resting_place = {};         ///< that it has hardly left

  bool is_free() const { return body && mobility == Mobility::free; }
  bool moves() const { return is_free() && !asleep; }
  bool is_sphere() const {
    return kind != Kind::ground && shape.parts.front()->getShapeType() == SPHERE_SHAPE_PROXYTYPE;
  }
  /// Whether it is awake and might fall asleep.
  bool may_sleep() const { return moves() || (settled && !asleep); }
  /// Of its convex parts; the ground counts as one.
  std::size_t part_count() const { return kind == Kind::ground ? 1 : shape.parts.size(); }
  /// Speed of its fastest point [m/s].
  double speed() const { return state.velocity.norm() + state.angular_velocity.norm() * shape.radius; }
  bool is_still() const { return state.velocity.isZero(0) && state.angular_velocity.isZero(0); }
  /// Whether impulses change its velocities in the present solve.
  bool responds() const { return elastic || moves(); }
};

/// A convex part of an object where the object lies there, or the ground.
PlacedShape placed(const Object& object, std::size_t part, const btTransform& place, double ground_height);
/// Whether the spheres round two objects come within `gap` [m] of each other while `a` is displaced from `start`.
bool may_touch(const Object& a, const Vec3& start, const Vec3& displacement, const Object& b, double gap,
               double ground_height);

/// Whether a point of an object of this radius has gone farther than `distance` [m] from where it was.
bool has_left(const Pose& then, const Pose& now, double distance, double radius);

/// What is left of an object or a shape that is gone, until Bullet lets go of it.
struct Retired {
  Shape shape;
  OwnedObject body;
};

/// Overlap that a pair is allowed because a crack left it behind. Ordered by the pair.
struct Allowance {
  ProxyId a, b;
  double overlap;  ///< [m], > 0
};

/// A contact that the owner put in, and the mean force there in the last substep along the contact's axes [N].
struct NodeContact {
  ProxyId a, b;
  NodeId node_a, node_b;
  Vec3 force = Vec3::Zero();
  auto key() const { return std::tie(a, b, node_a, node_b); }
};

/// Where the impulse of a contact is kept until the next substep: in Bullet's point, or with the owner's contacts.
struct Memory {
  btManifoldPoint* point = nullptr;
  int node_contact = -1;  ///< index into ContactState::node_contacts
};

/// What a world keeps from one substep to the next beside what Bullet remembers of pairs: a value.
struct ContactState {
  Vec3 gravity = Vec3::Zero();
  double ground_height = 0;
  std::vector<Object> objects;  ///< by ProxyId
  std::vector<Allowance> allowances;
  std::vector<Contact> contacts;
  std::vector<NodeContact> node_contacts;       ///< that the owner put in
  std::vector<NodeContact> past_node_contacts;  ///< of the last substep, by key
  std::vector<ContactConstraint> solved;        ///< per contact: as solve() found it
  std::vector<Vec3> free_velocities;            ///< per contact: of a relative to b in solve(), without impulses [m/s]
};

/// Pairs of objects with near bounding boxes. Bullet's own goes through all pairs twice for each object that leaves;
/// here leaving objects are collected and their pairs deleted in one pass.
class PairCache final : public btHashedOverlappingPairCache {
 public:
  void removeOverlappingPairsContainingProxy(btBroadphaseProxy*, btDispatcher*) override {}
  void cleanProxyFromPairs(btBroadphaseProxy*, btDispatcher*) override {}
};

/// Bounding boxes without Bullet's fixed margins of centimetres.
class CollisionWorld final : public btCollisionWorld {
 public:
  CollisionWorld(btDispatcher* dispatcher, btDbvtBroadphase* broadphase, btCollisionConfiguration* configuration)
      : btCollisionWorld(dispatcher, broadphase, configuration), tree_(broadphase) {}
  void updateAabbs() override;

 private:
  btDbvtBroadphase* tree_;
};

}  // namespace griffith::contact

namespace griffith {

struct ContactWorld::Impl : contact::ContactState {
  /// `pairs`: how many there will be about; more of them cost more.
  explicit Impl(const Vec3& world_gravity, int pairs = 4096);
  Impl(const Impl& other);
  ~Impl();

  // Objects.
  ProxyId add(contact::Object object, const RigidMass& mass);
  void attach(ProxyId id, const RigidMass& mass);
  void enter(contact::Object& object);
  void enter_all(const Impl& other);
  void retire(contact::Object& object);
  void delete_retired();
  void place(contact::Object& object);

  // Detection.
  void detect();
  bool all_at_rest() const;
  void collect_manifolds();
  void forget_parted();
  void update_allowances();
  double allowance(ProxyId a, ProxyId b) const;
  void wake_disturbed();
  void list_contacts();
  void sort_by_height();
  void list_pair(std::span<btPersistentManifold* const> of_pair);
  void replace_contacts(const std::vector<bool>& taken_out, std::span<const Contact> put_in);
  Vec3 remembered_force(const contact::Memory& memory) const;
  void remember_force(const contact::Memory& memory, const Vec3& force);

  // Solving.
  void drop_contacts_of(const std::vector<bool>& dropped);
  std::vector<int> drop_near_misses(double dt, std::span<const double> approach);
  int solve(double dt, std::span<const ElasticObject> elastic);
  int solve_rigid_groups(std::vector<contact::SolverBody>& solver_bodies);
  std::vector<std::vector<int>> elastic_groups() const;
  std::vector<bool> are_in_elastic_groups(const std::vector<int>& groups) const;
  std::vector<contact::SolverBody> rigid_solver_bodies(double dt) const;
  std::vector<contact::ContactConstraint> constraints(double dt) const;
  double target_velocity(const Contact& contact, double dt) const;
  double rebound_speed(const Contact& contact, double dt) const;
  bool strikes(const Contact& contact, double dt) const;
  std::vector<std::pair<int, int>> touching_pairs() const;
  void advance(double dt);
  void remember_impulses(double dt);
  struct Momentum {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
  };
  std::vector<Momentum> impulse_sums() const;
  void read_back_impulses(double dt);
  void correct_positions(const std::vector<contact::ContactConstraint>& constraints, double dt);
  void limit_lift(double dt);

  // Rest.
  double quiet_speed(const contact::Object& object) const;
  double touching_speed(const contact::Object& a, const contact::Object& b, double dt) const;
  void resist_rolling();
  void resist_rolling(const Contact& contact, double limit);
  void quieten(double dt);
  void fall_asleep(double dt);
  void wake_up(ProxyId id);
  void wake_neighbours(ProxyId id);

  // Motion.
  void move_projectiles(double dt);
  void turn_free(contact::Object& object, double dt);
  double deepest_overlap(const contact::Object& object) const;
  struct TouchAhead {
    double fraction;  ///< of the substep
    const contact::Object* met;
    Vec3 normal;       ///< unit, towards the projectile
    std::size_t part;  ///< of what is met
  };
  /// A surface that a projectile has touched and is sliding or moving off.
  struct LeftSurface {
    const contact::Object* object;
    std::size_t part;
    Vec3 normal;  ///< in the object's frame
    /// Parts whose surfaces go on from one another are one.
    bool is(const contact::Object& other, std::size_t other_part, const Vec3& other_normal) const;
  };
  /// What a sweep leaves out: what it moves against by less than `slow` [m], and what does not stop it.
  struct SweepRule {
    double slow = 0;
    std::function<bool(ProxyId)> stops;  ///< all do where it is empty
  };
  Vec3 swept_end(const contact::Object& projectile, double dt, const SweepRule& rule) const;
  Vec3 velocity_after(const Vec3& velocity, const Vec3& displacement, double dt) const;
  double allowed_depth(const contact::Object& projectile, const contact::Object& other) const;
  std::vector<TouchAhead> touches_ahead(const contact::Object& projectile, const Vec3& center, const Vec3& velocity,
                                        double fraction, double dt, const SweepRule& rule) const;
  Vec3 velocity_at_touch(const contact::Object& projectile, Vec3 velocity, const TouchAhead& touch, const Vec3& center,
                         double dt) const;
  std::optional<ContactWorld::Encounter> expected_impact(std::size_t first, std::size_t second, double dt,
                                                         double minimum_speed, double tolerance) const;
  std::vector<ContactWorld::Encounter> expected_impacts(double dt, double minimum_speed, double tolerance,
                                                        const PairFilter& matters) const;

  std::vector<contact::Retired> retired;  ///< deleted with the next detection; they outlive what knows them
  btDefaultCollisionConfiguration configuration;
  contact::Dispatcher dispatcher;
  contact::AlgorithmFactory<contact::HullGroundAlgorithm> hull_ground, ground_hull;
  contact::AlgorithmFactory<contact::SphereSphereAlgorithm> sphere_sphere;
  contact::AlgorithmFactory<contact::SphereHullAlgorithm> sphere_hull;
  contact::AlgorithmFactory<contact::SphereGroundAlgorithm> sphere_ground, ground_sphere;
  contact::AlgorithmFactory<contact::HullHullAlgorithm> hull_hull;
  contact::PairCache pairs;
  btDbvtBroadphase broadphase;
  contact::CollisionWorld world;

  std::vector<btPersistentManifold*> manifolds;  ///< those with points, in an order that depends on ids alone
  std::vector<contact::Memory> memories;         ///< per contact, between detect() and advance()
};

}  // namespace griffith
