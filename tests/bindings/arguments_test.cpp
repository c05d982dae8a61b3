// Random sequences of calls with arguments that are often wrong: each gives a status, and an error that says where.
#include <array>
#include <cstring>
#include <limits>
#include <vector>

#include "tests/bindings/interface.h"
#include "tests/random_values.h"

namespace griffith::testing {
namespace {

/// Makes calls at random on a few scenes and worlds.
class Caller {
 public:
  explicit Caller(unsigned seed) : random_(seed) {}

  void call() {
    std::memset(&error_, 0x7f, sizeof error_);
    const griffith_status status = call_any();
    if (wants_error_) check(status);
    ++(status == GRIFFITH_OK ? succeeded_ : refused_);
  }

  int succeeded() const { return succeeded_; }
  int refused() const { return refused_; }

 private:
  griffith_status call_any() {
    wants_error_ = random_.index(8) != 0;
    griffith_error* error = wants_error_ ? &error_ : nullptr;
    switch (random_.index(21)) {
      case 0:
        return keep(scenes_, [&](griffith_scene** made) { return griffith_scene_parse(text(), text(), made, error); });
      case 1:
        return keep(scenes_, [&](griffith_scene** made) { return griffith_scene_copy(scene(), made, error); });
      case 2:
        return griffith_scene_set(scene(), pointer(), json(), error);
      case 3: {
        char* value = nullptr;
        const griffith_status status =
            griffith_scene_get(scene(), pointer(), random_.index(9) ? &value : nullptr, error);
        griffith_string_free(value);
        return status;
      }
      case 4:
        return set_mesh(error);
      case 5:
        return keep(worlds_,
                    [&](griffith_world** made) { return griffith_world_create(scene(), nullptr, made, error); });
      case 6:
        return keep(worlds_, [&](griffith_world** made) { return griffith_world_copy(world(), made, error); });
      case 7:
        return griffith_world_restore(world(), world(), error);
      case 8:
        return griffith_world_step(world(), random_.index(5) - 1, error);
      case 9: {
        const griffith_shot shot = {
            {number(), number(), number()}, {number(), number(), number()}, number(), number(), number()};
        return griffith_world_fire(world(), random_.index(9) ? &shot : nullptr, error);
      }
      case 10:
        return griffith_world_fire_json(world(), json(), error);
      case 11:
        return griffith_world_set_material(world(), random_.index(4) - 1, field(), json(), error);
      case 12: {
        double value = 0;
        return griffith_world_value(world(), field(), random_.index(9) ? &value : nullptr, error);
      }
      case 13: {
        griffith_array view;
        return griffith_world_array(world(), random_.index(GRIFFITH_ARRAY_COUNT + 10) - 5,
                                    random_.index(9) ? &view : nullptr, error);
      }
      case 14: {
        griffith_array view;
        const char* name = random_.index(2) ? "von_mises" : field();
        return griffith_world_quantity(world(), name, random_.index(9) ? &view : nullptr, error);
      }
      case 15:
        return griffith_world_update_surfaces(world(), error);
      case 16:
        return griffith_world_push(world(), vector(), vector(), error);
      case 17: {
        const griffith_spring spring = {number(), number(), number()};
        return griffith_world_grab(world(), vector(), vector(), random_.index(2) ? &spring : nullptr, error);
      }
      case 18:
        return griffith_world_move_grab(world(), vector(), error);
      case 19:
        return griffith_world_release(world(), error);
      default:
        return random_.index(2) ? griffith_world_start_recording(world(), error)
                                : griffith_world_save_recording(world(), "/no/such/folder/run.tar.zst", error);
    }
  }

  void check(griffith_status status) {
    ASSERT_EQ(error_.status, status);
    ASSERT_TRUE(std::memchr(error_.where, 0, sizeof error_.where));
    ASSERT_TRUE(std::memchr(error_.problem, 0, sizeof error_.problem));
    ASSERT_TRUE(std::memchr(error_.remedy, 0, sizeof error_.remedy));
    if (status == GRIFFITH_OK) return;
    EXPECT_TRUE(status == GRIFFITH_INVALID_ARGUMENT || status == GRIFFITH_INPUT_ERROR)
        << griffith_status_name(status) << ": " << error_.where << ": " << error_.problem;
    EXPECT_STRNE(error_.where, "") << error_.problem;
    EXPECT_STRNE(error_.problem, "") << error_.where;
  }

