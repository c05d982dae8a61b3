#pragma once

#include <functional>
#include <iterator>
#include <map>
#include <vector>

namespace griffith::app {

/// State at a value of a parameter: numbers that are equal if nothing changes.
using State = std::vector<int>;
using StateAt = std::function<std::vector<State>(const std::vector<double>& values)>;

/// Returns the states 1 and 0 of a condition that holds or not. Each value is tried once.
StateAt states_of(const std::function<bool(double)>& holds);

/// Two adjacent tried values.
struct Bracket {
  double below = 0, above = 0;
};

/// Settings of a search.
struct FlipSearch {
  bool geometric = false;    ///< intervals are divided by the ratio of their ends, which are > 0
  bool whole = false;        ///< values are integers
  double tolerance = 0.01;   ///< width of a flip relative to its value if geometric, else to the whole range
  int values_at_a_time = 1;  ///< values tried at once to divide an interval, >= 1
  std::size_t most_values = 200;
};

/// Returns the value at `fraction` (0..1) between `low` and `high`.
double value_between(const FlipSearch& search, double low, double high, double fraction);

/// Tries `values` (ascending, not none), then divides the intervals between different states until they are narrow
/// or `most_values` are tried. A state within an interval may go unseen. Rethrows exceptions of `state`.
std::map<double, State> search_flips(const FlipSearch& search, const std::vector<double>& values, const StateAt& state);

/// Returns the brackets between different adjacent states.
template <class T>
std::vector<Bracket> flips_among(const std::map<double, T>& tried) {
  std::vector<Bracket> flips;
  for (auto at = tried.begin(); at != tried.end() && std::next(at) != tried.end(); ++at)
    if (const auto next = std::next(at); at->second != next->second) flips.push_back({at->first, next->first});
  return flips;
}

/// Widens from `start` > 0 by factors of two in both directions until the state differs from that at the start, at most
/// `doublings` times and only to values that `allowed` accepts (a value may be tried again). Returns all tried values,
/// ascending.
std::vector<double> widened_until_flip(double start, int doublings, const std::function<bool(double)>& allowed,
                                       const StateAt& state);

}  // namespace griffith::app
