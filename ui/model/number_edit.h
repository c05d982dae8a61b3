#pragma once

#include <array>
#include <string>

#include "ui/model/units.h"

namespace griffith::ui {

/// The number field being dragged or typed into; at most one.
struct NumberEdit {
  enum class Kind { none, held, dragged, typed };
  Kind kind = Kind::none;
  std::string tag = {};             ///< tag of the field
  double start = 0;                 ///< value at the start of the edit
  SiPrefix prefix = {};             ///< prefix of shown values during the edit
  double moved = 0;                 ///< motion of the mouse since the drag began [pixels, times the pace's factor]
  std::array<char, 128> text = {};  ///< typed text
  std::string opened_text = {};     ///< text at the start of typing
  double opened_time = 0;           ///< [s]
  int opened_frame = 0, drawn_frame = 0;

  bool is_of(const std::string& field) const { return kind != Kind::none && tag == field; }
};

/// Prefix of the number that was typed last, for the next one of its row.
struct KeptUnit {
  std::string tag = {};  ///< tag of the field
  SiPrefix prefix = {};
  int frame = 0;
};

}  // namespace griffith::ui
