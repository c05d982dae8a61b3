#include "app/cli/help_formatter.h"

#include <algorithm>
#include <sstream>

namespace griffith::app {

std::string wrapped(const std::string& text, std::size_t width, const std::string& indent) {
  std::string result;
  std::size_t used = 0;
  const auto add = [&](const std::string& part) {
    result += part;
    used += part.size();
  };
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (used > 0 && used + 1 + word.size() > width) {
      result += '\n';
      used = 0;
      add(indent);
    } else if (used > 0) {
      add(" ");
    }
    add(word);
  }
  return result;
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  const std::string text = CLI::Formatter::make_option_opts(option);
  return text.substr(0, std::min(text.find(" Excludes:"), text.find(" Needs:")));
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  constexpr std::size_t kWidth = 88;
  return wrapped(CLI::Formatter::make_option_desc(option), kWidth);
}

}  // namespace griffith::app
