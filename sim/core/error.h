#pragma once

#include <stdexcept>
#include <string>

namespace griffith {

/// Mistake of a user, in a file, a field, a value or a mesh. `where` names the place (file, file:line or
/// file#/json/pointer), `problem` says what is wrong, `remedy` says what would be right. The program keeps its state.
/// Mistakes of programmers are asserts, numerical problems are counted in the step report.
class InputError : public std::runtime_error {
 public:
  InputError(std::string where, std::string problem, std::string remedy)
      : std::runtime_error(where + ": " + problem + (remedy.empty() ? "" : " (" + remedy + ")")),
        where_(std::move(where)),
        problem_(std::move(problem)),
        remedy_(std::move(remedy)) {}

  const std::string& where() const { return where_; }
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }

 private:
  std::string where_, problem_, remedy_;
};

}  // namespace griffith
