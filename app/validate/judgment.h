#pragma once

#include <string>
#include <vector>

#include "app/validate/experiment.h"

namespace griffith::app {

/// A reading on all meshes.
struct Measurement {
  Reading reading;             ///< reading of the coarsest mesh
  std::vector<double> values;  ///< by mesh
};

/// Result of an experiment.
struct Judgment {
  std::vector<Measurement> measurements;
  int outside = 0;     ///< values outside their accepted range
  int spread_out = 0;  ///< quantities whose spread is larger than accepted
  std::string worst;   ///< the worst value and the worst spread in words; empty if it passes

  bool passes() const { return outside == 0 && spread_out == 0; }
};

/// Returns half the range of a quantity over its middle, over all meshes and variants. NaN if a value is NaN, 0 if all
/// are 0.
double spread_of(const std::vector<Measurement>& measurements, const std::string& quantity);

/// Returns a fraction as percent, to a tenth of a percent and three digits: "12.5 %".
std::string percent_text(double fraction);

/// Runs an experiment on all its meshes and judges it. `announce` gets the name of each mesh before its run.
Judgment judge(const Experiment& experiment, const std::function<void(const std::string& mesh)>& announce);

}  // namespace griffith::app
