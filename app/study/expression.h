#pragma once

#include <string>
#include <vector>

#include "app/output/outcome.h"
#include "sim/scene/scene_setting.h"

namespace griffith::app {

/// Relation of an outcome to a number or a range.
enum class Relation { less, less_equal, greater, greater_equal, equal, not_equal, within };

struct Comparison {
  std::size_t outcome = 0;  ///< index into outcome_kinds()
  Relation relation = Relation::greater;
  double low = 0, high = 0;  ///< `high` only for `within`, whose ends are included

  bool holds(const Outcomes& outcomes) const;
};

/// Condition on a run: all comparisons hold.
struct Expression {
  std::string text;
  std::vector<Comparison> comparisons;

  bool holds(const Outcomes& outcomes) const;
};

/// Parses an expression such as "pieces > 1, largest_piece in 0.1:0.5". Throws InputError, which names `where` and the
/// position in the text.
Expression read_expression(const std::string& text, const std::string& where);

/// An expression about runs with some changed values of the scene.
struct Condition {
  std::string text;
  std::vector<SceneSetting> settings;
  Expression expression;
};

/// Parses "POINTER=VALUE, POINTER=VALUE: EXPRESSION" or "EXPRESSION". Throws InputError as read_expression().
Condition read_condition(const std::string& text, const std::string& where);

}  // namespace griffith::app
