#pragma once

#include <string>
#include <vector>

namespace griffith::app {

/// Parses time steps: "60", "0,30,60", "0:240:10" (from, to and including, stride; 1 if left out), or several of these
/// joined by commas. Returns them ascending without duplicates. Throws InputError, naming `where`, for other text and
/// for more than ten million steps.
std::vector<int> frames_from_text(const std::string& text, const std::string& where);

}  // namespace griffith::app
