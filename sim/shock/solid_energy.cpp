#include "sim/shock/solid.h"

namespace griffith::shock {

double Solid::viscous_work() const {
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

double Solid::elastic_energy(int index) const {
  const SolidBody& body = bodies_[index];
  const BlockLaw& law = body.law;
  double energy = 0;
  for (int b = body.first_block; b < body.first_block + body.blocks; ++b) {
    const ElementBlock& block = blocks_[b];
    const Lanes* e = block.strain;
    const Lanes trace = e[0] + e[1] + e[2];
    const Lanes square = e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + 2 * (e[3] * e[3] + e[4] * e[4] + e[5] * e[5]);
    const Lanes density = 0.5F * law.lambda * trace * trace + law.mu * square;
    for (int lane = 0; lane < kLanes; ++lane)  // strains are those times the stiffness
      if (block.stiffness[lane] > 0) energy += block.volume[lane] * density[lane] / block.stiffness[lane];
  }
  return energy;
}

void Solid::stop_viscosity() {
  for (SolidBody& body : bodies_) body.law.viscosity = 0;
}

Vec3 Solid::acceleration(int index) const {
  Vec3 force = Vec3::Zero();
  for (const int entry : star(index))
    for (int i = 0; i < 3; ++i) force[i] += forces_[entry].value[i];
  const SolidNode& moved = nodes_[index];
  const Vec3 free = moved.inverse_mass * force + external_acceleration(index);
  return moved.constraint < 0 ? free : constraints_[moved.constraint].constraint.allowed * free;
}

double Solid::half_kick_energy() const {
  double sum = 0;
  for (int i = 0; i < node_count(); ++i) sum += acceleration(i).squaredNorm() / nodes_[i].inverse_mass;
  for (int i = 0; i < edge_count(); ++i) sum += edge_acceleration(i).squaredNorm() / edges_[i].inverse_mass;
  return 0.125 * dt_ * dt_ * sum;
}

}  // namespace griffith::shock
