#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/linear_algebra.h"

namespace griffith {

/// Rigid object of the contact world: an elastic body's proxy, a projectile or the ground.
using ProxyId = Id<struct ProxyTag>;

/// Convex part of a body's shape: its corners in the body's own frame (origin at the center of mass) [m].
using ConvexPart = std::vector<Vec3>;

/// Placement and motion of a rigid object.
struct RigidState {
  Pose pose;                             ///< pose of the center-of-mass frame
  Vec3 velocity = Vec3::Zero();          ///< velocity of the center of mass [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]

  bool is_still() const { return velocity.isZero(0) && angular_velocity.isZero(0); }
};

struct RigidMass {
  double mass = 1;                  ///< [kg], > 0
  Mat3 inertia = Mat3::Identity();  ///< inertia about the center of mass, in the object's own frame [kg·m²]
};

struct SurfaceProperties {
  double friction = 0.6;     ///< Coulomb's; a pair uses the geometric mean
  double restitution = 0.1;  ///< a pair uses the smaller one
  /// Torque that resists rolling, over the normal force times the distance from the contact to the center: objects that
  /// roll on level ground slow down by about this fraction of g. A pair uses the larger value.
  double rolling_resistance = 0.02;
};

/// Mobility of an object.
enum class Mobility {
  free,       ///< contacts move it
  kinematic,  ///< contacts do not move it: a body with supports; its velocity still counts at the contact. Where it
              ///< moves it touches what else is kinematic, which the elastic answers of the two may stop
};

/// Time at which a contact has its position. As wide as a number: contacts are hashed by their bytes.
enum class PositionTime : std::int64_t {
  start,  ///< start of the substep
  mean,   ///< mean over the substep, of a point that turns far
};

/// Point at which two objects touch or soon will: gaps up to 2 % of the smaller object's radius are listed. Two convex
/// parts have at most four. Between detect() and solve() the owner may correct the distance and add contacts.
struct Contact {
  ProxyId a, b;
  Vec3 position;  ///< where the impulse acts on both: half-way between their surfaces, or as the owner has put it [m]
  Vec3 normal;    ///< unit, points from b to a
  double distance = 0;          ///< gap along the normal, negative when overlapping, allowed or not [m]
  double approach = 0;          ///< speed at which the gap would close without impulses, from solve() [m/s]
  Vec3 impulse = Vec3::Zero();  ///< on a, in the substep just solved; b gets the opposite [N·s]
  NodeId node_a = {},
         node_b = {};  ///< nodes of the owner that touch here; at least one in contacts set by the owner, else none
  PositionTime position_at = PositionTime::start;
  Vec3 couple = Vec3::Zero();  ///< angular impulse on both since each carried the position elsewhere [N·m·s]
};

/// Elastic object and the velocities of its points at contacts, without contact forces.
struct ElasticObject {
  ProxyId object;
  std::vector<int> contacts;         ///< indices into contacts(), ascending: all of the object's
  Eigen::Matrix3Xd free_velocities;  ///< one column a contact [m/s]
  bool rebounds_by_law = false;      ///< its waves end within the substep: the coefficient of restitution includes them
};

/// Held object that its supports let rotate, treated as rigid.
struct HingedObject {
  ProxyId object;
  double mass;            ///< [kg]
  Vec3 place;             ///< place that hardly moves [m]
  Mat3 inverse_inertia;   ///< about the axes that are free, world frame [1/(kg·m²)]
  Vec3 first_spin, spin;  ///< spin at the start of the substep and, without contact forces, at its end [rad/s]
};

/// Finds and solves the contacts of everything.
///
/// A substep is: add, reshape() and remove(), set_state() of all proxies, detect(), set_velocity(), solve(), advance(),
/// impulses out of contacts(). Spheres and convex projectiles are moved by advance(), and gravity acts on them there;
/// proxies are not: their owner sets velocities that hold what external forces give them in the substep, after
/// detect(), so that rigid ones get it bit by bit; and places them with the next set_state(), after adding
/// position_correction().
///
/// The impulses of a free rigid object sum up to its change of momentum, to rounding, linear and angular (at the
/// contacts' points). What touches an elastic object whose waves outlast the substep does not bounce, since that
/// rebounds by itself, nor does what comes no faster than by a fall within two substeps or through a small share of the
/// objects' size. A gap that closes within `dt` at a higher speed is struck at once with the full approach speed; at a
/// lower one, objects come to touch. Overlap is taken out by a share a substep through position_correction(), which
/// adds no velocity and lifts no more than contacts have taken from the motion: what is put to rest in others stays
/// there.
///
/// The same calls give the same bits. Results depend on the history of contacts (the solver starts from the last
/// impulses), which a copy has too. States must be finite: asserted.
class ContactWorld {
 public:
  explicit ContactWorld(const Vec3& gravity);
  ~ContactWorld();
  /// Copies the world between substeps: the same calls on both give the same bits.
  ContactWorld(const ContactWorld&);
  ContactWorld& operator=(const ContactWorld&);
  ContactWorld(ContactWorld&&) noexcept;
  ContactWorld& operator=(ContactWorld&&) noexcept;

