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
#include "sim/world/phases/cracking.h"

namespace griffith {

/// Face `first_face` of a tet that lost its neighbor `second`, corner by corner beside what is there now.
explicit_dynamics::CrackSides crack_sides(const TetMesh& mesh, TetId first, int first_face, TetId second,
                                          int first_slot, int second_slot);

/// Faces that cracks opened before, paired by their places at rest. `tets`: per slot, invalid in unused ones. Where
/// bodies are `apart`, only those of one body are paired.
std::vector<explicit_dynamics::CrackSides> crack_sides(const WorldState& world, std::span<const TetId> tets,
                                                       bool apart);

/// Share of the stable microstep: nearer to it, the energy of the highest frequencies swings widely.
inline constexpr double kCourant = 0.5;
/// A node that is pushed again sooner is still pressed on, in the time that a wave takes to cross an element.
inline constexpr double kPressing = 4;

/// The largest principal stress of the elements at a node up to which the node cannot be overloaded, under the full
/// stiffness [Pa]; infinite where nothing could part.
float screening_stress(const WorldState& world, NodeId node);

/// The microsteps of bodies in explicit dynamics over a part of a step, from and back to the world.
class ExplicitRun {
 public:
  /// `obstacles`: the rigid things that the bodies of this group may run into, as they are now.
  ExplicitRun(WorldState& world, std::vector<explicit_dynamics::Obstacle> obstacles, int group = 0);

  /// Goes on for `duration` [s]: moves, pushes and cracks. False where it takes more than `max_work` [µs of a usual
  /// core]: nothing can be made of it then.
  bool run(double duration, double max_work);

  /// Goes on until no impact and no crack has made new waves for `quiet` [s], for at most `duration` [s] in all.
  /// Returns how long it took [s].
  double run_until_quiet(double quiet, double duration);

  /// Hands positions, velocities, reactions and pieces back to the world, after `duration` [s] in all.
  void finish(double duration);

  std::span<const explicit_dynamics::Obstacle> obstacles() { return contacts_->obstacles(); }

 private:
  /// Accelerations of a node by external forces [m/s²]: as they are, and as they act on its body, which may be scaled.
  struct External {
    Vec3 whole = Vec3::Zero(), acting = Vec3::Zero();
  };
  /// Where a node was when it was added, and what always acts on it.
  struct Start {
    Vec3 position;  ///< [m]
    External steady;
  };
  /// What a load that has changes ahead does to a node when all of it acts, and where the node was when the part that
  /// acts changed last [m].
  struct Loaded {
    int node = 0;
    External full;
    Vec3 position;
  };
  /// A load that has changes ahead.
  struct ChangingLoad {
    Load load;
    double factor = 0;  ///< that acts now
    std::vector<Loaded> nodes;
  };
  struct Overload {
    double utilization = 0;
    NodeId node;
  };

  void build(std::vector<explicit_dynamics::Obstacle> obstacles);
  void add_body(const Body& body, const std::vector<Vec3>& external);
  void add_nodes(const std::vector<NodeId>& nodes, const Placement& placement, double f,
                 const std::vector<Vec3>& external);
  Vec3 common_acceleration(const std::vector<NodeId>& nodes, const std::vector<Vec3>& forces) const;
  std::vector<Vec3> steady_forces() const;
  void add_changing_loads();
  void copy_loads(int node, int copy);
  void apply_loads(const TimeSpan& span, double drifted);
  void account_loads(ChangingLoad& changing, double next_factor, double drifted);
  bool a_support_stops() const;
  void move_supports();
  void add_edges(const Body& body);
  void add_elements(const Body& body, const Mat3& turn);
  std::vector<explicit_dynamics::SurfaceSide> surface_of_bodies() const;
  void record_impacts();
  void record_contact(const explicit_dynamics::MicrostepContacts::RecordedImpact& impact);
  void check_overload();
  void update_overload(NodeId node, double last_check);
  void open(const Overload& overload);
  void wait_beside_crack(const std::vector<TetId>& star, const std::vector<NodeId>& front, double transit);
  std::vector<NodeId> front_among(const std::vector<TetId>& tets) const;
  void follow(std::span<const NodeCopy> copies, const std::vector<TetId>& star,
              const std::vector<std::array<TetId, 4>>& neighbors);
  void follow_edges(std::span<const EdgeCopy> copies);
  void constrain_again();
  void update_threshold(int index);
  void update_linear_states(std::span<const TetId> tets, const Body& body, std::vector<ElementState>& states);
  void update_quadratic_states(std::span<const TetId> tets, const Body& body);
  void update_one_rings();
  void let_sliver_yield(TetId tet, const Mat3& strain);
  Mat3 elastic_strain(TetId tet, const Mat3& strain) const;
  void write_back();
  void begin_account();
  void end_account();
  double work() const;
  double work_of_elements() const;
  void account_work();
  double relieved_energy(bool at_start) const;
  void add_external_works(EnergyAccount& spent) const;
  int local(NodeId node) const { return local_of_node_[node]; }
  const Body& body_of(NodeId node) const;
  bool is_followed(const Body& body) const { return body.explicit_state && body.explicit_state->group == group_; }
  bool is_quiet() const;
  double transit_time(NodeId node) const;

  WorldState& world_;
  int group_ = 0;
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
  std::vector<long> seen_;                               ///< per slot: microstep at which its state was made
  std::vector<Overload> overloaded_;
  std::vector<TetId> stale_;
  std::vector<int> flagged_;
  Opened opened_;
  std::vector<Start> starts_;  ///< per explicit node
  std::vector<ChangingLoad> changing_loads_;
  EnergyAccount work_of_changing_loads_;                         ///< what they did in this build
  std::map<std::pair<NodeId, int>, std::size_t> contact_views_;  ///< of a node and an obstacle, among the world's
  EnergyAccount first_;                                          ///< what an account of this build starts from
  double dt_ = 0, time_ = 0, min_speed_ = 0;
  double work_ = 0;  ///< beside elements and nodes [µs of a usual core]
  long microsteps_ = 0;
  bool rebuild_ = false;  ///< the mesh has changed
};

}  // namespace griffith
