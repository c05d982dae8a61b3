#pragma once

#include <map>
#include <string>

#include "app/validate/judgment.h"

namespace griffith::app {

/// Part of the scorecard about one experiment, as Markdown.
struct ScorecardEntry {
  std::string row;      ///< line of the table at the top, without its end
  std::string section;  ///< heading, description, result and table

  bool operator==(const ScorecardEntry&) const = default;
};

/// Entries by key of their experiment.
using Scorecard = std::map<std::string, ScorecardEntry>;

/// Writes the entry of a judged experiment.
ScorecardEntry scorecard_entry(const Experiment& experiment, const Judgment& judgment);

/// Returns the page with these entries in the order of experiments().
std::string scorecard_page(const Scorecard& scorecard);

/// Returns the entries of a page of scorecard_page(); none for other text.
Scorecard read_scorecard(const std::string& page);

}  // namespace griffith::app
