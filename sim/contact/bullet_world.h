#pragma once

// Private to sim/contact: what ContactWorld keeps.

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "sim/contact/bullet_ground_contact.h"
#include "sim/contact/bullet_hull_contact.h"
#include "sim/contact/bullet_shapes.h"
#include "sim/contact/bullet_sweep.h"
#include "sim/contact/contact_world.h"

namespace griffith::contact {

/// A slower approach does not bounce, so that resting contacts are quiet [m/s].
inline constexpr double kQuietSpeed = 0.2;

enum class Kind { ground, sphere, stand_in };

struct Object {
  Kind kind;
  Mobility mobility;
  Shape shape;
  RigidState state = {};              ///< as its owner set it or, after solve(), with the solved velocities
  Quat principal = Quat::Identity();  ///< principal axes of inertia (Bullet's body frame) to the object's frame
  SurfaceProperties surface = {};
  ContactWorld::Correction correction = {};
  bool brittle = kind == Kind::stand_in;  ///< its impacts are worth substeps
  bool fresh = true;                       ///< its shape has not yet been seen by detect()
  std::unique_ptr<btRigidBody> body = {};  ///< null once removed

  bool moves() const { return body && mobility == Mobility::free; }
};

/// What is left of an object or a shape that is gone, until Bullet lets go of it.
struct Retired {
  Shape shape;
  std::unique_ptr<btRigidBody> body;
};

/// Overlap that a pair is allowed because a crack left it behind. Ordered by the pair.
struct Allowance {
  ProxyId a, b;
  double overlap;  ///< [m], > 0
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

struct ContactWorld::Impl {
  explicit Impl(const Vec3& world_gravity);
  ~Impl();

  // Objects.
  ProxyId add(contact::Object object, const RigidMass& mass);
  void attach(ProxyId id, const RigidMass& mass);
  void retire(contact::Object& object);
  void delete_retired();
  void place(contact::Object& object);

  // Detection.
  void detect();
  void collect_manifolds();
  void update_allowances();
  double allowance(ProxyId a, ProxyId b) const;
  void list_contacts();

  // Solving.
  void solve(double dt);
  void prepare_contact(std::size_t contact, double dt);
  Vec3 velocity_at(const contact::Object& object, const Vec3& point, double dt) const;
  void read_impulses();
  void read_motion(contact::Object& object);

  // Motion.
  void move_spheres(double dt);
  struct NextTouch {
    double share;                ///< of the substep, 1 for nothing
    const contact::Object* met;  ///< null for nothing
    Vec3 normal;                 ///< unit, towards the sphere
    Vec3 local_center;           ///< of the sphere, in the frame of what it met [m]
  };
  Vec3 swept_end(const contact::Object& sphere, double dt) const;
  NextTouch next_touch(const contact::Object& sphere, const Vec3& center, const Vec3& velocity, double share,
                       double dt) const;
  Vec3 carried_end(const contact::Object& sphere, const NextTouch& struck, const Vec3& center, double dt) const;
  bool would_strike(std::size_t a, std::size_t b, double dt, double minimum_speed) const;
  bool impact_expected(double dt, double minimum_speed) const;

  Vec3 gravity;
  double ground_height = 0;
  double last_dt = 0;                    ///< of the last solve() [s]
  std::vector<contact::Object> objects;  ///< by ProxyId

  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  contact::HullGroundAlgorithm::Factory hull_ground, ground_hull;
  contact::HullHullAlgorithm::Factory hull_hull;
  contact::PairCache pairs;
  btDbvtBroadphase broadphase;
  contact::CollisionWorld world;
  btSequentialImpulseConstraintSolver solver;
  btContactSolverInfo settings;
  std::vector<contact::Retired> retired;  ///< deleted with the next detection

  std::vector<btPersistentManifold*> manifolds;  ///< those with points, in an order that depends on ids alone
  std::vector<contact::Allowance> allowances;
  std::vector<Contact> contacts;
  std::vector<btManifoldPoint*> points;  ///< per contact
  double max_penetration = 0;
};

}  // namespace griffith
