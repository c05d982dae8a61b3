#include "ui/model/shortcut.h"

#include <algorithm>
#include <array>
#include <utility>

namespace griffith::ui {
namespace {

constexpr std::array<std::pair<int, std::string_view>, 12> kKeyNames = {{
    {key::kSpace, "Space"},
    {key::kEscape, "Escape"},
    {key::kEnter, "Enter"},
    {key::kTab, "Tab"},
    {key::kBackspace, "Backspace"},
    {key::kDelete, "Delete"},
    {key::kRight, "Right"},
    {key::kLeft, "Left"},
    {key::kDown, "Down"},
    {key::kUp, "Up"},
    {key::kHome, "Home"},
    {key::kEnd, "End"},
}};

bool is_character_key(char letter) {
  return (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') || letter == ',' || letter == '.';
}

std::string key_name(int key) {
  if (key >= key::kF1 && key <= key::kF12) return "F" + std::to_string(key - key::kF1 + 1);
  const auto named = std::ranges::find(kKeyNames, key, &std::pair<int, std::string_view>::first);
  return named == kKeyNames.end() ? std::string(1, static_cast<char>(key)) : std::string(named->second);
}

std::optional<int> key_of_name(std::string_view name) {
  if (name.size() == 1 && is_character_key(name[0])) return name[0];
  for (int key = key::kF1; key <= key::kF12; ++key)
    if (key_name(key) == name) return key;
  const auto named = std::ranges::find(kKeyNames, name, &std::pair<int, std::string_view>::second);
  return named == kKeyNames.end() ? std::nullopt : std::optional(named->first);
}

/// Removes `modifier` from the start of the text. True if it was there.
bool cut_modifier(std::string_view& text, std::string_view modifier) {
  if (!text.starts_with(modifier)) return false;
  text.remove_prefix(modifier.size());
  return true;
}

}  // namespace

std::string shortcut_text(const Shortcut& shortcut) {
  if (shortcut.key == key::kNone) return {};
  return std::string(shortcut.ctrl ? "Ctrl+" : "") + (shortcut.alt ? "Alt+" : "") + (shortcut.shift ? "Shift+" : "") +
         key_name(shortcut.key);
}

std::optional<Shortcut> shortcut_from_text(std::string_view text) {
  Shortcut shortcut;
  shortcut.ctrl = cut_modifier(text, "Ctrl+");
  shortcut.alt = cut_modifier(text, "Alt+");
  shortcut.shift = cut_modifier(text, "Shift+");
  const std::optional<int> key = key_of_name(text);
  if (!key) return std::nullopt;
  shortcut.key = *key;
  return shortcut;
}

}  // namespace griffith::ui
