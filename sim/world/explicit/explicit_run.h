#pragma once

#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/elasticity/placement.h"
#include "sim/explicit/explicit_bodies.h"
#include "sim/explicit/microstep_contacts.h"
#include "sim/world/conditions/loads.h"
#include "sim/world/explicit/restored_bonds.h"
#include "sim/world/fracture/fracture_phase.h"

namespace griffith {

/// Returns the sides of the crack between face `first_face` of a tet and its previous neighbor `second`, corner by
/// corner.
explicit_dynamics::CrackSides crack_sides(const TetMesh& mesh, TetId first, int first_face, TetId second,
                                          int first_slot, int second_slot);

/// Returns the faces that earlier cracks opened, paired by their places at rest. `tets`: per slot, invalid in unused
/// ones. If bodies are `apart`, only those of one body are paired.
std::vector<explicit_dynamics::CrackSides> crack_sides(const WorldState& world, std::span<const TetId> tets,
                                                       bool apart);

/// Fraction of the stable microstep: closer to it, the energy of the highest frequencies oscillates widely.
inline constexpr double kCourant = 0.5;
/// Interval of impulses on a node below which they count as lasting pressure, in the time in which a wave crosses an
/// element.
inline constexpr double kPressing = 4;

/// Acceleration of a body as a whole.
struct RigidAcceleration {
  Vec3 place = Vec3::Zero(), linear = Vec3::Zero();  ///< [m], [m/s²]
  Mat3 by_arm = Mat3::Zero();                        ///< acceleration per distance from the place [1/s²]
  Vec3 at(const Vec3& position) const { return linear + by_arm * (position - place); }
};

/// Microsteps of bodies in explicit dynamics over a part of a step, from and back to the world.
class ExplicitRun {
 public:
  /// Prepares the bodies of a group. `obstacles`: the rigid objects that they may hit, in their present state. `ahead`:
  /// time by which all other objects have moved on already [s].
  ExplicitRun(WorldState& world, std::vector<explicit_dynamics::Obstacle> obstacles, double ahead, int group = 0);

  /// Makes microsteps for `duration` [s], with contacts and cracks. Returns false, with an invalid state, if they take
  /// more than `max_work` [µs of a typical core].
  bool run(double duration, double max_work);

  /// Makes microsteps until no impact or crack has caused new waves for `quiet` [s], for at most `duration` [s] in
  /// total. Returns their duration [s].
  double run_until_quiet(double quiet, double duration);

  /// Writes positions, velocities, reactions and pieces back to the world, after `duration` [s] in total.
  void finish(double duration) { finish(world_, opened_, duration); }

  std::span<const explicit_dynamics::Obstacle> obstacles() { return contacts_->obstacles(); }

 private:
  /// Accelerations of a node by external forces [m/s²]: the real ones, and those that act on its body, which may be
  /// scaled.
  struct External {
    Vec3 whole = Vec3::Zero(), acting = Vec3::Zero();
  };
  /// Initial position of a node, or offset of an edge, and the external accelerations that always act on it.
  struct Start {
    Vec3 position;  ///< [m]
    External steady;
  };
  /// Effect of the full load on a node or an edge if the load has changes ahead, and the position of the node, or the
  /// offset of the edge, at the last change of the acting part [m].
  struct Loaded {
    int index = 0;
    External full;
    Vec3 position;
  };
  /// Load with further changes.
  struct ChangingLoad {
    Load load;
    double factor = 0;  ///< fraction that acts now
    std::vector<Loaded> nodes, edges;
  };
  struct Overload {
    double utilization = 0;
    NodeId node;
  };

