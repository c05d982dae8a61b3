#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "tests/contact/bodies.h"

namespace griffith {
namespace {

using namespace testing;

/// All coordinates of a heap of chunks under fire, in which objects come, go and change, after a second.
std::vector<double> random_heap(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  ContactWorld world(Vec3(0, -9.81, 0));
  world.add_ground(0, {});
  std::vector<ProxyId> chunks, balls;
  const auto chunk_state = [&] { return at(Vec3(uniform(random), 2 + uniform(random), uniform(random))); };
  const Vec3 size = Vec3::Constant(0.2);
  for (int i = 0; i < 60; ++i) {
    std::vector<ConvexPart> parts = {random_chunk(random, 0.15)};
    if (i % 3 == 0) {
      parts.push_back(random_chunk(random, 0.1));
      for (Vec3& corner : parts.back()) corner.x() += 0.15;
    }
    chunks.push_back(world.add_proxy(parts, box_mass(size, 2), Mobility::free, chunk_state(), {}));
  }
  for (int step = 0; step < 120; ++step) {
    if (step % 20 == 0) balls.push_back(world.add_sphere(0.1, 5, at(Vec3(0, 1, 5), Vec3(uniform(random), 0, -40)), {}));
    if (step == 50) {
      for (int i = 0; i < 10; ++i) world.remove(chunks[6 * i]);
      for (int i = 0; i < 10; ++i) chunks.erase(chunks.begin() + 5 * i);
    }
    if (step == 70)
      world.reshape(chunks[3], std::vector<ConvexPart>{random_chunk(random, 0.1)}, box_mass(size, 1), Mobility::free,
                    world.state(chunks[3]));
    substep(world, chunks, kDt, kGravity);
  }
  std::vector<double> values;
  for (const auto* ids : {&chunks, &balls})
    for (ProxyId id : *ids) {
      const RigidState state = world.state(id);
      for (const Vec3& v : {state.pose.translation, state.velocity, state.angular_velocity})
        values.insert(values.end(), v.data(), v.data() + 3);
    }
  return values;
}

TEST(ContactDeterminism, TheSameSceneGivesTheSameBits) {
  for (unsigned seed : {1u, 2u}) {
    const std::vector<double> first = random_heap(seed);
    // Shift the heap's addresses between the runs: nothing may depend on the order of pointers.
    std::vector<std::unique_ptr<char[]>> ballast;
    for (int i = 0; i < 997; ++i) ballast.push_back(std::make_unique<char[]>(40 + 37 * (i % 91)));
    for (std::size_t i = 0; i < ballast.size(); i += 3) ballast[i].reset();
    const std::vector<double> second = random_heap(seed);
    ASSERT_EQ(first.size(), second.size());
    EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(double)), 0);
    for (double value : first) ASSERT_TRUE(std::isfinite(value));
  }
}

}  // namespace
}  // namespace griffith
