// Heaps and stacks of rigid bodies: they keep apart, gain no energy, come to rest and stay there.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cstring>
#include <numbers>

#include "sim/core/parallel.h"
#include "sim/core/rotation.h"
#include "tests/contact/bodies.h"

namespace griffith {
namespace {

using namespace testing;

/// Rigid bodies that fall and touch, led as their owner does.
class Heap {
 public:
  explicit Heap(double dt, const SurfaceProperties& surface = {}) : world(kGravity), dt_(dt), surface_(surface) {
    world.add_ground(0, surface);
  }

  void add_box(const Vec3& size, double density, const RigidState& state) {
    add(box_part(size), box_mass(size, density * size.prod()), state);
  }
  void add(const ConvexPart& part, const RigidMass& mass, const RigidState& state) {
    const std::vector<ConvexPart> parts = {part};
    ids.push_back(world.add_proxy(parts, mass, Mobility::free, state, surface_));
    masses.push_back(mass);
    corners.push_back(part);
  }

  void step() {
    world.detect(dt_);
    for (const ProxyId id : ids)
      if (!world.asleep(id))
        world.set_velocity(id, world.state(id).velocity + dt_ * kGravity, world.state(id).angular_velocity);
    world.solve(dt_);
    world.advance(dt_);
    world.fall_asleep(dt_);
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (!world.asleep(ids[i])) move(ids[i], masses[i].inertia);
  }

  /// As falls are stepped: in free flight it stays the same.
  double energy() const {
    double sum = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const RigidState state = world.state(ids[i]);
      const Vec3 spin = state.pose.rotation.conjugate() * state.angular_velocity;
      sum += masses[i].mass * (0.5 * state.velocity.squaredNorm() -
                               kGravity.dot(state.pose.translation - 0.5 * dt_ * state.velocity)) +
             0.5 * spin.dot(masses[i].inertia * spin);
    }
    return sum;
  }

  bool all_sleep() const {
    return std::ranges::all_of(ids, [&](ProxyId id) { return world.asleep(id); });
  }

  double lowest_corner() const {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ids.size(); ++i)
      for (const Vec3& corner : corners[i]) lowest = std::min(lowest, world.state(ids[i]).pose.to_world(corner).y());
    return lowest;
  }

  /// Deepest overlap of any two, asleep or not.
  double deepest_overlap() {
    for (const ProxyId id : ids) world.wake_up(id);
    world.detect();
    return world.max_penetration();
  }

  ContactWorld world;
  std::vector<ProxyId> ids;
  std::vector<RigidMass> masses;
  std::vector<ConvexPart> corners;

 private:
  void move(ProxyId id, const Mat3& own_inertia) {
    RigidState state = world.state(id);
    const ContactWorld::Correction correction = world.position_correction(id);
    const Mat3 rotation = state.pose.rotation.toRotationMatrix();
    const Mat3 inertia = rotation * own_inertia * rotation.transpose();
    const Mat3 turn = free_turn(inertia, state.angular_velocity, dt_) * rotation_by(correction.rotation);
    const Vec3 momentum = inertia * state.angular_velocity;
    state.pose.translation += dt_ * state.velocity + correction.translation;
    state.pose.rotation = (Quat(turn) * state.pose.rotation).normalized();
    state.angular_velocity = (turn * inertia * turn.transpose()).inverse() * momentum;
    world.set_state(id, state);
  }

  double dt_;
  SurfaceProperties surface_;
};

