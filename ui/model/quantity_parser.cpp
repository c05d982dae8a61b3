#include "ui/model/quantity_parser.h"

#include <charconv>
#include <cmath>

namespace griffith::ui {
namespace {

/// An intermediate value of the expression.
struct Term {
  double value = 0;
  bool has_unit = false;
};

/// Returns `number` times a unit's factor, correctly rounded: 9 mm is the double nearest to 0.009.
double times(double number, double factor) {
  const double inverse = std::round(1 / factor);
  return factor < 1 && std::abs(inverse * factor - 1) < 1e-12 ? number / inverse : number * factor;
}

class QuantityParser {
 public:
  QuantityParser(std::string_view text, std::string_view unit, double shown)
      : text_(text), unit_(unit), shown_(shown) {}

  std::optional<double> result() {
    const Term all = sum();
    skip_blanks();
    const double value = in_unit(all);
    if (failed_ || !text_.empty() || !std::isfinite(value)) return std::nullopt;
    return value;
  }

  /// Returns the only unit of the expression if it stands at its end.
  std::optional<UnitSpelling> only_unit() const {
    return units_ == 1 && ends_with_unit_ ? std::optional(last_unit_) : std::nullopt;
  }

 private:
  double in_unit(const Term& term) const { return term.has_unit ? term.value : times(term.value, shown_); }

  void skip_blanks() {
    const std::size_t first = text_.find_first_not_of(" \t");
    text_.remove_prefix(first == std::string_view::npos ? text_.size() : first);
  }

  bool take(char symbol) {
    skip_blanks();
    if (!text_.starts_with(symbol)) return false;
    text_.remove_prefix(1);
    return true;
  }

  Term fail() {
    failed_ = true;
    return {};
  }

  Term sum() {
    Term left = product();
    while (!failed_) {
      const bool plus = take('+');
      if (!plus && !take('-')) return left;
      const Term right = product();
      const double sign = plus ? 1 : -1;
      if (left.has_unit || right.has_unit) {
        left = {in_unit(left) + sign * in_unit(right), true};
      } else {
        left.value += sign * right.value;
      }
    }
    return {};
  }

  Term product() {
    Term left = factor();
    while (!failed_) {
      const bool times = take('*');
      if (!times && !take('/')) return left;
      const Term right = factor();
      if (times && left.has_unit && right.has_unit) return fail();
      if (!times && right.has_unit && !left.has_unit) return fail();
      left = times ? Term{left.value * right.value, left.has_unit || right.has_unit}
                   : Term{left.value / right.value, left.has_unit && !right.has_unit};
    }
    return {};
  }

  Term factor() {
    const bool negative = take('-');
    if (!negative) take('+');
    Term term = take('(') ? group() : number();
    skip_blanks();
    const UnitSpelling unit = unit_at(text_, unit_);
    if (unit.length > 0) {
      if (term.has_unit) return fail();
      text_.remove_prefix(unit.length);
      skip_blanks();
      last_unit_ = unit;
      ends_with_unit_ = text_.empty();
      ++units_;
      term = {times(term.value, unit.factor), true};
    }
    if (negative) term.value = -term.value;
    return term;
  }

  Term group() {
    const Term inner = sum();
    return take(')') ? inner : fail();
  }

  Term number() {
    skip_blanks();
    const bool is_number = !text_.empty() && (text_[0] == '.' || (text_[0] >= '0' && text_[0] <= '9'));
    if (!is_number) return fail();
    Term term;
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), term.value);
    if (error != std::errc()) return fail();
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return term;
  }

  std::string_view text_, unit_;
  double shown_;
  bool failed_ = false;
  int units_ = 0;
  bool ends_with_unit_ = false;
  UnitSpelling last_unit_;
};

}  // namespace

std::optional<double> parse_quantity(std::string_view text, std::string_view unit, const SiPrefix& shown) {
  QuantityParser parser(text, unit, shown.factor);
  const std::optional<double> value = parser.result();
  const std::optional<UnitSpelling> only_unit = parser.only_unit();
  if (!only_unit) return value;
  while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
  text.remove_suffix(only_unit->length);
  return QuantityParser(text, unit, only_unit->factor).result();
}

}  // namespace griffith::ui
