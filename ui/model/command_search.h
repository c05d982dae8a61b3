#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ui/model/commands.h"

namespace griffith::ui {

/// How well the letters of `wanted` are found in `text`, in their order and whatever their case; more is better, most
/// where they begin words or follow each other. Nothing where one is missing.
std::optional<int> match_score(std::string_view text, std::string_view wanted);

/// The commands of menus that match in their title, menu or help, best first; all where nothing is wanted.
std::vector<const CommandInfo*> matching_commands(std::string_view wanted);

}  // namespace griffith::ui
