#pragma once

#include "sim/explicit/obstacle.h"
#include "sim/world/energy/elastic_works.h"
#include "sim/world/world_state.h"

/// What the phases of a step tell the energy account. Works are taken over what moved: of an impulse on something rigid
/// at the mean of its velocities before and after, which is exact; of a force on an elastic body over its displacement.
namespace griffith {

/// Elastic energy of a body, as its elements were seen last [J].
double elastic_energy(const WorldState& world, const Body& body);
/// Kinetic and elastic energy of a body, as it is: of a rigid one by its motion [J].
double energy_of(const WorldState& world, const Body& body);
/// What the motion of a quadratic body's edges adds to its kinetic energy [J].
double kinetic_energy_of_edges(const WorldState& world, const Body& body);
/// Kinetic [J].
double kinetic_energy(const RigidMotion& motion);
double kinetic_energy(const Projectile& projectile, const RigidState& state);
double kinetic_energy_of_projectiles(const WorldState& world);

/// The account of a world that is ready to start.
void open_account(WorldState& world);
/// What is there now, `elastic` energy of all elements among it [J]. After each step.
void close_account(WorldState& world, double elastic);
/// What is there and the potential energy, to tell what an edit changes.
struct EnergyNow {
  double stored = 0, potential = 0, lost = 0;  ///< [J]; lost: as booked so far
};
EnergyNow energy_now(const WorldState& world);
void account_edit(WorldState& world, const EnergyNow& before);
void account_launch(WorldState& world, const Projectile& projectile, const RigidState& state);

/// When a substep begins.
void record_substep_start(WorldState& world);
/// What contacts took from rigid bodies and projectiles, and how these fell, after their velocities were solved for a
/// substep of `dt` [s] and before bodies move.
void account_rigid_contacts(WorldState& world, double dt);

/// A body before it moves.
struct BodySnapshot {
  std::vector<Vec3> positions, velocities;     ///< per node of the body
  std::vector<Vec3> offsets, edge_velocities;  ///< per edge of the body
  std::vector<Mat3> plastic_strains;           ///< per tet; empty unless it yields
};
BodySnapshot snapshot(const WorldState& world, const Body& body);
/// Stresses of its tets, as ElementState has them, of quadratic ones those of their corners [Pa].
std::vector<Mat3> stresses_of(const WorldState& world, const Body& body);

/// Step by which an elastic body moved.
enum class ElasticMove { linearized, nonlinear, unconverged };

/// What a substep took from an elastic body, now that it has moved from `before`: backward Euler loses the kinetic
/// energy of the change of velocities and the elastic energy of the change of strains. `external` forces as in
/// predict_velocities().
EnergyAccount spent_in_move(const WorldState& world, const Body& body, const BodySnapshot& before,
                            const ElasticWorks& elastic, const std::vector<Vec3>& external, double dt,
                            ElasticMove move);
/// What a static equilibrium took, a step without inertia, from a body that had `stresses` (stresses_of()). Prescribed
/// supports went on for `displacement_time` [s].
EnergyAccount spent_in_equilibrium(const WorldState& world, const Body& body, const BodySnapshot& before,
                                   const std::vector<Mat3>& stresses, double displacement_time);
/// What a substep took from a rigid body that has moved on from `before`.
EnergyAccount spent_in_rigid_move(const WorldState& world, const Body& body, const RigidMotion& before, double dt);
/// Work of yielding, since `before` [J].
double plastic_work(const WorldState& world, const Body& body, const BodySnapshot& before);

/// Counts the area of new cracks: faces of a tet that have just lost their neighbors, one side of each crack.
void account_crack(WorldState& world, TetId tet, int face);

/// What obstacles of microsteps are in the world, to tell what is lost when they are taken back to it.
class ObstacleAccount {
 public:
  /// Takes the velocities that they have when the microsteps begin.
  ObstacleAccount(const WorldState& world, std::span<const explicit_dynamics::Obstacle> obstacles);
  /// Books what was lost, once they are back in the world.
  void record(WorldState& world, std::span<const explicit_dynamics::Obstacle> obstacles) const;

 private:
  struct Kept {
    double energy = 0;
    Vec3 center = Vec3::Zero();
  };
  static Kept kept_by(const WorldState& world, const explicit_dynamics::Obstacle& obstacle);
  std::vector<Kept> before_;
};

}  // namespace griffith