/// Boxes and chunks of some centimeters that fall in a column.
Heap random_heap(unsigned seed, int count, double dt) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Heap heap(dt, {0.6 + 0.3 * uniform(random), 0.2 + 0.2 * uniform(random)});
  for (int i = 0; i < count; ++i) {
    RigidState state = at(Vec3(0.2 * uniform(random), 0.15 + 0.06 * i, 0.2 * uniform(random)));
    state.pose.rotation = Quat(rotation_by(2 * Vec3(uniform(random), uniform(random), uniform(random))));
    state.angular_velocity = 5 * Vec3(uniform(random), uniform(random), uniform(random));
    const Vec3 size = Vec3(0.08, 0.06, 0.07) + 0.04 * Vec3(uniform(random), uniform(random), uniform(random));
    i % 3 > 0 ? heap.add_box(size, 2400, state)
              : heap.add(random_chunk(random, 0.05), box_mass(Vec3::Constant(0.07), 0.8), state);
  }
  return heap;
}

TEST(RigidHeap, GainsNoEnergyKeepsApartAndFallsAsleep) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const double dt = seed % 2 == 0 ? 1.0 / 120 : 1.0 / 60;
    Heap heap = random_heap(seed, 60, dt);
    const double put_in = heap.energy();
    int steps = 0;
    for (; steps * dt < 10 && !heap.all_sleep(); ++steps) {
      heap.step();
      ASSERT_LE(heap.energy(), 1.01 * put_in) << seed << ", step " << steps;
    }
    EXPECT_TRUE(heap.all_sleep()) << seed;
    EXPECT_GT(heap.lowest_corner(), -1e-3) << seed;
    EXPECT_LT(heap.deepest_overlap(), 1e-3) << seed << ": a hundredth of their size";
  }
}

TEST(RigidHeap, DoesNotDependOnTheThreadsAndACopyGoesOnAlike) {
  const auto states = [](int threads, bool copied) {
    const ThreadLimit limit(threads);
    Heap heap = random_heap(3, 150, 1.0 / 120);
    for (int i = 0; i < 150; ++i) {
      if (copied && i % 40 == 20) heap.world = ContactWorld(heap.world);
      heap.step();
    }
    std::vector<double> values = {static_cast<double>(heap.world.memory_hash())};
    for (const ProxyId id : heap.ids) {
      const RigidState state = heap.world.state(id);
      for (const Vec3& v : {state.pose.translation, state.velocity, state.angular_velocity})
        values.insert(values.end(), v.data(), v.data() + 3);
    }
    return values;
  };
  const std::vector<double> expected = states(1, false);
  for (const int threads : {1, 2, 4})
    EXPECT_EQ(std::memcmp(states(threads, threads > 1).data(), expected.data(), expected.size() * sizeof(double)), 0)
        << threads << " threads";
}

/// Expects that the bodies stay in place for two seconds and then sleep.
void expect_to_stand(Heap& heap, double dt, double tolerance) {
  std::vector<Vec3> places;
  for (const ProxyId id : heap.ids) places.push_back(heap.world.state(id).pose.translation);
  for (int step = 0; step * dt < 2; ++step) heap.step();
  for (std::size_t i = 0; i < heap.ids.size(); ++i)
    EXPECT_LT((heap.world.state(heap.ids[i]).pose.translation - places[i]).norm(), tolerance) << i << ", dt " << dt;
  EXPECT_TRUE(heap.all_sleep()) << "dt " << dt;
}

// Bricks in flight near each other, then in a heap. Most boxes that meet hold nothing that touches.
TEST(RigidHeap, APieceTakesNoMoreThanFourKilobytes) {
  Heap heap(1.0 / 120);
  for (int i = 0; i < 300; ++i) {
    RigidState state = at(0.17 * Vec3(i % 6 - 2.5, 1.2 + i / 36, i / 6 % 6 - 2.5));
    state.pose.rotation = Quat(rotation_by(Vec3(0.6 * (i % 3), 0.4 * (i % 5), 0.3 * (i % 7))));
    heap.add_box(Vec3(0.12, 0.08, 0.1), 2000, state);
  }
  std::size_t most = 0;
  for (int step = 0; step < 150; ++step) {
    heap.step();
    most = std::max(most, heap.world.memory());
  }
  EXPECT_GT(heap.world.contacts().size(), 300u);
  EXPECT_LT(most, 300u * 4096u);
}

