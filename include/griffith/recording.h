#pragma once

// Recordings of runs, and their replay.

#include "sim/recording/file_tree.h"
#include "sim/recording/recording.h"
#include "sim/recording/replay.h"
#include "sim/recording/versions.h"
