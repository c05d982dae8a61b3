#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/world/state_hashes.h"

namespace griffith {

/// A row a step, the first is step 0: its number and the hashes in hexadecimal, below the names of kStateFields.
std::string hashes_to_csv(const std::vector<StateHashes>& hashes);

/// Reads that back. `where` names the text in errors, `program` what wrote it. Throws InputError where it has other
/// columns, a row is damaged or out of order, and where there is none.
std::vector<StateHashes> hashes_from_csv(std::string_view text, const std::string& where, const std::string& program);

}  // namespace griffith