TEST(RigidHeap, StackedPlatesStand) {
  for (const double dt : {1.0 / 30, 1.0 / 120, 1.0 / 250}) {
    Heap heap(dt);
    for (int i = 0; i < 10; ++i) heap.add_box(Vec3(1, 0.05, 1), 2400, at(Vec3(0, 0.025 + 0.05 * i, 0)));
    expect_to_stand(heap, dt, 1e-4);
  }
}

TEST(RigidHeap, ATowerOfCrossedBlocksStands) {
  for (const double dt : {1.0 / 60, 1.0 / 120}) {
    Heap heap(dt);
    const Vec3 size(0.075, 0.015, 0.025);
    for (int layer = 0; layer < 12; ++layer)
      for (int i = -1; i <= 1; ++i) {
        RigidState state = at(Vec3(0, (layer + 0.5) * size.y(), 0));
        if (layer % 2 == 1) state.pose.rotation = Quat(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitY()));
        state.pose.translation += state.pose.rotation * Vec3(0, 0, i * size.z());
        heap.add_box(size, 700, state);
      }
    expect_to_stand(heap, dt, 1e-3);
  }
}

TEST(RigidHeap, BeamsSideBySideStayOnTheGround) {
  Heap heap(1.0 / 120);
  for (const double z : {0.0, 0.03}) heap.add_box(Vec3(1, 0.03, 0.03), 600, at(Vec3(0, 0.015, z)));
  expect_to_stand(heap, 1.0 / 120, 1e-6);
}

TEST(RigidHeap, WhatIsHeavyRestsOnWhatIsLight) {
  Heap heap(1.0 / 120);
  heap.add_box(Vec3(0.2, 0.1, 0.2), 100, at(Vec3(0, 0.05, 0)));
  heap.add_box(Vec3(0.2, 0.2, 0.2), 20'000, at(Vec3(0, 0.2, 0)));
  expect_to_stand(heap, 1.0 / 120, 1e-4);
}

TEST(RigidHeap, NothingIsDeepWhenItLands) {
  for (const double speed : {1.0, 3.0, 8.0}) {
    Heap heap(1.0 / 120, {0.5, 0.1});
    const Vec3 size(0.12, 0.08, 0.1);
    for (int i = 0; i < 3; ++i) heap.add_box(size, 2400, at(Vec3(0, 0.1 + 0.1 * i, 0), Vec3(0, -speed, 0)));
    for (int step = 0; step < 60; ++step) {
      heap.step();
      heap.world.detect();
      EXPECT_LT(heap.world.max_penetration(), 1e-3) << speed << ", step " << step;
    }
  }
}

TEST(RigidHeap, PlatesFallOverOntoTheirFaces) {
  constexpr double kLongStep = 1.0 / 60;
  const Vec3 size(0.02, 0.0014, 0.02);
  for (int degrees = 5; degrees < 90; degrees += 5)
    for (const double spin : {0.0, -10.0, -20.0}) {
      const double angle = degrees * std::numbers::pi / 180;
      Heap heap(kLongStep);
      RigidState state = at(Vec3(0, 0.5 * (size.z() * std::sin(angle) + size.y() * std::cos(angle)), 0));
      state.pose.rotation = Quat(rotation_by(Vec3(-angle, 0, 0)));
      state.angular_velocity = Vec3(-spin, 0, 0);
      heap.add_box(size, 700, state);
      double lowest = 0;
      for (int step = 0; step < 120; ++step) {
        heap.step();
        lowest = std::min(lowest, heap.world.state(heap.ids[0]).pose.translation.y());
      }
      EXPECT_GT(lowest, -0.1 * size.x()) << degrees << " degrees, spin " << spin;
      EXPECT_TRUE(heap.all_sleep()) << degrees << " degrees, spin " << spin;
    }
}

}  // namespace
}  // namespace griffith
