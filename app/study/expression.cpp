#include "app/study/expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "app/study/parameter.h"
#include "sim/core/error.h"

namespace griffith::app {
namespace {

struct Operator {
  std::string_view text;
  Relation relation;
};

/// Longer ones first: "<=" begins with "<".
constexpr std::array kOperators = {Operator{"<=", Relation::less_equal}, Operator{">=", Relation::greater_equal},
                                   Operator{"==", Relation::equal},      Operator{"!=", Relation::not_equal},
                                   Operator{"<", Relation::less},        Operator{">", Relation::greater},
                                   Operator{"in ", Relation::within}};

constexpr std::string_view kNameCharacters = "abcdefghijklmnopqrstuvwxyz0123456789_.";

/// Parses comparisons from left to right.
class ExpressionReader {
 public:
  ExpressionReader(std::string_view text, const std::string& where) : text_(text), rest_(text), where_(where) {}

  std::vector<Comparison> comparisons() {
    std::vector<Comparison> comparisons;
    do comparisons.push_back(comparison());
    while (take(","));
    if (!rest_.empty()) refuse("a comma or the end");
    return comparisons;
  }

 private:
  Comparison comparison() {
    skip_spaces();
    Comparison comparison;
    const std::string_view name = rest_.substr(0, rest_.find_first_not_of(kNameCharacters));
    if (name.empty()) refuse("the name of an outcome");
    comparison.outcome = outcome_index(name, where_);
    rest_.remove_prefix(name.size());
    comparison.relation = relation();
    comparison.low = number();
    if (comparison.relation != Relation::within) return comparison;
    if (!take(":")) refuse("a colon");
    comparison.high = number();
    if (comparison.high < comparison.low)
      throw InputError(where_, "\"" + std::string(text_) + "\" has a descending range",
                       "write the smaller number first");
    return comparison;
  }

  Relation relation() {
    for (const Operator& known : kOperators)
      if (take(known.text)) return known.relation;
    refuse("one of < <= > >= == != in");
  }

  double number() {
    skip_spaces();
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc()) refuse("a number");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  bool take(std::string_view what) {
    skip_spaces();
    if (!rest_.starts_with(what)) return false;
    rest_.remove_prefix(what.size());
    return true;
  }

  void skip_spaces() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  [[noreturn]] void refuse(const std::string& expected) {
    skip_spaces();
    const std::string place = rest_.empty() ? "at its end" : "before \"" + std::string(rest_) + "\"";
    throw InputError(where_, "\"" + std::string(text_) + "\" lacks " + expected + " " + place,
                     "write it as \"pieces > 1, largest_piece in 0.1:0.5\"");
  }

  std::string_view text_, rest_;
  const std::string& where_;
};

/// Returns the length of the settings at the start of `text`, up to their colon; 0 if it has none.
std::size_t settings_length(const std::string& text) {
  const std::size_t equals = text.find('='), colon = split_outside_brackets(text, ':').front().size();
  if (equals == std::string::npos || colon == text.size() || equals > colon) return 0;
  const bool comparison = text.substr(0, colon).find_first_of("<>!") != std::string::npos || text[equals + 1] == '=';
  return comparison ? 0 : colon;
}

std::vector<SceneSetting> read_condition_settings(const std::string& text, const std::string& where) {
  std::vector<SceneSetting> settings;
  for (std::string& setting : split_outside_brackets(text, ',')) {
    setting.erase(0, std::min(setting.find_first_not_of(' '), setting.size()));
    settings.push_back(read_setting(setting, where));
  }
  return settings;
}

}  // namespace

bool Comparison::holds(const Outcomes& outcomes) const {
  const double value = outcomes[outcome];
  switch (relation) {
    case Relation::less:
      return value < low;
    case Relation::less_equal:
      return value <= low;
    case Relation::greater:
      return value > low;
    case Relation::greater_equal:
      return value >= low;
    case Relation::equal:
      return value == low;
    case Relation::not_equal:
      return value != low;
    case Relation::within:
      return low <= value && value <= high;
  }
  return false;
}

bool Expression::holds(const Outcomes& outcomes) const {
  return std::ranges::all_of(comparisons, [&](const Comparison& part) { return part.holds(outcomes); });
}

Expression read_expression(const std::string& text, const std::string& where) {
  return {text, ExpressionReader(text, where).comparisons()};
}

Condition read_condition(const std::string& text, const std::string& where) {
  const std::size_t length = settings_length(text);
  if (length == 0) return {text, {}, read_expression(text, where)};
  std::string expression = text.substr(length + 1);
  expression.erase(0, std::min(expression.find_first_not_of(' '), expression.size()));
  return {text, read_condition_settings(text.substr(0, length), where), read_expression(expression, where)};
}

}  // namespace griffith::app
