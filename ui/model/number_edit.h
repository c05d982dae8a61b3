#pragma once

#include <array>
#include <string>

#include "ui/model/units.h"

namespace griffith::ui {

/// The number field that is held with the mouse or typed into: one at a time.
struct NumberEdit {
  enum class Kind { none, held, dragged, typed };
  Kind kind = Kind::none;
  std::string tag = {};             ///< of the field
  double start = 0;                 ///< its value when the edit began
  SiPrefix prefix = {};             ///< in which it shows values as long as the edit goes on
  double moved = 0;                 ///< by the mouse since the drag began [pixels, times the pace's factor]
  std::array<char, 128> text = {};  ///< as typed so far
  std::string opened_text = {};     ///< with which typing began
  double opened_time = 0;           ///< [s]
  int opened_frame = 0, drawn_frame = 0;

  bool is_of(const std::string& field) const { return kind != Kind::none && tag == field; }
};

}  // namespace griffith::ui
