#pragma once

#include <string>

#include "app/output/outcome.h"

namespace griffith::app {

/// Result of a run: its outcomes, or an error.
struct RunRecord {
  Outcomes outcomes;
  std::string error;  ///< empty: completed
};

/// Returns the record as a JSON object: `outcomes` by their keys, null if infinite; or `error`.
std::string record_json(const RunRecord& record);

/// Parses a record. Throws InputError, which names `where`, for texts that record_json() does not write.
RunRecord record_from_json(const std::string& text, const std::string& where);

}  // namespace griffith::app
