#pragma once

#include <functional>
#include <iterator>
#include <map>
#include <vector>

namespace griffith::app {

/// How things stand at a value of a parameter: numbers that are equal where nothing changes.
using State = std::vector<int>;
using StateAt = std::function<std::vector<State>(const std::vector<double>& values)>;

/// Two values, next to each other among all that were tried.
struct Bracket {
  double below = 0, above = 0;
};

/// How narrowly to search.
struct FlipSearch {
  bool geometric = false;    ///< intervals are parted by the ratio of their ends, which are > 0
  bool whole = false;        ///< values are whole numbers
  double tolerance = 0.01;   ///< of a flip: its width over the value where geometric, else over the whole range
  int values_at_a_time = 1;  ///< that are tried to part an interval, >= 1
  std::size_t most_values = 200;
};

/// The value at `fraction` (0..1) of the way from `low` to `high`.
double value_between(const FlipSearch& search, double low, double high, double fraction);

/// Tries `values` (ascending, two at least), then parts the intervals at whose ends the state differs, until they are
/// narrow or `most_values` are tried. What comes and goes within an interval may pass unseen. Throws what `state`
/// throws.
std::map<double, State> search_flips(const FlipSearch& search, const std::vector<double>& values, const StateAt& state);

/// Where neighbours differ.
template <class T>
std::vector<Bracket> flips_among(const std::map<double, T>& tried) {
  std::vector<Bracket> flips;
  for (auto at = tried.begin(); at != tried.end() && std::next(at) != tried.end(); ++at)
    if (const auto next = std::next(at); at->second != next->second) flips.push_back({at->first, next->first});
  return flips;
}

/// Widens from `start` > 0 by factors of two, both ways at once, until the state differs from that at the start, at
/// most `doublings` times and only as far as `allowed` says (a value may be tried again). Returns all values tried,
/// ascending.
std::vector<double> widened_until_flip(double start, int doublings, const std::function<bool(double)>& allowed,
                                       const StateAt& state);

}  // namespace griffith::app
