#pragma once

#include "sim/explicit/obstacle.h"
#include "sim/world/energy/elastic_works.h"
#include "sim/world/state/world_state.h"

/// Contributions of the phases of a step to the energy account. Work is taken over the actual motion: of an impulse on
/// a rigid object at the mean of its velocities before and after, which is exact; of a force on an elastic body over
/// its displacement.
namespace griffith {

/// Returns the elastic energy of a body in the last states of its elements [J].
double elastic_energy(const WorldState& world, const Body& body);
/// Returns the kinetic and elastic energy of a body in its present state; of a rigid one by its motion [J].
double energy_of(const WorldState& world, const Body& body);
/// Returns the kinetic energy of edges [J]: the part of a quadratic body that its nodes do not have.
double kinetic_energy_of_edges(const WorldState& world, std::span<const EdgeId> edges);
/// Return kinetic energy [J].
double kinetic_energy(const RigidMotion& motion);
double kinetic_energy(const Projectile& projectile, const RigidState& state);
double kinetic_energy_of_projectiles(const WorldState& world);

/// Opens the account of a world that is ready to start.
void open_account(WorldState& world);
/// Records the present energies, including the `elastic` energy of all elements [J], after each step.
void close_account(WorldState& world, double elastic);
/// Stored energy and potential energy, from which the change by an edit follows.
struct EnergyNow {
  double stored = 0, potential = 0, lost = 0;  ///< [J]; lost: as in the account so far
};
EnergyNow energy_now(const WorldState& world);
void account_edit(WorldState& world, const EnergyNow& before);
void account_launch(WorldState& world, const Projectile& projectile, const RigidState& state);

/// Records the start of a substep.
void record_substep_start(const WorldState& world, Scratch& scratch);
/// Accounts for the energy that contacts took from rigid bodies and projectiles, and for the heights by which these
/// fell. To be called after their velocities were solved for a substep of `dt` [s] and before bodies move.
void account_rigid_contacts(WorldState& world, double dt);

/// State of a body before it moves.
struct BodySnapshot {
  std::vector<Vec3> positions, velocities;     ///< per node of the body
  std::vector<Vec3> offsets, edge_velocities;  ///< per edge of the body
  std::vector<Mat3> plastic_strains;           ///< per tet; empty unless it yields
  std::vector<CornerTensors> point_strains;    ///< per quadratic tet; empty unless it yields
};
BodySnapshot snapshot(const WorldState& world, const Body& body);
/// Restores the plastic strains of a snapshot.
void restore_plastic_strains(WorldState& world, const Body& body, const BodySnapshot& taken);
/// Returns the stresses of its tets, as in ElementState; of quadratic ones those of their corners [Pa].
std::vector<Mat3> stresses_of(const WorldState& world, const Body& body);

/// Step by which an elastic body moved.
enum class ElasticMove { linearized, nonlinear, unconverged };

/// Returns the energy that a substep took from an elastic body, after it has moved from `before`: backward Euler loses
/// the kinetic energy of the velocity change and the elastic energy of the strain change. `external` forces as in
/// predict_velocities().
EnergyAccount spent_in_move(const WorldState& world, const Body& body, const BodySnapshot& before,
                            const ElasticWorks& elastic, const std::vector<Vec3>& external, double dt,
                            ElasticMove move);
/// Returns the energy that a static equilibrium, a step without inertia, took from a body that had `stresses`
/// (stresses_of()). Prescribed supports moved for `displacement_time` [s].
EnergyAccount spent_in_equilibrium(const WorldState& world, const Body& body, const BodySnapshot& before,
                                   const std::vector<Mat3>& stresses, double displacement_time);
/// Returns the energy that a substep took from a rigid body, after it has moved from `before`.
EnergyAccount spent_in_rigid_move(const WorldState& world, const Body& body, const RigidMotion& before, double dt);
/// Returns the work of yielding since `before` [J].
double plastic_work(const WorldState& world, const Body& body, const BodySnapshot& before);

/// Adds a part of the area of one side of a crack to that of all cracks, for which each of both sides counts half.
/// Negative: bonds hold it.
void account_crack(WorldState& world, TetId tet, int face, double part = 1);

/// Energy of the obstacles of microsteps in the world, from which the loss follows when they are placed back in it.
class ObstacleAccount {
 public:
  /// Takes the velocities that they have when the microsteps begin.
  ObstacleAccount(const WorldState& world, std::span<const explicit_dynamics::Obstacle> obstacles);
  /// Accounts for the loss, after they are back in the world.
  void record(WorldState& world, std::span<const explicit_dynamics::Obstacle> obstacles) const;

 private:
  struct Kept {
    double energy = 0, mass = 0;  ///< [J], [kg]
    Vec3 center = Vec3::Zero();   ///< [m]
  };
  static Kept kept_by(const WorldState& world, const explicit_dynamics::Obstacle& obstacle);
  std::vector<Kept> before_;
};

}  // namespace griffith
