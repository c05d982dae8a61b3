#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/world/state/state_hashes.h"

namespace griffith {

/// Returns one row per step, starting with step 0: its number and its hashes in hexadecimal, below a heading of
/// kStateFields.
std::string hashes_to_csv(const std::vector<StateHashes>& hashes);

/// Reads such a table. `where` names the text in errors, `program` the version that wrote it. Throws InputError for
/// other columns, for rows that are damaged, out of order or missing.
std::vector<StateHashes> hashes_from_csv(std::string_view text, const std::string& where, const std::string& program);

}  // namespace griffith
