#pragma once

#include <cstdint>
#include <vector>

#include "app/study/parameter.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// Runs of a sweep with the values of their parameters.
struct SweepPlan {
  std::vector<Parameter> parameters;
  std::vector<std::vector<std::string>> runs;  ///< JSON texts, one for each parameter
};

/// Returns points in the unit cube of `dimensions`, uniformly random with exactly one point in each of `samples` equal
/// intervals along each axis. The same on every machine.
std::vector<std::vector<double>> latin_hypercube(int samples, std::size_t dimensions, std::uint64_t seed);

/// Returns all combinations of the parameters' values, the last parameter changing fastest. If `samples` > 0, those
/// with a range and no count take their values together from a Latin hypercube of that size. Throws InputError for a
/// range without a count if there is none, a repeated field, and more runs than a sweep may have.
SweepPlan make_plan(std::vector<Parameter> parameters, int samples, std::uint64_t seed);

/// Returns the parameter "seed" with values 1 to `count`, for the random strength of every body that has one. Throws
/// InputError if none has.
Parameter seed_parameter(const Scene& scene, int count);

}  // namespace griffith::app
