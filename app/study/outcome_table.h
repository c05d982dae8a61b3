#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/sweep.h"

namespace griffith::app {

/// Returns the outcomes of all finished runs as CSV (RFC 4180): the run's number, its parameters, outcome_kinds() and
/// the error. Numbers are the shortest that read back as the same double; infinite ones are left empty.
std::string outcome_csv(const Sweep& sweep, const std::vector<std::optional<RunRecord>>& records);

}  // namespace griffith::app
