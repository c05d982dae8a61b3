#pragma once

#include <vector>

#include "sim/solver/whole_motion.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Incremental energy of a deformable body in an implicit step of `dt` [s], for the velocities e that deform it:
///   ½ eᵀ M e + ½ h β eᵀ K e − eᵀ (M v + h f_external + p) + Ψ(x + h e)
/// (Martin, Thomaszewski, Grinspun & Gross 2011). Its motion as a whole has no part in it.
class Deformation {
 public:
  /// `before`: the body at the start. `start`: positions of the rows of the body's system after it moved without
  /// deformation, nodes and then edges [m]. `with_tangents`: if it is linear and without plastic strain, its matrix
  /// consists of the second derivatives of its energy, in Scratch::tangents.
  Deformation(WorldState& world, Body& body, const BodySnapshot& before, NodeVectors start, double dt,
              bool with_tangents = false);

  /// Sets M v + h f of the start under `external` forces, per node of the mesh [N], and takes the contacts. `carried`:
  /// velocities of the rows of a body that supports hold, without deformation [m/s].
  void set_load(const std::vector<Vec3>& external, const NodeVectors& carried);
  /// Takes p from Scratch::contact_impulses.
  void take_contacts();
  /// Moves the rows by these velocities.
  void place(const NodeVectors& e);
  const NodeVectors& deforming() const { return deforming_; }

  /// Finds the velocities of least energy, from a guess; false where that does not converge.
  bool minimize(NodeVectors e);
  /// Linearizes the step at these velocities. Returns those of Newton's step without contacts; the body's system is
  /// that of the step.
  NodeVectors without_contacts(const NodeVectors& e);
  /// Impulses that remain unbalanced at the present velocities, and the size of all of them [N·s].
  struct Balance {
    double left = 0, all = 0;
  };
  Balance balance() const;
  /// Moves on along `d` to less energy, the whole way if that is less and leaves each tet a fifth of its volume.
  /// Returns the share; 0 if there is none.
  double search_along(const NodeVectors& d);

 private:
  Eigen::VectorXd masses() const;
  void assemble();
  void remove_whole(NodeVectors& impulses) const;
  void project(NodeVectors& impulses) const;
  void choose_start(const NodeVectors& guess);
  NodeVectors elastic_impulses() const;
  NodeVectors resistance(const NodeVectors& e) const;
  double energy() const;
  std::vector<double> volume_ratios() const;
  NodeVectors residual() const;
  NodeVectors direction(const NodeVectors& residual, double forcing) const;

  WorldState& world_;
  Body& body_;
  const BodySnapshot& before_;
  double dt_;
  NodeVectors start_, external_load_, load_, deforming_;
  Eigen::VectorXd inertia_;
  BlockSparseMatrix
      first_matrix_;  ///< matrix of the step linearized at the start, which damps, where there are tangents
  mutable std::vector<Vec3> forces_;  ///< elastic, per node of the mesh; zero but for the body's [N]
  bool has_tangents_ = false;         ///< the matrix consists of second derivatives of its energy
  double damping_share_ = 0;          ///< fraction of β in the contribution of K to the matrix
  WholeMotion whole_;
};

}  // namespace griffith
