#pragma once

#include <griffith/griffith.h>

#include <optional>

#include "bindings/c/surfaces.h"
#include "sim/core/parallel.h"
#include "sim/recording/recording.h"
#include "sim/scene/scene.h"
#include "sim/world/setup/given_meshes.h"
#include "sim/world/world.h"

// What the opaque types of the C interface are.

struct griffith_scene {
  griffith::Scene scene;
  griffith::GivenMeshes meshes;
};

struct griffith_world {
  griffith::World world;
  bool edited = false;  ///< by a shot or another material, which a recording that begins now would miss
  std::optional<griffith::Recording> recording = {};
  griffith::c::Surfaces surfaces = {};
};

struct griffith_thread_limit {
  griffith::ThreadLimit limit;
};
