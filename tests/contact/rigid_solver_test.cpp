#include "sim/contact/rigid_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace griffith::contact {
namespace {

constexpr double kStep = 1.0 / 60;

/// Group of rigid bodies whose contacts start from arbitrary forces.
class RandomGroup {
 public:
  /// `friction`: Coulomb's coefficient. Masses lie between 1 g and 10 kg. The first body is fixed.
  RandomGroup(int seed, double friction) : random_(seed) {
    const int count = 3 + seed % 6;
    for (int i = 0; i < count; ++i) add_body();
    bodies_[0] = {};
    for (int i = 1; i < count; ++i)
      for (int k = 0; k < 3; ++k) add_contact(static_cast<int>(random_() % i), i, friction);
    group_.bodies.resize(count);
    std::iota(group_.bodies.begin(), group_.bodies.end(), 0);
    group_.contacts.resize(contacts_.size());
    std::iota(group_.contacts.begin(), group_.contacts.end(), 0);
  }

  double kinetic_energy() const {
    double sum = 0;
    for (const RigidBody& body : bodies_)
      if (body.moves)
        sum += (body.velocity.squaredNorm() / body.inverse_mass +
                body.spin.dot(body.inverse_inertia.inverse() * body.spin)) /
               2;
    return sum;
  }

  void solve() { solve_rigid(bodies_, contacts_, std::span(&group_, 1), kStep); }

 private:
  void add_body() {
    RigidBody& body = bodies_.emplace_back();
    body.moves = true;
    const double mass = std::pow(10, 2 * real() - 1), size = std::cbrt(mass / 2500);
    body.inverse_mass = 1 / mass;
    const Quat turn = Quat::FromTwoVectors(Vec3::UnitX(), vector());
    const Vec3 moments = mass * size * size / 6 * (Vec3::Ones() + 0.5 * vector());
    body.inverse_inertia =
        turn.toRotationMatrix() * moments.cwiseInverse().asDiagonal() * turn.toRotationMatrix().transpose();
    body.velocity = vector();
    body.spin = 3 * vector();
    sizes_.push_back(size);
  }

  void add_contact(int a, int b, double friction) {
    RigidContact& contact = contacts_.emplace_back();
    contact.a = a;
    contact.b = b;
    contact.normal = vector().normalized();
    contact.arm_a = sizes_[a] * (0.3 * vector() - 0.5 * contact.normal);
    contact.arm_b = sizes_[b] * (0.3 * vector() + 0.5 * contact.normal);
    contact.friction = friction;
    contact.force = std::pow(10, 4 + real()) * (contact.normal + 0.3 * vector());
  }

  double real() { return 2 * (static_cast<double>(random_()) / std::mt19937::max()) - 1; }
  Vec3 vector() { return {real(), real(), real()}; }

  std::mt19937 random_;
  std::vector<double> sizes_;
  std::vector<RigidBody> bodies_;
  std::vector<RigidContact> contacts_;
  RigidGroup group_;
};

TEST(RigidSolver, ContactsAddNoEnergyWhateverTheyRemember) {
  for (const double friction : {0.0, 0.5, 1.2})
    for (int seed = 0; seed < 300; ++seed) {
      RandomGroup group(seed, friction);
      const double before = group.kinetic_energy();
      group.solve();
      EXPECT_LE(group.kinetic_energy(), before * (1 + 1e-9)) << "seed " << seed << ", friction " << friction;
    }
}

}  // namespace
}  // namespace griffith::contact
