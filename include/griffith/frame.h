#pragma once

// State of a world after a step, and what follows from it: quantities, reports on nodes, energies, probes.

#include "sim/world/energy/energy_account.h"
#include "sim/world/output/frame.h"
#include "sim/world/output/node_report.h"
#include "sim/world/output/probes.h"
#include "sim/world/output/quantity_values.h"
#include "sim/world/output/scaled_breaks.h"
