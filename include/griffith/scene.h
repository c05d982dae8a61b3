#pragma once

// Scenes: bodies, loads, supports, projectiles, probes; their files.

#include "sim/scene/boundary_condition.h"
#include "sim/scene/probe.h"
#include "sim/scene/projectile_shape.h"
#include "sim/scene/quantities.h"
#include "sim/scene/region.h"
#include "sim/scene/residual_stress.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_setting.h"
#include "sim/scene/scene_writer.h"
#include "sim/scene/shape.h"
#include "sim/scene/world_input.h"
#include "sim/splinters/splinter_pattern.h"
