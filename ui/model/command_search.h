#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ui/model/commands.h"

namespace griffith::ui {

/// Scores how well the letters of `query` occur in `text`, in order and in any case. Higher is better; letters that
/// begin words or are adjacent score most. Empty if a letter is missing.
std::optional<int> match_score(std::string_view text, std::string_view query);

/// Returns the menu commands whose title, menu or help matches, best first; all commands if `query` is empty.
std::vector<const CommandInfo*> matching_commands(std::span<const CommandInfo> commands, std::string_view query);

}  // namespace griffith::ui
