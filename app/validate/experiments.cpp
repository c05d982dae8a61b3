#include <vector>

#include "app/validate/experiment.h"

namespace griffith::app {

AcceptedRange around(double value, double fraction) { return {(1 - fraction) * value, (1 + fraction) * value}; }

std::span<const Experiment> experiments() {
  static const std::vector<Experiment> kExperiments = {
      uniaxial_tension(),       biaxial_tension(), hydrostatic_tension(), torsion(),
      crack_in_a_strip(),       edge_notch(),      notched_beam(),        center_cracked_plate(),
      double_cantilever_beam(), plate_with_hole(), brazilian_disc(),      spalling_bar(),
      ring_fragmentation(),     branching_plate(), kalthoff_winkler(),    zener_plate(),
      ball_on_plate()};
  return kExperiments;
}

}  // namespace griffith::app
