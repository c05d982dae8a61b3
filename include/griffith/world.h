#pragma once

// Worlds, which make steps, and their past.

#include "sim/timeline/timeline.h"
#include "sim/world/world.h"