  /// Adds a horizontal plane that fills everything below `height`. At most one.
  ProxyId add_ground(double height, const SurfaceProperties& surface);
  /// Adds a rigid sphere that the contact world itself moves. Radius [m] > 0, mass [kg] > 0.
  ProxyId add_sphere(double radius, double mass, const RigidState& state, const SurfaceProperties& surface);
  /// Adds a convex body moved by the contact world itself: its corners in its own frame (origin at the center of mass),
  /// not all in a plane.
  ProxyId add_convex(const ConvexPart& corners, const RigidMass& mass, const RigidState& state,
                     const SurfaceProperties& surface);
  /// Adds the proxy of an elastic body: at least one part. The mass of a held one is not used.
  ProxyId add_proxy(std::span<const ConvexPart> parts, const RigidMass& mass, Mobility mobility,
                    const RigidState& state, const SurfaceProperties& surface);
  /// Input of add_proxy().
  struct Proxy {
    std::span<const ConvexPart> parts;
    RigidMass mass;
    Mobility mobility;
    RigidState state;
    SurfaceProperties surface;
  };
  /// Adds many in their order: as one by one, but their shapes are made in parallel.
  std::vector<ProxyId> add_proxies(std::span<const Proxy> proxies);
  /// Sets a new shape and mass of a proxy whose body lost a piece. Two proxies that overlap when first seen after
  /// add_proxy() or reshape() of both are sides of a fresh crack: they are neither pushed apart nor do they bounce.
  /// That much overlap stays allowed until it has shrunk.
  void reshape(ProxyId proxy, std::span<const ConvexPart> parts, const RigidMass& mass, Mobility mobility,
               const RigidState& state);
  /// Sets the deformed shape of a proxy and its mass. New overlaps count as such.
  void deform(ProxyId proxy, std::span<const ConvexPart> parts, const RigidMass& mass, const RigidState& state);
  /// Removes an object. Its id is never used again. Invalidates the listed contacts, as do reshape() and deform().
  void remove(ProxyId object);

  void set_state(ProxyId object, const RigidState& state);
  void set_surface(ProxyId object, const SurfaceProperties& surface);
  void set_velocity(ProxyId object, const Vec3& velocity, const Vec3& angular_velocity);
  /// Returns the state set last; after advance() with the solved velocities and, for a projectile, its new place.
  RigidState state(ProxyId object) const;
  bool is_ground(ProxyId object) const;
  /// Returns the ground, if there is one.
  std::optional<ProxyId> ground() const;
  /// True if impulses move it as a rigid object: it is neither held nor asleep.
  bool moves(ProxyId object) const;
  /// Returns the overlap of two objects that a fresh crack left and that remains allowed [m], usually 0.
  double allowed_overlap(ProxyId a, ProxyId b) const;

