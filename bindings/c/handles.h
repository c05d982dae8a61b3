#pragma once

#include <griffith/griffith.h>

#include <optional>

#include "bindings/c/surfaces.h"
#include "sim/core/parallel.h"
#include "sim/recording/recording.h"
#include "sim/scene/scene.h"
#include "sim/world/output/quantity_values.h"
#include "sim/world/setup/in_memory_meshes.h"
#include "sim/world/world.h"

// Opaque types of the C interface.

struct griffith_scene {
  griffith::Scene scene;
  griffith::InMemoryMeshes meshes;
};

struct griffith_world {
  griffith::World world;
  bool edited = false;  ///< a shot or another material, which a recording started now would lack
  std::optional<griffith::Recording> recording = {};
  griffith::c::Surfaces surfaces = {};
  griffith::QuantityArray quantity = {};  ///< the one computed last
};

struct griffith_thread_limit {
  griffith::ThreadLimit limit;
};
