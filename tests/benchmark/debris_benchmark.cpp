// What the steps of much debris cost: a wall of 432 tetrahedra that splits to dust, and bricks that fall into a heap
// and come to rest, compared with a Bullet world of the same bricks. Counters: the longest step, the mean one, the
// median and that which one in a hundred exceeds [ms of one thread]; pieces at the end, how many of them are awake, and
// the deepest overlap of all steps [mm].

#include <benchmark/benchmark.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <numbers>

#include "sim/core/parallel.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

constexpr double kTimeStep = 1.0 / 120;

Scene weak_wall() {
  Scene scene;
  BodyDescription& wall = scene.bodies.emplace_back();
  wall.shape = BoxShape{Vec3(12, 12, 1), Vec3(1.334, 1.5, 1), BoxPattern::kuhn};
  wall.position = Vec3(0, 6, 0);
  wall.material.tensile_strength = 6e3;
  wall.material.fracture_toughness = 1.8e4;
  wall.supports = {{HalfSpaceRegion{Vec3(0, -6, 0), -Vec3::UnitY()}}};
  ProjectileBurst shots;
  shots.count = 3;
  shots.interval = 0.25;
  shots.start = 0.1;
  shots.position = Vec3(0, 7, 8.5);
  scene.projectiles = {shots};
  return scene;
}

const Vec3 kBrick(0.12, 0.08, 0.1);

/// Layers of 10 × 10 bricks, each turned its own way.
Vec3 brick_place(int i) { return {0.17 * (i % 10 - 4.5), 0.2 + 0.17 * (i / 100), 0.17 * (i / 10 % 10 - 4.5)}; }
Vec3 brick_turn(int i) { return Vec3(37 * i % 60 - 30, 53 * i % 90 - 45, 71 * i % 60 - 30); }

/// Returns bricks of a material too strong to break.
Scene falling_bricks(int count) {
  Scene scene;
  for (int i = 0; i < count; ++i) {
    BodyDescription& brick = scene.bodies.emplace_back();
    brick.shape = BoxShape{kBrick, kBrick, BoxPattern::five_tet};
    brick.position = brick_place(i);
    brick.rotation_degrees = brick_turn(i);
    brick.material.tensile_strength = 5e8;
    brick.material.fracture_toughness = 1e12;
  }
  return scene;
}

/// Bullet's own world, with its defaults.
class BulletHeap {
 public:
  explicit BulletHeap(int count)
      : dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
        ground_shape_(btVector3(0, 1, 0), 0) {
    world_.setGravity(btVector3(0, -9.81, 0));
    for (int k = 0; k < 8; ++k)
      brick_shape_.addPoint(0.5 * btVector3(k & 1 ? kBrick.x() : -kBrick.x(), k & 2 ? kBrick.y() : -kBrick.y(),
                                            k & 4 ? kBrick.z() : -kBrick.z()));
    brick_shape_.setMargin(1e-3);
    add(ground_shape_, 0, btTransform::getIdentity());
    for (int i = 0; i < count; ++i) {
      const Vec3 place = brick_place(i), turn = std::numbers::pi / 180 * brick_turn(i);
      btQuaternion rotation;
      rotation.setEulerZYX(turn.z(), turn.y(), turn.x());
      add(brick_shape_, 1800 * kBrick.prod(), btTransform(rotation, btVector3(place.x(), place.y(), place.z())));
    }
  }
  ~BulletHeap() {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  BulletHeap(const BulletHeap&) = delete;
  BulletHeap& operator=(const BulletHeap&) = delete;

  void step() { world_.stepSimulation(kTimeStep, 1, kTimeStep); }
  int awake() const {
    return static_cast<int>(std::ranges::count_if(bodies_, [](const auto& body) { return body->isActive(); }));
  }

 private:
  void add(btCollisionShape& shape, double mass, const btTransform& place) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_startWorldTransform = place;
    info.m_friction = 0.6;
    info.m_restitution = 0.1;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    world_.addRigidBody(bodies_.back().get());
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  btStaticPlaneShape ground_shape_;
  btConvexHullShape brick_shape_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

/// Processor time of all threads so far [ms].
double processor_time() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Calls `step` so often and writes the counters of its costs.
template <class Step>
void count_steps(benchmark::State& state, int steps, Step step) {
  std::vector<double> times;
  for (int i = 0; i < steps; ++i) {
    const double start = processor_time();
    step();
    times.push_back(processor_time() - start);
  }
  double sum = 0;
  for (const double time : times) sum += time;
  std::ranges::sort(times);
  state.counters["mean_ms"] = sum / steps;
  state.counters["median_ms"] = times[times.size() / 2];
  state.counters["99_percent_ms"] = times[times.size() * 99 / 100];
  state.counters["longest_ms"] = times.back();
}

void run(benchmark::State& state, const Scene& scene, int steps) {
  const ThreadLimit one_thread(1);
  for (auto _ : state) {
    World world(scene);
    double deepest = 0;
    count_steps(state, steps, [&] {
      world.step();
      deepest = std::max(deepest, world.frame().report.max_penetration);
    });
    const Frame frame = world.frame();
    state.counters["pieces"] = static_cast<double>(frame.bodies.size());
    state.counters["awake"] = static_cast<double>(frame.bodies.size()) - frame.report.sleeping_bodies;
    state.counters["deepest_mm"] = 1e3 * deepest;
  }
}

void wall_to_dust(benchmark::State& state) { run(state, weak_wall(), 300); }
BENCHMARK(wall_to_dust)->Unit(benchmark::kMillisecond)->Iterations(1);

constexpr int kHeapSteps = 600;

void heap_of_bricks(benchmark::State& state) {
  run(state, falling_bricks(static_cast<int>(state.range(0))), kHeapSteps);
}
BENCHMARK(heap_of_bricks)->Arg(300)->Arg(1000)->Arg(2000)->Unit(benchmark::kMillisecond)->Iterations(1);

void heap_of_bricks_in_bullet(benchmark::State& state) {
  for (auto _ : state) {
    BulletHeap heap(static_cast<int>(state.range(0)));
    count_steps(state, kHeapSteps, [&] { heap.step(); });
    state.counters["awake"] = heap.awake();
  }
}
BENCHMARK(heap_of_bricks_in_bullet)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace griffith
