#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "sim/ids.h"
#include "sim/linear_algebra.h"

namespace griffith {

/// A rigid object of the contact world: an elastic body's stand-in, a projectile or the ground.
using ProxyId = Id<struct ProxyTag>;

/// One convex part of a body's shape: its corner points in the body's own frame (origin at the centre of mass) [m].
using ConvexPart = std::vector<Vec3>;

/// Mass, inertia and placement of a rigid object.
struct RigidState {
  Pose pose;                             ///< of the centre of mass frame
  Vec3 velocity = Vec3::Zero();          ///< of the centre of mass [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
};

struct RigidMass {
  double mass = 1;                  ///< [kg], > 0
  Mat3 inertia = Mat3::Identity();  ///< about the centre of mass, in the object's own frame [kg·m²]
};

struct SurfaceProperties {
  double friction = 0.6;     ///< Coulomb's; a pair uses the geometric mean
  double restitution = 0.1;  ///< a pair uses the smaller one
};

/// How an object takes part.
enum class Mobility {
  free,  ///< contacts move it
  held,  ///< contacts do not move it: a body with supports; its velocity still counts at the contact
};

/// A point where two objects touch, or soon will: gaps up to 2 % of the smaller object's radius are listed. Two convex
/// parts have at most four. `compliance` goes in between detect() and solve(), `impulse` comes out of solve().
struct Contact {
  ProxyId a, b;
  Vec3 position_on_a, position_on_b;  ///< world space [m]
  Vec3 normal;                        ///< unit, points from b to a
  double distance = 0;                ///< gap along the normal, negative when overlapping, allowed or not [m]
  double compliance = 0;              ///< elastic inverse mass of the touched surfaces along the normal [1/kg]
  Vec3 impulse = Vec3::Zero();        ///< on a at its point, in the substep just solved; b gets the opposite [N·s]
};

/// Finds and solves the contacts of everything: Bullet, in double precision. Gravity acts on every free object in
/// solve(); the velocities that the owner sets do not hold it yet.
///
/// A substep is: add, reshape() and remove(), set_state() of all elastic stand-ins, detect(), compliance into
/// contacts(), solve(dt), impulses out of contacts(). Purely rigid objects (projectiles) are moved by solve();
/// stand-ins are not: their owner places them with the next set_state(), after adding position_correction().
///
/// In a solve the impulses of a free object sum up to its change of momentum beyond gravity's, to rounding, linear and
/// angular (at the contacts' points). Approaches below 0.2 m/s do not bounce. A gap that closes within `dt` at a higher
/// speed is struck at once with the full approach speed; at a lower one, objects come to touch. Overlap is taken out by
/// a fifth a substep through position_correction(), which adds no velocity.
///
/// The same calls give the same bits. Results depend on the history of contacts (the solver starts from the last
/// impulses), so a state is restored by repeating the calls that led to it. States must be finite: asserted.
class ContactWorld {
 public:
  explicit ContactWorld(const Vec3& gravity);
  ~ContactWorld();
  ContactWorld(ContactWorld&&) noexcept;
  ContactWorld& operator=(ContactWorld&&) noexcept;

  /// A horizontal plane that fills everything below `height`. At most one.
  ProxyId add_ground(double height, const SurfaceProperties& surface);
  /// A rigid sphere that the contact world itself moves. Radius [m] > 0, mass [kg] > 0.
  ProxyId add_sphere(double radius, double mass, const RigidState& state, const SurfaceProperties& surface);
  /// The stand-in of an elastic body: at least one part. When held, its mass is not used.
  ProxyId add_stand_in(std::span<const ConvexPart> parts, const RigidMass& mass, Mobility mobility,
                       const RigidState& state, const SurfaceProperties& surface);
  /// A new shape and mass for a stand-in whose body lost a piece. Pairs that overlap when first seen after
  /// add_stand_in() or reshape() are fresh cracks: they are neither pushed apart nor do they bounce. That much overlap
  /// stays allowed until it has shrunk, save with the ground.
  void reshape(ProxyId stand_in, std::span<const ConvexPart> parts, const RigidMass& mass, Mobility mobility,
               const RigidState& state);
  /// The id is never given out again. Contacts listed so far are void, here and in reshape().
  void remove(ProxyId object);

  void set_state(ProxyId object, const RigidState& state);
  void set_surface(ProxyId object, const SurfaceProperties& surface);
  /// As set last; after solve() with the solved velocities and, for a sphere, in its new place.
  RigidState state(ProxyId object) const;

  /// Contacts at the present poses. Invalidates spans handed out before.
  void detect();
  std::span<Contact> contacts();
  std::span<const Contact> contacts() const;
  /// Solves the velocities over `dt` [s], writes the impulses, moves the purely rigid objects (fast ones swept, so that
  /// none passes through a thin body). `dt` > 0.
  void solve(double dt);

  /// The displacement that removes what is left of an overlap, as a rigid motion (translation [m], rotation vector
  /// [rad] about the centre of mass), from the last solve(). Zero for most.
  struct Correction {
    Vec3 translation = Vec3::Zero(), rotation = Vec3::Zero();
  };
  Correction position_correction(ProxyId stand_in) const;

  /// Whether an object can break; stand-ins can unless told otherwise, spheres cannot.
  void set_brittle(ProxyId object, bool brittle);
  /// Whether, moving freely for `dt`, any pair with a brittle object would meet with an approach speed above `minimum_speed` [m/s]; the
  /// reason to take substeps. On the safe side: an object that turns counts as if all of it moved with its fastest
  /// point. Pairs that touch already count if they approach that fast.
  bool impact_expected(double dt, double minimum_speed) const;

  /// Deepest overlap of the last detect(), beyond what fresh cracks are allowed [m], >= 0.
  double max_penetration() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Splits a body into few, nearly convex parts for collision. `points` and `tets` are the body's own; every tet goes to
/// one part; a part is accepted when its tets fill at least `fill` of its convex hull (0..1], when it is a single tet
/// or holds less than 1/32 of the body; else it is halved across its longest axis. A part has at most 42 corners,
/// extreme ones of its hull. Low `fill` makes fewer parts: contact time grows with their number, so give small pieces
/// 0.5.
std::vector<ConvexPart> convex_parts(std::span<const Vec3> points, std::span<const std::array<int, 4>> tets,
                                     double fill = 0.9);

}  // namespace griffith
