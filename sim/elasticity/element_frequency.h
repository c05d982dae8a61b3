#pragma once

#include <span>
#include <vector>

#include "sim/elasticity/element.h"

namespace griffith {

/// Highest frequency of each element with a quarter of its mass at each corner [rad/s]. `density`: [kg/m³].
std::vector<double> element_frequencies(const ElasticLaw& law, double density,
                                        std::span<const RestElement> rest_elements);

/// Highest frequency that elements of a body keep, so that its worst slivers, 2 % of them at most, do not set the
/// microstep of all [rad/s]. `density`: [kg/m³].
double highest_frequency(const ElasticLaw& law, double density, std::span<const RestElement> rest_elements);

}  // namespace griffith
