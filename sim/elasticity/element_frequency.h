#pragma once

#include <span>
#include <vector>

#include "sim/elasticity/element.h"

namespace griffith {

/// Highest frequency of each element with a quarter of its mass at each corner [rad/s]. `density`: [kg/m³].
std::vector<double> element_frequencies(const ElasticLaw& law, double density,
                                        std::span<const RestElement> rest_elements);

/// Frequencies that elements of a body keep at most, so that a few do not set the microstep of all [rad/s].
struct FrequencyLimits {
  double usual = 0;  ///< for slivers alone: 2 % of the elements lie above it at most
  double least = 0;  ///< where the budget falls short: 2 % of the elements and 0.1 % of the volume at most
};

/// Limits for a body with these elements. `density`: [kg/m³].
FrequencyLimits frequency_limits(const ElasticLaw& law, double density, std::span<const RestElement> rest_elements);

}  // namespace griffith
