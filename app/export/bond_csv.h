#pragma once

#include <string>

#include "app/bake/bake.h"

namespace griffith::app {

/// The bonds of a bake as CSV, a row each: names of the pieces, area, center, normal, strength, break time (empty where
/// there is none); SI units.
std::string bond_csv(const Bake& bake);

}  // namespace griffith::app
