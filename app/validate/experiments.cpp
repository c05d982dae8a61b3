#include <vector>

#include "app/validate/experiment.h"

namespace griffith::app {

AcceptedRange around(double value, double fraction) { return {(1 - fraction) * value, (1 + fraction) * value}; }

std::span<const Experiment> experiments() {
  static const std::vector<Experiment> kExperiments = {crack_in_a_strip(), notched_beam(), center_cracked_plate(),
                                                       zener_plate(), ball_on_plate()};
  return kExperiments;
}

}  // namespace griffith::app
