#include "sim/shock/solid.h"

namespace griffith::shock {
double Solid::take_viscous_work() {
  double sum = 0;
  for (ViscousWork& work : viscous_works_) {
    for (int lane = 0; lane < kLanes; ++lane) sum += work.work[lane];
    work.work = all(0);
  }
  return sum;
}

Vec3 Solid::acceleration(int index) const {
  Vec3 force = Vec3::Zero();
  for (const int entry : star(index))
    for (int i = 0; i < 3; ++i) force[i] += forces_[entry].value[i];
  const SolidNode& moved = nodes_[index];
  const Vec3 free = moved.inverse_mass * force + external_acceleration(index);
  return moved.constraint < 0 ? free : constraints_[moved.constraint].constraint.allowed * free;
}

double Solid::power() {
  for (SolidBody& body : bodies_) body.law.viscosity = 0;
  compute_forces();
  set_step(dt_);
  double sum = 0;
  for (int i = 0; i < node_count(); ++i) {
    Vec3 force = external_acceleration(i) / nodes_[i].inverse_mass;
    for (const int entry : star(i))
      for (int k = 0; k < 3; ++k) force[k] += forces_[entry].value[k];
    sum += force.dot(velocity(i));
  }
  return sum;
}

}  // namespace griffith::shock