  /// Finds contacts at the present poses; with a `dt` [s], also those whose gaps would close within that time at the
  /// present velocities. Invalidates earlier spans.
  void detect(double dt = 0);
  std::span<Contact> contacts();
  std::span<const Contact> contacts() const;
  /// Takes out the contacts that are marked and puts in others, between nodes of an object and the other's surface. The
  /// same nodes start from the impulses of the last substep. To be called between detect() and solve(), if at all.
  void replace_contacts(const std::vector<bool>& taken_out, std::span<const Contact> put_in);
  /// Removes near misses, most contacts of a heap, from contacts(): gaps that stay open for `dt` [s] > 0 even if both
  /// sides approach a quarter faster than `approach` (per contact [m/s], negative if they separate), or at half the
  /// speed of an impact on either of them, and that carried no impulse in the last substep. Returns the new index of
  /// each contact, or -1. May be called between detect() and solve().
  std::vector<int> drop_near_misses(double dt, std::span<const double> approach);
  /// Removes the contacts of objects from contacts(), per ProxyId; objects beyond the end keep theirs. May be called
  /// right after detect().
  void drop_contacts_of(const std::vector<bool>& objects);
  /// Writes the impulses of a substep of `dt` [s] > 0 into contacts(), except those of groups of objects that touch
  /// and of which one is elastic: their owner solves them by law() and hands in set_impulse(). The owner turns what is
  /// hinged by the impulses. Returns how many times a contact was solved, for those who count work.
  int solve(double dt, std::span<const ElasticObject> elastic = {}, std::span<const HingedObject> hinged = {});
  /// Leaves rigid groups at rest to the owner, too, in which the sweeps of the last solve() did not converge: few
  /// bodies, such as a tower of bars, of which each is carried by many others. `dt` as there.
  void leave_unsettled_groups(double dt);
  /// Returns the contacts of the groups that the last solve() left to the owner, each ascending.
  std::vector<std::vector<int>> elastic_groups() const;
  /// Law of a contact in the last solve().
  struct Law {
    Mat3 axes;                         ///< columns: the normal and two tangents
    double target_velocity = 0;        ///< least velocity of parting along the normal [m/s]
    double friction = 0;               ///< Coulomb's coefficient
    Vec3 free_velocity, arm_a, arm_b;  ///< relative, without impulses [m/s]; from the centers of mass or the hinges [m]
    Vec3 guess;                        ///< impulse along the axes, from the last substep [N·s]
  };
  Law law(int contact) const;
  /// Sets the impulse on a [N·s], world frame.
  void set_impulse(int contact, const Vec3& impulse) {
    contacts()[contact].impulse = impulse;
    contacts()[contact].couple.setZero();
  }
  /// Returns the mass and inertia, in the world frame, of an object that impulses move rigidly; empty for others. Those
  /// of a hinged one are about its place, and let it hardly do anything but turn about its axes.
  std::optional<RigidMass> rigid_mass(ProxyId object) const;
  /// Sets the velocities of rigid objects by the impulses in contacts(), and moves the projectiles (swept, so that none
  /// passes through a thin body). Elastic objects of the last solve() keep the velocity that their owner has set.
  void advance(double dt);

  /// Returns the position of a proxy's center of mass after `dt` [s] at its velocity [m]. It stops before it would pass
  /// through another object, as seen after advance(). Approaches of less than `slow` [m] are left to the next
  /// detection, like all objects for which `stops` returns false.
  Vec3 swept_center(ProxyId proxy, double dt, double slow, const std::function<bool(ProxyId)>& stops) const;
  /// Returns the velocity of an object that would have moved by `velocity` [m/s] for `dt` [s] and was displaced by
  /// `displacement` [m]: one that stopped early has not gained the speed of its whole fall.
  Vec3 velocity_after(const Vec3& velocity, const Vec3& displacement, double dt) const;

  /// Displacement of a proxy besides its velocities times `dt`, as a rigid motion (translation [m], rotation vector
  /// [rad] about the center of mass), from the last advance(): its motion among its contacts, and out of remaining
  /// overlaps. Zero without contacts.
  struct Correction {
    Vec3 translation = Vec3::Zero(), rotation = Vec3::Zero();
  };
  Correction position_correction(ProxyId proxy) const;
  /// Returns the displacement of a projectile out of overlaps in the last advance() [m]; its state includes it.
  Vec3 pushed_out(ProxyId projectile) const;

