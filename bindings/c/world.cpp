#include "sim/world/world.h"

#include <griffith/version.h>

#include <cmath>

#include "bindings/c/guarded.h"
#include "bindings/c/handles.h"
#include "bindings/c/material_at.h"
#include "sim/scene/edit_scene.h"
#include "sim/scene/scene_fields.h"
#include "sim/scene/scene_reader.h"

using namespace griffith;
using namespace griffith::c;

namespace {

constexpr char kWorld[] = "world";

Monitor monitor_of(const griffith_monitor* monitor) {
  Monitor result;
  if (!monitor) return result;
  if (monitor->stage)
    result.stage = [monitor](std::string_view name) { monitor->stage(std::string(name).c_str(), monitor->context); };
  if (monitor->cancelled) result.cancelled = [monitor] { return monitor->cancelled(monitor->context) != 0; };
  return result;
}

Vec3 vector_of(const double (&values)[3]) { return {values[0], values[1], values[2]}; }

bool is_within(const Numbers& range, double value) { return value >= range.minimum && value <= range.maximum; }

bool is_within(const Numbers& range, const Vec3& values) {
  return is_within(range, values.minCoeff<Eigen::PropagateNaN>()) &&
         is_within(range, values.maxCoeff<Eigen::PropagateNaN>());
}

ProjectileBurst burst_of(const griffith_shot& shot) {
  ProjectileBurst burst;
  burst.position = vector_of(shot.position);
  burst.direction = vector_of(shot.direction);
  burst.speed = shot.speed;
  burst.mass = shot.mass;
  burst.radius = shot.radius;
  require(is_within(kPlace, burst.position), "shot.position", "is out of range", "-1e6 to 1e6 m");
  require(is_within(kDirection, burst.direction) && !burst.direction.isZero(0), "shot.direction", "has no direction",
          "any length but 0, components of -1e6 to 1e6");
  require(is_within(kShotSpeed, shot.speed), "shot.speed", "is out of range", "0 to 1e5 m/s");
  require(is_within(kShotMass, shot.mass), "shot.mass", "is out of range", "1e-6 to 1e9 kg");
  require(is_within(kShotRadius, shot.radius), "shot.radius", "is out of range", "1e-4 to 1e4 m");
  return burst;
}

/// Parses an entry of a scene's projectiles.
ProjectileBurst burst_of(const World& world, const std::string& json) {
  Scene scene;
  scene.folder = world.scene().folder;
  const SceneSetting setting{"/projectiles", "[" + json + "]"};
  const Scene with_shot = edited(scene, {&setting, 1}, "shot");
  if (with_shot.projectiles.size() != 1) throw InputError("shot", "is not one JSON object", "{\"speed\": 20}");
  return with_shot.projectiles[0];
}

/// Returns the current material of a body with one field changed.
Material changed_material(const World& world, int body, const std::string& field, const std::string& json) {
  Scene scene;
  scene.bodies = {world.scene().bodies[body]};
  scene.bodies[0].material = world.frame().materials[body];
  const SceneSetting setting{scene_pointer("/bodies/0/material/" + field, "field"), json};
  return edited(scene, {&setting, 1}, "material").bodies[0].material;
}

void record(griffith_world& world, WorldInput input) {
  world.edited = true;
  if (world.recording) world.recording->inputs.push_back(std::move(input));
}

void fire(griffith_world& world, const ProjectileBurst& burst) {
  record(world, {world.world.frame().step, world.world.fire(burst)});
}

/// Returns a vector argument, of components within the range.
Vec3 vector_of(const double* values, const char* name, const Numbers& range, const char* remedy) {
  require(values != nullptr, name, "is null", "pass three numbers");
  const Vec3 vector(values[0], values[1], values[2]);
  require(is_within(range, vector), name, "is out of range", remedy);
  return vector;
}

Vec3 place_of(const double* values, const char* name) {
  return vector_of(values, name, kPlace, "components of -1e6 to 1e6 m");
}

GrabSpring spring_of(const griffith_spring* spring) {
  if (!spring) return {};
  require(is_within(between(0.01, 100), spring->frequency), "spring.frequency", "is out of range", "0.01 to 100 Hz");
  require(is_within(between(0, 10), spring->damping_ratio), "spring.damping_ratio", "is out of range", "0 to 10");
  require(is_within(between(0.01, 1e6), spring->strength), "spring.strength", "is out of range", "0.01 to 1e6");
  return {spring->frequency, spring->damping_ratio, spring->strength};
}

MaterialPlace required_material_at(const World& world, const Vec3& place) {
  const MaterialPlace found = material_at(world.frame(), place);
  require(found.tet >= 0, "position", "is near no body: the world has none", "add a body to the scene");
  return found;
}

}  // namespace

