// Arrays of the C interface: the simulation's own memory, described as it lies there.
#include <griffith/griffith.h>
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "bindings/c/handles.h"
#include "tests/bindings/interface.h"

namespace griffith::testing {
namespace {

griffith_array array_of(const griffith_world* world, std::int32_t id) {
  griffith_array view = {};
  griffith_error error;
  EXPECT_EQ(griffith_world_array(world, id, &view, &error), GRIFFITH_OK) << error.problem;
  return view;
}

const char* entry(const griffith_array& view, std::int64_t i) {
  return static_cast<const char*>(view.data) + i * view.stride;
}

TEST(CArrays, AreTheMemoryOfTheFrame) {
  const OwnedWorld world = shot_wall(30);
  const Frame frame = world->world.frame();
  EXPECT_EQ(array_of(world.get(), GRIFFITH_NODE_POSITIONS).data, frame.nodes.positions.data());
  EXPECT_EQ(array_of(world.get(), GRIFFITH_TET_NODES).data, frame.elements.tets.data());
  EXPECT_EQ(array_of(world.get(), GRIFFITH_TET_STRESS).data, frame.elements.stresses.data());
  EXPECT_EQ(array_of(world.get(), GRIFFITH_NODE_UTILIZATION).data, &frame.nodes.separations[0].utilization);
  EXPECT_EQ(array_of(world.get(), GRIFFITH_BODY_MASSES).data, &frame.bodies[0].mass);
  EXPECT_EQ(array_of(world.get(), GRIFFITH_CRACK_NORMALS).data, &frame.crack_events[0].normal);
}

TEST(CArrays, EntriesAreThoseOfTheFrame) {
  const OwnedWorld world = shot_wall(30);
  const Frame frame = world->world.frame();
  const griffith_array utilization = array_of(world.get(), GRIFFITH_NODE_UTILIZATION);
  ASSERT_EQ(utilization.count, std::ssize(frame.nodes.separations));
  const griffith_array tensors = array_of(world.get(), GRIFFITH_NODE_SEPARATION_TENSORS);
  for (std::int64_t i = 0; i < utilization.count; ++i) {
    double value = 0, tensor[9];
    std::memcpy(&value, entry(utilization, i), sizeof value);
    std::memcpy(tensor, entry(tensors, i), sizeof tensor);
    EXPECT_EQ(value, frame.nodes.separations[i].utilization);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        EXPECT_EQ(tensor[3 * column + row], frame.nodes.separations[i].tensor(row, column));
  }
  const griffith_array masses = array_of(world.get(), GRIFFITH_BODY_MASSES);
  ASSERT_EQ(masses.count, std::ssize(frame.bodies));
  EXPECT_GT(masses.count, 1) << "the wall is whole";
  double sum = 0, nodes = 0;
  for (std::int64_t i = 0; i < masses.count; ++i) {
    double mass = 0;
    std::memcpy(&mass, entry(masses, i), sizeof mass);
    sum += mass;
  }
  for (const double mass : frame.nodes.masses) nodes += mass;
  EXPECT_NEAR(sum, nodes, 1e-9 * nodes);
}

TEST(CArrays, AllAreDescribedByDifferentNames) {
  std::set<std::string> names;
  for (std::int32_t id = 0; id < GRIFFITH_ARRAY_COUNT; ++id) {
    const griffith_array_info* info = griffith_array_describe(id);
    ASSERT_TRUE(info);
    EXPECT_TRUE(names.insert(info->name).second) << info->name;
    EXPECT_TRUE(std::string(info->meaning).ends_with(".")) << info->name;
  }
  EXPECT_FALSE(griffith_array_describe(-1));
  EXPECT_FALSE(griffith_array_describe(GRIFFITH_ARRAY_COUNT));
}

TEST(CArrays, QuantitiesAreThoseOfFiles) {
  const OwnedWorld world = shot_wall(30);
  const Frame frame = world->world.frame();
  EXPECT_EQ(griffith_quantity_count(), std::ssize(file_quantities()));
  EXPECT_FALSE(griffith_quantity_describe(griffith_quantity_count()));
  for (std::int32_t i = 0; i < griffith_quantity_count(); ++i) {
    const Quantity& quantity = *file_quantities()[i];
    EXPECT_EQ(griffith_quantity_describe(i)->name, quantity.key);
    griffith_array view = {};
    griffith_error error;
    ASSERT_EQ(griffith_world_quantity(world.get(), quantity.key.data(), &view, &error), GRIFFITH_OK) << error.problem;
    const bool of_nodes = place_of(quantity) == ValuePlace::node;
    EXPECT_EQ(view.count, of_nodes ? std::ssize(frame.nodes.positions) : std::ssize(frame.elements.tets));
    const auto* values = static_cast<const double*>(view.data);
    std::visit(
        [&](const auto& expected) { EXPECT_EQ(std::memcmp(values, expected.data(), view.count * view.stride), 0); },
        quantity_array(frame, quantity));
  }
}

TEST(CArrays, NumbersAreThoseOfTheFrame) {
  const OwnedWorld world = shot_wall(30);
  const auto value = [&](const char* name) {
    double result = 0;
    griffith_error error;
    EXPECT_EQ(griffith_world_value(world.get(), name, &result, &error), GRIFFITH_OK) << error.problem;
    return result;
  };
  const Frame frame = world->world.frame();
  EXPECT_EQ(value("step"), 30);
  EXPECT_EQ(value("time"), frame.time);
  EXPECT_EQ(value("energy_kinetic"), frame.energy.kinetic);
  EXPECT_EQ(value("step_contacts"), frame.report.contacts);
  for (std::int32_t i = 0; i < griffith_value_count(); ++i)
    EXPECT_TRUE(std::isfinite(value(griffith_value_describe(i)->name)));
  EXPECT_FALSE(griffith_value_describe(griffith_value_count()));
}

/// The volume that a closed surface encloses.
double volume_of(const griffith_array& positions, std::int64_t first, std::int64_t count) {
  double volume = 0;
  for (std::int64_t i = first; i < first + count; i += 3) {
    Vec3 corners[3];
    for (int k = 0; k < 3; ++k) {
      float corner[3];
      std::memcpy(corner, entry(positions, i + k), sizeof corner);
      corners[k] = Vec3(corner[0], corner[1], corner[2]);
    }
    volume += corners[0].dot(corners[1].cross(corners[2])) / 6;
  }
  return volume;
}

TEST(CSurfaces, EncloseTheirPieces) {
  const OwnedWorld world = shot_wall(60);
  ASSERT_EQ(griffith_world_update_surfaces(world.get(), nullptr), GRIFFITH_OK);
  const Frame frame = world->world.frame();
  const griffith_array positions = array_of(world.get(), GRIFFITH_SURFACE_POSITIONS);
  const auto of_body = [&](griffith_array_id id, std::int64_t body) {
    std::int32_t value = 0;
    std::memcpy(&value, entry(array_of(world.get(), id), body), sizeof value);
    return value;
  };
  for (const BodyView& body : frame.bodies) {
    const double volume = volume_of(positions, of_body(GRIFFITH_SURFACE_FIRST_VERTICES, body.id.index()),
                                    of_body(GRIFFITH_SURFACE_VERTEX_COUNTS, body.id.index()));
    EXPECT_NEAR(volume * frame.materials[body.scene_body].density, body.mass, 1e-3 * body.mass);
  }
}

TEST(CSurfaces, WhatIsRigidKeepsItsVersion) {
  const OwnedWorld world = make_world(R"({"version": 1, "gravity": [0, 0, 0], "ground": null, "bodies": [
      {"shape": {"box": {"size": [1, 1, 1], "element_size": 1}}, "angular_velocity": [0, 3, 1]}]})");
  const auto version = [&] {
    EXPECT_EQ(griffith_world_update_surfaces(world.get(), nullptr), GRIFFITH_OK);
    return *reinterpret_cast<const std::int32_t*>(array_of(world.get(), GRIFFITH_SURFACE_VERSIONS).data);
  };
  EXPECT_EQ(version(), 1);
  ASSERT_EQ(griffith_world_step(world.get(), 50, nullptr), GRIFFITH_OK);
  const std::int32_t spinning = version();
  ASSERT_EQ(griffith_world_step(world.get(), 50, nullptr), GRIFFITH_OK);
  EXPECT_EQ(version(), spinning);
}

}  // namespace
}  // namespace griffith::testing
