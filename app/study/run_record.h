#pragma once

#include <string>

#include "app/output/outcome.h"

namespace griffith::app {

/// What a run leaves behind: its outcomes, or why it has none.
struct RunRecord {
  Outcomes outcomes;
  std::string error;  ///< empty: it came to its end
};

/// The record as a JSON object: `outcomes` by their keys, null where infinite; or `error`.
std::string record_json(const RunRecord& record);

/// The record in `text`. Throws InputError, which names `where`, for what record_json() does not write.
RunRecord record_from_json(const std::string& text, const std::string& where);

}  // namespace griffith::app
