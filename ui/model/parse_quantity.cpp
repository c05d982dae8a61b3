#include <charconv>
#include <cmath>

#include "ui/model/units.h"

namespace griffith::ui {
namespace {

/// A number, and whether a unit stood behind it: then it is in the unit without prefix.
struct Term {
  double value = 0;
  bool has_unit = false;
};

/// A sum of products of numbers with and without units:
///   sum = product {(+ | -) product}     product = factor {(* | /) factor}
///   factor = (+ | -) factor | (number | "(" sum ")") [unit]
class Expression {
 public:
  Expression(std::string_view text, std::string_view unit, const SiPrefix& bare)
      : rest_(text), unit_(unit), bare_(bare) {}

  std::optional<double> value() {
    const Term all = sum();
    skip_blanks();
    if (failed_ || !rest_.empty()) return std::nullopt;
    const double result = in_unit(all);
    return std::isfinite(result) ? std::optional(result) : std::nullopt;
  }

 private:
  Term sum() {
    Term left = product();
    while (!failed_) {
      const char sign = next_of("+-");
      if (!sign) break;
      const Term right = product();
      const bool has_unit = left.has_unit || right.has_unit;
      const double a = has_unit ? in_unit(left) : left.value, b = has_unit ? in_unit(right) : right.value;
      left = {sign == '+' ? a + b : a - b, has_unit};
    }
    return left;
  }

  Term product() {
    Term left = factor();
    while (!failed_) {
      const char sign = next_of("*/");
      if (!sign) break;
      const Term right = factor();
      if (sign == '*') {
        failed_ |= left.has_unit && right.has_unit;  // an area is no length
        left = {left.value * right.value, left.has_unit || right.has_unit};
      } else {
        failed_ |= right.has_unit && !left.has_unit;
        left = {left.value / right.value, left.has_unit && !right.has_unit};
      }
    }
    return left;
  }

  Term factor() {
    if (const char sign = next_of("+-")) {
      const Term of = factor();
      return {sign == '-' ? -of.value : of.value, of.has_unit};
    }
    Term found;
    if (next_of("(")) {
      found = sum();
      failed_ |= !next_of(")");
    } else {
      found.value = number();
    }
    const double factor = unit_factor();
    if (factor == 0) return found;
    failed_ |= found.has_unit;  // "(1 m) m"
    return {found.value * factor, true};
  }

  double number() {
    skip_blanks();
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    failed_ |= error != std::errc();
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  /// Takes the longest unit that stands here, with or without prefix, or a prefix alone; 0 where there is none.
  double unit_factor() {
    skip_blanks();
    std::size_t longest = 0;
    double factor = 0;
    const auto offer = [&](const std::string& symbol, double of_symbol) {
      if (symbol.size() <= longest || !rest_.starts_with(symbol)) return;
      longest = symbol.size();
      factor = of_symbol;
    };
    offer(std::string(unit_), 1);
    if (takes_prefix(unit_))
      for (const SiPrefix& prefix : si_prefixes())
        for (const std::string& symbol : {std::string(prefix.symbol), std::string(prefix.symbol == "µ" ? "u" : "")}) {
          if (symbol.empty()) continue;
          offer(symbol + std::string(unit_), prefix.factor);
          offer(symbol, prefix.factor);
        }
    rest_.remove_prefix(longest);
    return factor;
  }

  double in_unit(const Term& term) const { return term.has_unit ? term.value : term.value * bare_.factor; }

  /// Takes the next character where it is one of these; 0 where it is not.
  char next_of(std::string_view characters) {
    skip_blanks();
    if (failed_ || rest_.empty() || characters.find(rest_.front()) == std::string_view::npos) return 0;
    const char found = rest_.front();
    rest_.remove_prefix(1);
    return found;
  }

  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) rest_.remove_prefix(1);
  }

  std::string_view rest_, unit_;
  SiPrefix bare_;
  bool failed_ = false;
};

}  // namespace

std::optional<double> parse_quantity(std::string_view text, std::string_view unit, const SiPrefix& bare) {
  return Expression(text, unit, bare).value();
}

}  // namespace griffith::ui