  /// Time at rest after which an object falls asleep [s].
  static constexpr double kTimeToSleep = 0.5;
  /// Puts objects to sleep that, like all objects they touch, have hardly moved for that long. To be called once per
  /// step of `dt` [s]. Sleepers stand still and cost nothing until a moving object touches one, or a neighbor is
  /// reshaped or removed.
  void fall_asleep(double dt);
  /// Sets whether an elastic object has come to rest, for the duration that fall_asleep() requires; empty if it is
  /// rigid, so that its motion decides.
  void set_settled(ProxyId object, std::optional<bool> settled);
  bool asleep(ProxyId object) const;
  /// Wakes an object.
  void wake_up(ProxyId object);

  /// Sets the approach speed from which an impact could cause damage to an object [m/s]; infinite by default, as for
  /// spheres and the ground.
  void set_impact_speed(ProxyId object, double speed);
  /// Two objects that may meet.
  struct Encounter {
    ProxyId a, b;
    double approach = 0;  ///< the fastest that they come together [m/s]
    double time = 0;      ///< free flight that is left to them: up to `tolerance` before they touch [s]
    double strike = 0;    ///< the same until the first damaging impact of a corner, not before `time` [s]
  };
  /// Pairs that, in free motion for `dt`, would meet at an approach speed above `minimum_speed` [m/s] that could cause
  /// damage to one of them, each once. Conservative: includes all corners that may get that far. Pairs that touch
  /// already, or may within `tolerance` [s], count as meeting now. Pairs for which `matters` returns false are omitted.
  using PairFilter = std::function<bool(ProxyId, ProxyId)>;
  std::vector<Encounter> expected_impacts(double dt, double minimum_speed, double tolerance,
                                          const PairFilter& matters = {}) const;

  /// Two objects that come together within a substep at points that contacts() lacks.
  struct Meeting {
    std::array<ProxyId, 2> objects;    ///< the ground last
    std::array<RigidState, 2> starts;  ///< poses at its start, with the velocities by the impulses in contacts()
    std::vector<Contact> points;       ///< where they overlap at its end
    std::optional<Encounter> impact;   ///< if they meet fast enough to cause damage
    bool is_deep = false;              ///< true if they would overlap by more than half of the smaller thickness
  };
  /// Returns the meetings within a substep of `dt` [s] > 0, by the impulses in contacts(), that detection left out: of
  /// approaches that could cause damage, and of objects that impulses divert, such as the far end of a rod that is
  /// struck. Their points may be put in by replace_contacts(), and everything solved again. Of groups that solve() left
  /// to the owner, only deep overlaps count. Objects marked in `left_out`, per ProxyId, are omitted; those beyond its
  /// end are not. Other arguments as of expected_impacts().
  std::vector<Meeting> unlisted_meetings(double dt, double minimum_speed, double tolerance,
                                         const std::vector<bool>& left_out) const;

  /// Returns a hash of the state between substeps: impulses at contacts, allowed overlaps, sleepers.
  std::uint64_t memory_hash() const;

  /// Returns the size of data that a copy does not share, approximately [bytes].
  std::size_t memory() const;

  /// Returns the deepest overlap in contacts(), beyond that allowed after cracks [m], >= 0.
  double max_penetration() const;
  /// Returns the overlap with larger objects that contacts of deformable ones leave, so that what rests touches [m].
  double overlap_at_rest(ProxyId object) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Largest number of corners of a convex part of what is jagged: more cost time at every contact without a visible
/// effect.
inline constexpr int kMaxPartCorners = 42;

/// Divides a body into few, nearly convex parts for collision. `points`, which are now where they are and at rest at
/// `rest_points`, and `tets` are the body's own. Every tet belongs to one part, the convex hull of its at most
/// `max_corners` (>= 4) most extreme corners. The division is that at `rest_points`, so that it does not change as the
/// body deforms; those of one that has bent may be its present points. Up to 64 tets are merged into parts that leave
/// the surface by at most 0.5 % of the body's extent (convex_clusters). A part of a larger body is accepted if its tets
/// fill at least the fraction `fill` (0..1] of its hull, or if it has less than 1/32 of the body's volume; else it is
/// halved across its longest axis. A low `fill` makes fewer parts.
std::vector<ConvexPart> convex_parts(std::span<const Vec3> points, std::span<const Vec3> rest_points,
                                     std::span<const std::array<int, 4>> tets, double fill = 0.97,
                                     int max_corners = kMaxPartCorners);

}  // namespace griffith
