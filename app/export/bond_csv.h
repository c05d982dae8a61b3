#pragma once

#include <string>

#include "app/bake/bake.h"

namespace griffith::app {

/// Returns the bonds of a bake as CSV, one row each: names of the pieces, area, center, normal, strength, break time
/// (may be empty); SI units.
std::string bond_csv(const Bake& bake);

}  // namespace griffith::app
