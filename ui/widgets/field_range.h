#pragma once

#include <cassert>
#include <string_view>

#include "sim/scene/scene_fields.h"

namespace griffith::ui {

/// Archive for describe() that finds the accepted range of a number.
struct RangeFinder {
  std::string_view searched;
  Numbers found = {};

  template <class T>
  void field(std::string_view name, T&, const Numbers& numbers, std::string_view) {
    if (name == searched) found = numbers;
  }
  template <class T, class Values>
  void field(std::string_view, T&, const Values&, std::string_view) {}
  template <class Fixed, class... Anything>
  void alternative(Anything&&...) {}
  void require(bool, std::string_view, const char*, const char*) {}
};

/// Returns the range that scene files accept for the field `name` of a T, so that panels accept the same.
template <class T>
Numbers range_of(std::string_view name) {
  T value;
  RangeFinder finder{name};
  describe(finder, value);
  assert(finder.found.minimum < finder.found.maximum);
  return finder.found;
}

}  // namespace griffith::ui
