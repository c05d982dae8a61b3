#include "sim/explicit/explicit_bodies.h"

namespace griffith::explicit_dynamics {

double ExplicitBodies::viscous_work() const {
  double sum = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const BlockLaw& law = bodies_[block_bodies_[b]].law;
    const int quadratic = quadratic_of_block_[b];
    const Lanes last = quadratic < 0 ? work_of_last(law, blocks_[b], viscous_works_[b])
                                     : work_of_last(law, blocks_[b], quadratics_[quadratic]);
    const Lanes work = viscous_works_[b].work + last;
    for (int lane = 0; lane < kLanes; ++lane) sum += work[lane];
  }
  return sum;
}

void ExplicitBodies::stop_viscosity() {
  for (ExplicitBody& body : bodies_) body.law.viscosity = 0;
}

Vec3 ExplicitBodies::acceleration(int index) const {
  WideQuad force = {};
  for (const int entry : star(index)) force += __builtin_convertvector(forces_[entry].value, WideQuad);
  const ExplicitNode& moved = nodes_[index];
  const Vec3 free = moved.inverse_mass * vector(force) + external_acceleration(index);
  return moved.constraint < 0 ? free : constraints_[moved.constraint].constraint.allowed * free;
}

double ExplicitBodies::half_kick_energy() const {
  double sum = 0;
  for (int i = 0; i < node_count(); ++i) sum += acceleration(i).squaredNorm() / nodes_[i].inverse_mass;
  for (int i = 0; i < edge_count(); ++i) sum += edge_acceleration(i).squaredNorm() / edges_[i].inverse_mass;
  return 0.125 * dt_ * dt_ * sum;
}

}  // namespace griffith::explicit_dynamics
