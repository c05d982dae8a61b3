#pragma once

#include <string>
#include <vector>

#include "app/output/outcome.h"
#include "sim/scene/scene_setting.h"

namespace griffith::app {

/// How an outcome compares with a number, or lies within two.
enum class Relation { less, less_equal, greater, greater_equal, equal, not_equal, within };

struct Comparison {
  std::size_t outcome = 0;  ///< index into outcome_kinds()
  Relation relation = Relation::greater;
  double low = 0, high = 0;  ///< `high` of `within` alone; both ends are within

  bool holds(const Outcomes& outcomes) const;
};

/// What is asked of a run: that all of some comparisons hold.
struct Expression {
  std::string text;
  std::vector<Comparison> comparisons;

  bool holds(const Outcomes& outcomes) const;
};

/// The expression in "pieces > 1, largest_piece in 0.1:0.5". Throws InputError, which names `where` and the place in
/// the text.
Expression read_expression(const std::string& text, const std::string& where);

/// An expression about the runs in which the scene has some other values.
struct Condition {
  std::string text;
  std::vector<SceneSetting> settings;
  Expression expression;
};

/// The condition in "POINTER=VALUE, POINTER=VALUE: EXPRESSION" or "EXPRESSION". Throws InputError as read_expression().
Condition read_condition(const std::string& text, const std::string& where);

}  // namespace griffith::app
