#include "app/validate/judgment.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/core/number_text.h"

namespace griffith::app {
namespace {

/// Distance of a value from its accepted range, over the nearer end of the range. Infinite for NaN.
double excess(const AcceptedRange& accepted, double value) {
  if (std::isnan(value)) return std::numeric_limits<double>::infinity();
  if (accepted.contains(value)) return 0;
  const double end = value < accepted.low ? accepted.low : accepted.high;
  return std::abs(value - end) / std::max(std::abs(end), 1e-9);
}

std::vector<Measurement> measure(const Experiment& experiment,
                                 const std::function<void(const std::string& mesh)>& announce) {
  std::vector<Measurement> measurements;
  for (std::size_t mesh = 0; mesh < experiment.meshes.size(); ++mesh) {
    announce(experiment.meshes[mesh]);
    const std::vector<Reading> readings = experiment.run(static_cast<int>(mesh));
    measurements.resize(readings.size());
    for (std::size_t i = 0; i < readings.size(); ++i) {
      if (mesh == 0) measurements[i].reading = readings[i];
      measurements[i].values.push_back(readings[i].value);
    }
  }
  return measurements;
}

/// Counts values outside their range and describes the worst.
void judge_values(const Experiment& experiment, Judgment& judgment) {
  double worst = 0;
  for (const Measurement& measurement : judgment.measurements)
    for (std::size_t mesh = 0; mesh < measurement.values.size(); ++mesh) {
      const double value = measurement.values[mesh], beyond = excess(measurement.reading.accepted, value);
      if (beyond > 0) ++judgment.outside;
      if (beyond <= worst) continue;
      worst = beyond;
      judgment.worst = measurement.reading.quantity + " is " +
                       (std::isnan(value) ? "unknown" : rounded_text(value, 3)) + " (" + measurement.reading.variant +
                       ", " + experiment.meshes[mesh] + ")";
    }
}

/// Counts quantities with too large a spread and adds the worst.
void judge_spreads(Judgment& judgment) {
  double worst = 0;
  std::string text;
  std::set<std::string> seen;
  for (const auto& [reading, values] : judgment.measurements) {
    if (reading.largest_spread == 0 || !seen.insert(reading.quantity).second) continue;
    const double spread = spread_of(judgment.measurements, reading.quantity);
    if (spread > reading.largest_spread) ++judgment.spread_out;
    if (spread > std::max(worst, reading.largest_spread)) {
      worst = spread;
      text = reading.quantity + " varies by ± " + percent_text(spread);
    }
  }
  if (!text.empty()) judgment.worst += (judgment.worst.empty() ? "" : "; ") + text;
}

}  // namespace

std::string percent_text(double fraction) { return rounded_text(std::round(1000 * fraction) / 10, 3) + " %"; }

double spread_of(const std::vector<Measurement>& measurements, const std::string& quantity) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& [reading, values] : measurements) {
    if (reading.quantity != quantity) continue;
    for (const double value : values) {
      if (std::isnan(value)) return value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return high == low ? 0 : (high - low) / (std::abs(high) + std::abs(low));
}

Judgment judge(const Experiment& experiment, const std::function<void(const std::string& mesh)>& announce) {
  Judgment judgment;
  judgment.measurements = measure(experiment, announce);
  judge_values(experiment, judgment);
  judge_spreads(judgment);
  return judgment;
}

}  // namespace griffith::app
