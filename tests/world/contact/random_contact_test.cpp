// Random scenes of bodies in contact, and what holds in each of them.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "sim/core/parallel.h"
#include "sim/scene/scene_writer.h"
#include "tests/world/contact/contact_case.h"
#include "tests/world/contact/contact_scenes.h"
#include "tests/world/contact/overlaps.h"
#include "tests/world/contact/random_contact_scene.h"

namespace griffith {
namespace {

using testing::RandomContactScene;

int number_from_environment(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : otherwise;
}

/// Where the scenes of failures are written.
std::filesystem::path scene_path(unsigned seed) {
  const char* folder = std::getenv("GRIFFITH_RANDOM_FOLDER");
  const auto at = folder ? std::filesystem::path(folder) : std::filesystem::temp_directory_path();
  return at / ("random_contact_" + std::to_string(seed) + ".json");
}

/// Figures of a run, each the worst of any step or that at its end.
struct RunFigures {
  double gained = -1, unaccounted = 0;  ///< fractions of the energy turnover
  double sunk_center = -1e300;          ///< depth of a center of mass below the ground [m]
  bool finite = true;
  std::uint64_t early_hash = 0;
};

constexpr int kHashedStep = 40;

/// Energy below which nothing is turned over [J]: of the fall of everything in a time step, or by 10⁻⁴ of its size.
double negligible_energy(const Frame& frame, const RandomContactScene& made) {
  const double g = made.scene.gravity.norm(), dt = made.scene.simulation.time_step;
  return frame.totals.mass * g * std::min(0.5 * g * dt * dt, 1e-4 * made.size);
}

void look_at(const Frame& frame, const RandomContactScene& made, RunFigures& figures) {
  const double least = negligible_energy(frame, made);
  figures.gained = std::max(figures.gained, testing::energy_gained(frame.energy, least));
  figures.unaccounted = std::max(figures.unaccounted, testing::energy_unaccounted(frame.energy, least));
  for (const BodyView& body : frame.bodies)
    figures.sunk_center = std::max(figures.sunk_center, made.scene.ground->height - body.center_of_mass.y());
  for (const ProjectileView& projectile : frame.projectiles)
    figures.sunk_center = std::max(figures.sunk_center, made.scene.ground->height - projectile.position.y());
  figures.finite = figures.finite && frame.report.non_finite_values == 0 &&
                   std::isfinite(frame.totals.kinetic_energy + frame.totals.elastic_energy);
}

RunFigures run(World& world, const RandomContactScene& made) {
  RunFigures figures;
  while (world.frame().time < made.duration) {
    world.step();
    look_at(world.frame(), made, figures);
    if (world.frame().step == kHashedStep) figures.early_hash = world.state_hash();
    if (!figures.finite) break;
    if (world.frame().step > kHashedStep && made.comes_to_rest && testing::all_asleep(world.frame())) break;
  }
  return figures;
}

std::uint64_t hash_with_two_threads(const Scene& scene) {
  const ThreadLimit limit(2);
  World world(scene);
  for (int step = 0; step < kHashedStep; ++step) world.step();
  return world.state_hash();
}

class RandomContact : public testing::ContactLaw<int> {};

TEST_P(RandomContact, KeepsEnergyBoundsAndSleeps) {
  const unsigned seed = static_cast<unsigned>(GetParam());
  const RandomContactScene made = testing::RandomContactMaker(seed).make();
  RecordProperty("kind", made.kind);
  const ThreadLimit limit(1);
  World world(made.scene);
  const RunFigures figures = run(world, made);
  const Frame frame = world.frame();
  const testing::Overlap overlap = testing::worst_overlap(frame);
  testing::check_at_most("energy gained", figures.gained, 0.01);
  testing::check_at_most("energy unaccounted", figures.unaccounted, 0.01);
  testing::check_at_most("center below the ground [sizes]", figures.sunk_center / made.size, 0);
  testing::check_at_most("node below the ground at the end [sizes]", testing::depth_below(frame) / made.size, 0.01);
  testing::check_equal("finite", figures.finite, 1);
  if (made.comes_to_rest) testing::check_equal("asleep at the end", testing::all_asleep(frame), 1);
  testing::check_at_most("overlap at the end [sizes]", overlap.fraction, 0.01);
  if (frame.step >= kHashedStep) {
    EXPECT_EQ(hash_with_two_threads(made.scene), figures.early_hash) << "two threads";
  }
  if (!HasFailure()) return;
  write_scene(made.scene, scene_path(seed));
  std::printf("seed %u, a %s: %s\n", seed, made.kind.c_str(), scene_path(seed).c_str());
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomContact,
                         ::testing::Range(number_from_environment("GRIFFITH_RANDOM_SEED", 1),
                                          number_from_environment("GRIFFITH_RANDOM_SEED", 1) +
                                              number_from_environment("GRIFFITH_RANDOM_CONTACTS", 60)),
                         [](const auto& test) { return "Seed" + std::to_string(test.param); });

}  // namespace
}  // namespace griffith