  /// Keeps what was made in place of one of three.
  template <class Owned, class Make>
  griffith_status keep(std::array<Owned, 3>& all, const Make& make) {
    typename Owned::pointer made = nullptr;
    const griffith_status status = make(random_.index(9) ? &made : nullptr);
    EXPECT_EQ(made != nullptr, status == GRIFFITH_OK);
    if (made) all[random_.index(3)].reset(made);
    return status;
  }

  griffith_status set_mesh(griffith_error* error) {
    static constexpr double kPoints[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::int32_t tets[] = {0, 1, random_.index(6) - 1, 3};
    const bool null_points = random_.index(9) == 0, null_tets = random_.index(9) == 0;
    return griffith_scene_set_mesh(scene(), field(), null_points ? nullptr : kPoints, random_.index(7) ? 4 : -1,
                                   null_tets ? nullptr : tets, random_.index(2), error);
  }

  griffith_scene* scene() { return scenes_[random_.index(3)].get(); }
  griffith_world* world() { return worlds_[random_.index(3)].get(); }

  double number() {
    static constexpr double kNumbers[] = {
        0, 1, -1, 3, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 20};
    return random_.index(2) ? random_.uniform(0.1, 5) : kNumbers[random_.index(8)];
  }
  /// Returns three numbers, valid until the next call but one.
  const double* vector() {
    std::array<double, 3>& numbers = vectors_[next_vector_++ % vectors_.size()];
    numbers = {number(), number(), number()};
    return random_.index(9) ? numbers.data() : nullptr;
  }
  template <std::size_t N>
  const char* one_of(const char* const (&texts)[N]) {
    return texts[random_.index(N)];
  }
  const char* text() {
    static constexpr const char* kTexts[] = {kShotWall, kShotWall, kShotWall,  "{\"version\": 1}",
                                             "",        "{",       "\xff\xfe", nullptr};
    return one_of(kTexts);
  }
  const char* pointer() {
    static constexpr const char* kPointers[] = {"",
                                                "/bodies/0/material/density",
                                                "/bodies/0/shape",
                                                "/projectiles/0/speed",
                                                "/gravity",
                                                "/simulation/time_step",
                                                "/bodies/9",
                                                "//",
                                                "/nothing",
                                                "/bodies/0/material",
                                                "~",
                                                nullptr};
    return one_of(kPointers);
  }
  const char* field() {
    static constexpr const char* kFields[] = {"young_modulus", "density", "poisson_ratio", "time", "energy_kinetic", "",
                                              "a/b",           "name",    "tet",           nullptr};
    return one_of(kFields);
  }
  const char* json() {
    static constexpr const char* kValues[] = {
        "1", "-1", "2000", "0.3", "1e999", "null", "\"granite\"", "[0, 0, 0]", "{}", "{\"speed\": 5, \"count\": 2}",
        "{", "",   nullptr};
    return one_of(kValues);
  }

  RandomValues random_;
  std::array<OwnedScene, 3> scenes_;
  std::array<OwnedWorld, 3> worlds_;
  std::array<std::array<double, 3>, 2> vectors_ = {};
  std::size_t next_vector_ = 0;
  griffith_error error_ = {};
  bool wants_error_ = true;
  int succeeded_ = 0, refused_ = 0;
};

TEST(CArguments, RandomCallsAreAnsweredOrRefused) {
  const char* wanted = std::getenv("GRIFFITH_RANDOM_CALLS");
  const int calls = wanted ? std::atoi(wanted) : 20'000;
  int succeeded = 0, refused = 0;
  for (int seed = 0; seed * 2000 < calls && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Caller caller(seed);
    for (int i = 0; i < 2000 && !HasFailure(); ++i) caller.call();
    succeeded += caller.succeeded();
    refused += caller.refused();
  }
  EXPECT_GT(succeeded, calls / 10);
  EXPECT_GT(refused, calls / 10);
}

TEST(CArguments, NullIsNothingToDestroy) {
  griffith_scene_destroy(nullptr);
  griffith_world_destroy(nullptr);
  griffith_thread_limit_destroy(nullptr);
  griffith_string_free(nullptr);
  EXPECT_EQ(griffith_world_state_hash(nullptr), 0u);
}

}  // namespace
}  // namespace griffith::testing
