#pragma once

#include <span>
#include <vector>

#include "sim/elasticity/element.h"

namespace griffith {

/// Returns the highest frequency of each element with a quarter of its mass at each corner [rad/s]. `density`: [kg/m³].
std::vector<double> element_frequencies(const ElasticLaw& law, double density,
                                        std::span<const RestElement> rest_elements);

/// Returns the highest frequency that elements of a body keep [rad/s], so that its worst slivers, at most 2 % of its
/// elements, do not limit the microstep. `density`: [kg/m³].
double highest_frequency(const ElasticLaw& law, double density, std::span<const RestElement> rest_elements);

}  // namespace griffith
