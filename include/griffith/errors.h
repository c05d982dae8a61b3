#pragma once

// Errors of input, cancelling of long work, number of threads, temporary folders.

#include "sim/core/error.h"
#include "sim/core/monitor.h"
#include "sim/core/parallel.h"
#include "sim/core/temporary_folder.h"
#include "sim/core/termination_hold.h"