std::uint32_t griffith_abi_version(void) { return GRIFFITH_ABI_VERSION; }

const char* griffith_version(void) { return GRIFFITH_VERSION; }

const char* griffith_status_name(std::int32_t status) {
  switch (status) {
    case GRIFFITH_OK:
      return "ok";
    case GRIFFITH_INVALID_ARGUMENT:
      return "invalid argument";
    case GRIFFITH_INPUT_ERROR:
      return "input error";
    case GRIFFITH_CANCELLED:
      return "cancelled";
    case GRIFFITH_OUT_OF_MEMORY:
      return "out of memory";
    case GRIFFITH_INTERNAL_ERROR:
      return "internal error";
    default:
      return "unknown status";
  }
}

griffith_status griffith_world_create(const griffith_scene* scene, const griffith_monitor* monitor,
                                      griffith_world** world, griffith_error* error) {
  return guarded(error, [&] {
    const griffith_scene& from = object_of(scene, "scene");
    griffith_world*& made = object_of(world, kWorld);
    made = new griffith_world{World(from.scene, from.meshes, monitor_of(monitor))};
  });
}

griffith_status griffith_world_copy(const griffith_world* world, griffith_world** copy, griffith_error* error) {
  return guarded(error, [&] {
    const griffith_world& from = object_of(world, kWorld);
    object_of(copy, "copy") = new griffith_world{World(from.world), from.edited};
  });
}

griffith_status griffith_world_restore(griffith_world* world, const griffith_world* copy, griffith_error* error) {
  return guarded(error, [&] {
    griffith_world& changed = object_of(world, kWorld);
    const griffith_world& from = object_of(copy, "copy");
    changed.world = World(from.world);
    changed.edited = from.edited;
    changed.recording.reset();
    changed.surfaces = {};
  });
}

void griffith_world_destroy(griffith_world* world) { delete world; }

griffith_status griffith_world_step(griffith_world* world, std::int32_t count, griffith_error* error) {
  return guarded(error, [&] {
    constexpr std::int32_t kMax = 1'000'000;
    griffith_world& stepped = object_of(world, kWorld);
    require(count >= 0 && count <= kMax, "count", "is out of range", "0 to 1,000,000 steps");
    for (std::int32_t step = 0; step < count; ++step) {
      stepped.world.step();
      if (stepped.recording) stepped.recording->hashes.push_back(stepped.world.state_hashes());
    }
  });
}

griffith_status griffith_world_fire(griffith_world* world, const griffith_shot* shot, griffith_error* error) {
  return guarded(error, [&] { fire(object_of(world, kWorld), burst_of(object_of(shot, "shot"))); });
}

griffith_status griffith_world_fire_json(griffith_world* world, const char* json, griffith_error* error) {
  return guarded(error, [&] {
    griffith_world& target = object_of(world, kWorld);
    fire(target, burst_of(target.world, text_of(json, "json")));
  });
}

