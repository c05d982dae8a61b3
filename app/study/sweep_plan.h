#pragma once

#include <cstdint>
#include <vector>

#include "app/study/parameter.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// The runs of a sweep: which value each parameter has in each.
struct SweepPlan {
  std::vector<Parameter> parameters;
  std::vector<std::vector<std::string>> runs;  ///< JSON texts, one a parameter
};

/// Points in the unit cube of `dimensions`, uniformly random but for this: along each axis every one of `samples` equal
/// intervals has exactly one. The same on every machine.
std::vector<std::vector<double>> latin_hypercube(int samples, std::size_t dimensions, std::uint64_t seed);

/// All combinations of the parameters' values, the last parameter changing fastest. Where `samples` > 0, those with a
/// range and no count take their values together from a Latin hypercube of so many. Throws InputError for a range that
/// says no count without that, a field that comes twice, and more runs than a sweep may have.
SweepPlan make_plan(std::vector<Parameter> parameters, int samples, std::uint64_t seed);

/// The parameter "seed" with values 1 to `count`, for the random strength of every body that has one. Throws InputError
/// where none has.
Parameter seed_parameter(const Scene& scene, int count);

}  // namespace griffith::app
