#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace griffith::ui {

/// Key codes in GLFW's numbering; letters and digits are their ASCII codes.
namespace key {
inline constexpr int kNone = 0, kSpace = 32, kEscape = 256, kEnter = 257, kTab = 258, kBackspace = 259, kDelete = 261,
                     kRight = 262, kLeft = 263, kDown = 264, kUp = 265, kHome = 268, kEnd = 269, kF1 = 290, kF12 = 301;
inline constexpr int kLeftShift = 340, kLeftControl = 341, kLeftAlt = 342, kLeftSuper = 343;
inline constexpr int kRightShift = 344, kRightControl = 345, kRightAlt = 346, kRightSuper = 347;
inline constexpr int kFirstModifier = kLeftShift, kLastModifier = kRightSuper;
}  // namespace key

/// A key with its modifiers.
struct Shortcut {
  int key = key::kNone;
  bool ctrl = false, shift = false, alt = false;
  bool operator==(const Shortcut&) const = default;
};

/// Returns the text of a shortcut: "Ctrl+Shift+Z"; empty if there is none.
std::string shortcut_text(const Shortcut& shortcut);
/// Parses such a text; empty if it names no key.
std::optional<Shortcut> shortcut_from_text(std::string_view text);

}  // namespace griffith::ui
