#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace griffith::app {

/// Closed range of accepted values.
struct AcceptedRange {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();

  bool contains(double value) const { return value >= low && value <= high; }
};

/// Returns the range from (1 − fraction) to (1 + fraction) times a value > 0.
AcceptedRange around(double value, double fraction);

/// A measured value of one mesh.
struct Reading {
  std::string quantity;    ///< the measured quantity, with its case: "load over handbook, a/W = 0.25"
  std::string variant;     ///< pattern or integrator; readings of one quantity are expected to agree
  AcceptedRange accepted;  ///< said before the run
  double value = 0;        ///< NaN: the experiment had no result
  /// Accepted half range of the quantity over all meshes and variants, over its middle; 0: not judged.
  double largest_spread = 0.15;
};

/// A published experiment or closed form that the program repeats.
struct Experiment {
  std::string key;                  ///< name on the command line: "strip"
  std::string title;                ///< heading on the page
  std::string source;               ///< author and year
  std::string measured;             ///< the specimen and the measured values, a sentence or more
  std::string acceptance;           ///< condition to pass, said before the run
  std::string cause = {};           ///< known cause of failure, shown if it fails; may be empty
  std::vector<std::string> meshes;  ///< element sizes, coarse to fine: "h = W/8"
  bool quick = false;               ///< true if all its meshes take a few seconds together
  /// Runs one mesh. Every mesh gives the same readings in the same order.
  std::function<std::vector<Reading>(int mesh)> run;
};

/// Returns all experiments in the order of the page.
std::span<const Experiment> experiments();

// Each makes one entry of experiments(), in a file of its subject.
Experiment crack_in_a_strip();
Experiment notched_beam();
Experiment center_cracked_plate();
Experiment zener_plate();
Experiment ball_on_plate();

}  // namespace griffith::app