griffith_status griffith_world_push(griffith_world* world, const double position[3], const double impulse[3],
                                    griffith_error* error) {
  return guarded(error, [&] {
    griffith_world& pushed = object_of(world, kWorld);
    const Vec3 place = place_of(position, "position");
    const Vec3 of_push = vector_of(impulse, "impulse", between(-1e9, 1e9), "components of -1e9 to 1e9 N s");
    const MaterialPlace at = required_material_at(pushed.world, place);
    const Push push{at.tet, at.weights, of_push};
    pushed.world.push(push);
    record(pushed, {pushed.world.frame().step, push});
  });
}

griffith_status griffith_world_grab(griffith_world* world, const double position[3], const double target[3],
                                    const griffith_spring* spring, griffith_error* error) {
  return guarded(error, [&] {
    griffith_world& grabbed = object_of(world, kWorld);
    const Vec3 place = place_of(position, "position"), end = place_of(target, "target");
    const GrabSpring of_grab = spring_of(spring);
    const MaterialPlace at = required_material_at(grabbed.world, place);
    const Grab grab{at.tet, at.weights, end, of_grab};
    grabbed.world.grab(grab);
    record(grabbed, {grabbed.world.frame().step, grab});
  });
}

griffith_status griffith_world_move_grab(griffith_world* world, const double target[3], griffith_error* error) {
  return guarded(error, [&] {
    griffith_world& moved = object_of(world, kWorld);
    const GrabMove move{place_of(target, "target")};
    moved.world.move_grab(move.target);
    record(moved, {moved.world.frame().step, move});
  });
}

griffith_status griffith_world_release(griffith_world* world, griffith_error* error) {
  return guarded(error, [&] {
    griffith_world& released = object_of(world, kWorld);
    released.world.release();
    record(released, {released.world.frame().step, GrabRelease{}});
  });
}

griffith_status griffith_world_set_material(griffith_world* world, std::int32_t scene_body, const char* field,
                                            const char* json, griffith_error* error) {
  return guarded(error, [&] {
    griffith_world& changed = object_of(world, kWorld);
    const auto bodies = static_cast<std::int32_t>(changed.world.scene().bodies.size());
    require(scene_body >= 0 && scene_body < bodies, "scene_body", "is not a body of the scene", "count from 0");
    const Material material =
        changed_material(changed.world, scene_body, text_of(field, "field"), text_of(json, "json"));
    changed.world.set_material(scene_body, material);
    record(changed, {changed.world.frame().step, MaterialChange{scene_body, material}});
  });
}

std::uint64_t griffith_world_state_hash(const griffith_world* world) { return world ? world->world.state_hash() : 0; }

griffith_status griffith_world_start_recording(griffith_world* world, griffith_error* error) {
  return guarded(error, [&] {
    griffith_world& recorded = object_of(world, kWorld);
    require(recorded.world.frame().step == 0 && !recorded.edited, kWorld, "has made steps, shots or edits already",
            "record before the first of them");
    recorded.recording = begin_recording(recorded.world);
  });
}

griffith_status griffith_world_save_recording(const griffith_world* world, const char* path, griffith_error* error) {
  return guarded(error, [&] {
    const griffith_world& recorded = object_of(world, kWorld);
    require(recorded.recording.has_value(), kWorld, "was not recorded", "start the recording before the first step");
    write_recording(*recorded.recording, text_of(path, "path"));
  });
}

griffith_status griffith_world_update_surfaces(griffith_world* world, griffith_error* error) {
  return guarded(error, [&] {
    griffith_world& drawn = object_of(world, kWorld);
    drawn.surfaces.update(drawn.world.frame());
  });
}

griffith_status griffith_thread_limit_create(std::int32_t threads, griffith_thread_limit** limit,
                                             griffith_error* error) {
  return guarded(error, [&] {
    require(threads >= 1 && threads <= 1024, "threads", "is out of range", "1 to 1024");
    object_of(limit, "limit") = new griffith_thread_limit{ThreadLimit(threads)};
  });
}

void griffith_thread_limit_destroy(griffith_thread_limit* limit) { delete limit; }
