#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>

namespace griffith::app {

/// Breaks text at blanks into lines of at most `width` bytes, except for longer words. Lines after the first begin with
/// `indent`.
std::string wrapped(const std::string& text, std::size_t width, const std::string& indent = "");

/// Format of --help: descriptions in a column, and options without the list of those that they exclude or need.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace griffith::app
