#pragma once

// Worlds, which make steps, and their past.

#include "sim/timeline/microstep_recording.h"
#include "sim/timeline/timeline.h"
#include "sim/world/world.h"