  void build(std::vector<explicit_dynamics::Obstacle> obstacles);
  void add_body(const Body& body, const ExternalForces& external);
  void add_nodes(const std::vector<NodeId>& nodes, const Placement& placement, double f,
                 const std::vector<Vec3>& external, const RigidAcceleration& as_a_whole);
  RigidAcceleration common_acceleration(const Body& body, const std::vector<NodeId>& nodes,
                                        const std::vector<Vec3>& forces, bool rotates) const;
  ExternalForces steady_forces() const;
  void add_changing_loads();
  void add_changing_load(const Body& body, const ExternalForces& forces, ChangingLoad& changing) const;
  static void copy_loaded(int index, int copy, std::vector<Loaded>& loaded);
  void apply_loads(const TimeSpan& span, double drifted);
  void account_loads(ChangingLoad& changing, double next_factor, double drifted);
  void account_load(const ChangingLoad& changing, double mass, const Vec3& position, const Vec3& further,
                    Loaded& loaded);
  bool a_support_stops() const;
  void move_supports();
  void add_edges(const Body& body, const ExternalForces& external);
  void add_elements(const Body& body, const Mat3& turn);
  std::vector<explicit_dynamics::SurfaceSide> surface_of_bodies() const;
  void record_impacts();
  void record_contact(const explicit_dynamics::MicrostepContacts::RecordedImpact& impact);
  void check_overload();
  void update_overload(NodeId node, double last_check);
  void open(const Overload& overload);
  void wait_beside_crack(const std::vector<TetId>& star, const std::vector<NodeId>& front, double transit);
  std::vector<NodeId> front_among(const std::vector<TetId>& tets) const;
  void follow(const Overload& overload, std::span<const NodeCopy> copies, const std::vector<TetId>& star,
              const std::vector<std::array<TetId, 4>>& neighbors);
  void follow_edges(std::span<const EdgeCopy> copies);
  void constrain_again();
  void bond_copies(NodeId original, std::span<const NodeId> made, double utilization);
  void finish(WorldState& world, Opened opened, double duration) const;
  void show_moment();
  WorldState moment() const;
  void carry_others(WorldState& moment) const;
  void store_bonds(WorldState& world) const;
  void update_threshold(int index);
  bool can_be_overloaded(int index) const;
  double energy_release_bound_at(int index) const;
  void update_linear_states(std::span<const TetId> tets, const Body& body, std::vector<ElementState>& states);
  void update_quadratic_states(std::span<const TetId> tets, const Body& body);
  void take_stale(TetId tet);
  void update_states_at_flagged();
  void let_sliver_yield(WorldState& world, TetId tet, const Mat3& strain) const;
  Mat3 elastic_strain(TetId tet, const Mat3& strain) const;
  void write_back(WorldState& world) const;
  double stable_microstep(double end) const;
  double check_interval() const;
  void begin_account();
  void account_change_of_microstep(double previous_dt);
  void end_account();
  double work() const;
  double work_of_elements() const;
  void account_work(double shortening);
  double relieved_energy(bool at_start) const;
  void add_external_works(EnergyAccount& spent) const;
  int local(NodeId node) const { return local_of_node_[node]; }
  const Body& body_of(NodeId node) const;
  bool is_followed(const Body& body) const { return body.explicit_state && body.explicit_state->group == group_; }
  bool is_quiet() const;
  double transit_time(NodeId node) const;

  WorldState& world_;
  int group_ = 0;
  double start_ = 0, others_at_ = 0;  ///< time of the first microstep, and of all other objects [s]
  double quiet_ = std::numeric_limits<double>::infinity();  ///< after so long without new waves it ends [s]
  explicit_dynamics::ExplicitBodies explicit_bodies_;
  std::optional<explicit_dynamics::MicrostepContacts> contacts_;
  std::vector<BodyId> bodies_;                           ///< per explicit body
  std::vector<Mat3> turns_;                              ///< per explicit body, from its place at rest
  std::vector<explicit_dynamics::SurfaceLaw> surfaces_;  ///< per explicit body
  std::vector<NodeId> nodes_;                            ///< per explicit node
  std::vector<TetId> tets_;                              ///< per slot; invalid in unused ones
  std::vector<int> local_of_node_, slot_of_tet_;         ///< -1 outside explicit dynamics
  std::vector<EdgeId> edges_;                            ///< per explicit edge
  std::vector<int> local_of_edge_;                       ///< -1 outside explicit dynamics
  CracksByFace cracks_by_face_;
  std::vector<long> seen_;  ///< per slot: microstep at which its state was made
  std::vector<Overload> overloaded_;
  std::vector<TetId> stale_;
  std::vector<int> flagged_;
  Opened opened_;
  std::vector<Start> starts_, edge_starts_;  ///< per explicit node and edge
  std::vector<ChangingLoad> changing_loads_;
  EnergyAccount work_of_changing_loads_;  ///< work in this build
  std::map<std::pair<NodeId, int>, std::size_t>
      contact_views_;    ///< index among the world's contact views, per node and obstacle
  EnergyAccount first_;  ///< initial values of the account of this build
  double dt_ = 0, time_ = 0, min_speed_ = 0;
  double work_ = 0;  ///< beside elements and nodes [µs of a typical core]
  long microsteps_ = 0;
  bool rebuild_ = false;  ///< the mesh has changed
};

}  // namespace griffith
