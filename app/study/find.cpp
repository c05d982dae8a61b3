#include "app/study/find.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/shared/processes.h"
#include "app/shared/quantile.h"
#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/core/read_file.h"
#include "sim/core/temporary_folder.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

constexpr int kDoublings = 10;
constexpr char kParameter[] = "--parameter";

/// True if the scene can be read with this value.
bool is_allowed(const Find& find, double value) try {
  std::vector<SceneSetting> settings = find.settings;
  settings.push_back({find.pointer, number_text(value)});
  read_scene(find.definition.scene, settings);
  return true;
} catch (const InputError&) {
  return false;
}

/// Returns the scene's number in that field. Throws InputError if it is no number.
double present_value(const Find& find) {
  const std::string text = scene_value(find.definition.scene, find.pointer, find.settings);
  const std::optional<double> number = number_in(text);
  if (!number)
    throw InputError(kParameter, find.pointer + " is " + text + ", which is not a number", "name a numeric field");
  return *number;
}

/// True if the field accepts only integers: both ends are integers and a value between is rejected.
bool takes_whole_numbers(const Find& find, double low, double high) {
  const bool ends = std::floor(low) == low && std::floor(high) == high;
  return ends && !is_allowed(find, low + 0.5) && !is_allowed(find, high - 0.5);
}

double listed_number(const std::string& text) {
  const std::optional<double> number = number_in(text);
  if (!number) throw InputError(kParameter, text + " is not a number", "give a range, as POINTER=1:10, or numbers");
  return *number;
}

/// Returns the initial values over the range, without duplicates if they are integers.
std::vector<double> spread(const FlipSearch& search, const ValueRange& range, int points) {
  std::vector<double> values;
  for (int i = 0; i < points; ++i) {
    const double value = value_between(search, range.low, range.high, i / (points - 1.0));
    if (values.empty() || value > values.back()) values.push_back(value);
  }
  return values;
}

/// Reads --parameter: a field alone, its range, or the only values to try.
void read_what_is_sought(Find& find) {
  const std::string& text = find.definition.parameter;
  if (text.find('=') == std::string::npos) {
    find.pointer = scene_pointer(text, kParameter);
    const double present = present_value(find);
    if (present <= 0 || takes_whole_numbers(find, present, present))
      throw InputError(kParameter, text + " is " + number_text(present) + ", from which no range can be found",
                       "give one, such as " + text + "=0:10");
    find.values = {present};
    find.search.geometric = true;
    return;
  }
  const Parameter parameter = read_parameter(text, kParameter);
  find.pointer = parameter.pointers[0];
  if (const auto& range = parameter.range) {
    find.search.geometric = range->low > 0;
    find.search.whole = takes_whole_numbers(find, range->low, range->high);
    find.values = spread(find.search, *range, range->count > 0 ? range->count : find.definition.points);
    return;
  }
  for (const std::string& value : parameter.values) find.values.push_back(listed_number(value));
  std::ranges::sort(find.values);
  find.values.erase(std::ranges::unique(find.values).begin(), find.values.end());
  find.narrow = false;
}

SweepPlan repeats_of(const FindDefinition& definition, const Scene& scene) {
  std::vector<Parameter> parameters;
  for (const std::string& text : definition.vary) parameters.push_back(read_parameter(text, "--vary"));
  if (definition.seeds > 0) parameters.push_back(seed_parameter(scene, definition.seeds));
  return make_plan(std::move(parameters), 0, 0);
}

/// Throws InputError if a later setting of the runs would override an earlier one.
void check_pointers(const Find& find) {
  for (const Parameter& parameter : find.repeats.parameters)
    for (const std::string& repeated : parameter.pointers) {
      if (hides(find.pointer, repeated))
        throw InputError(kParameter, find.pointer + " overrides --vary " + parameter.name, "vary another field");
      for (const Condition& condition : find.conditions)
        for (const SceneSetting& setting : condition.settings)
          if (hides(setting.pointer, repeated))
            throw InputError("--outcome", setting.pointer + " overrides --vary " + parameter.name,
                             "vary another field");
    }
  for (const Condition& condition : find.conditions)
    for (const SceneSetting& setting : condition.settings)
      if (hides(find.pointer, setting.pointer))
        throw InputError("--outcome", "sets " + setting.pointer + ", which --parameter sets too",
                         "search another field, or leave it out of the condition");
}

/// Throws InputError for runs that cannot be read, before any run is made.
void check_requests(const Find& find) {
  for (const double value : find.values)
    for (const Condition& condition : find.conditions)
      for (std::size_t repeat = 0; repeat < find.repeats.runs.size(); ++repeat)
        read_scene(find.definition.scene, find.request(value, condition, repeat).settings);
}

/// Returns which conditions hold, and on which side of its range each outcome lies that should be within one: values at
/// which all hold may lie between two at which none does.
State state_of(const std::vector<Condition>& conditions, const Trial& trial) {
  State state;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    state.push_back(trial.proportions[i].mostly() ? 1 : 0);
    for (const Comparison& part : conditions[i].expression.comparisons) {
      if (part.relation != Relation::within) continue;
      const double value = trial.median(i, part.outcome);
      state.push_back(value < part.low ? -1 : value > part.high ? 1 : 0);
    }
  }
  return state;
}

/// Makes the runs of several values in parallel.
class Laboratory {
 public:
  Laboratory(const Find& find, const JobLimits& job_limits) : find_(find), limits_(job_limits) {}

  /// Returns the state at each value; known values are not run again.
  std::vector<State> states(const std::vector<double>& values) {
    std::vector<double> fresh;
    for (const double value : values)
      if (!trials.contains(value)) fresh.push_back(value);
    try_all(fresh);
    std::vector<State> states;
    for (const double value : values) states.push_back(state_of(find_.conditions, trials.at(value)));
    return states;
  }

  Trials trials;

 private:
  void try_all(const std::vector<double>& values) {
    const std::size_t conditions = find_.conditions.size(), repeats = find_.repeats.runs.size();
    std::vector<Outcomes> results(values.size() * conditions * repeats);
    const auto work = [&](std::size_t i) {
      const double value = values[i / (conditions * repeats)];
      results[i] = outcomes_of_run(find_.request(value, find_.conditions[i / repeats % conditions], i % repeats), i);
    };
    work_side_by_side(results.size(), limits_.jobs, work, [this] { return folder_.termination_requested(); });
    if (folder_.termination_requested()) throw std::runtime_error("interrupted");
    for (std::size_t i = 0; i < results.size(); ++i)
      add(values[i / (conditions * repeats)], i / repeats % conditions, std::move(results[i]));
  }

  void add(double value, std::size_t condition, Outcomes outcomes) {
    Trial& trial = trials[value];
    trial.proportions.resize(find_.conditions.size());
    trial.outcomes.resize(find_.conditions.size());
    ++trial.proportions[condition].trials;
    trial.proportions[condition].successes += find_.conditions[condition].expression.holds(outcomes) ? 1 : 0;
    trial.outcomes[condition].push_back(std::move(outcomes));
  }

  Outcomes outcomes_of_run(const RunRequest& request, std::size_t number) const {
    const fs::path file = folder_.path() / (std::to_string(number) + ".json");
    if (!make_run(request, file, limits_.limits, [this] { return folder_.termination_requested(); })) return {};
    RunRecord record = record_from_json(read_file(file), file.string());
    if (!record.error.empty())
      throw std::runtime_error("a run failed: " + record.error + "\n  " + shell_command(editor_words(request)));
    return std::move(record.outcomes);
  }

  const Find& find_;
  const JobLimits& limits_;
  TemporaryFolder folder_;
};

}  // namespace

RunRequest Find::request(double value, const Condition& condition, std::size_t repeat) const {
  RunRequest request{program, definition.scene, settings, definition.frames};
  const auto append = [&](const std::vector<SceneSetting>& more) {
    request.settings.insert(request.settings.end(), more.begin(), more.end());
  };
  append(settings_of(repeats.parameters, repeats.runs[repeat]));
  append(condition.settings);
  append({{pointer, number_text(value)}});
  return request;
}

Find make_find(const FindDefinition& definition, const JobLimits& job_limits) {
  Find find;
  find.definition = definition;
  find.program = this_program();
  for (const std::string& text : definition.set) find.settings.push_back(read_setting(text, "--set"));
  const Scene scene = read_scene(definition.scene, find.settings);
  for (const std::string& text : definition.conditions) find.conditions.push_back(read_condition(text, "--outcome"));
  find.repeats = repeats_of(definition, scene);
  find.search.tolerance = definition.tolerance;
  const int runs_of_a_value = static_cast<int>(find.conditions.size() * find.repeats.runs.size());
  find.search.values_at_a_time = std::clamp(job_limits.jobs / runs_of_a_value, 1, 8);
  read_what_is_sought(find);
  check_pointers(find);
  check_requests(find);
  return find;
}

bool Trial::holds() const { return std::ranges::all_of(proportions, &Proportion::mostly); }

double Trial::median(std::size_t condition, std::size_t outcome) const {
  std::vector<double> values;
  for (const Outcomes& run : outcomes[condition]) values.push_back(run[outcome]);
  return quantile(std::move(values), 0.5);
}

Trials find(const Find& find, const JobLimits& job_limits) {
  Laboratory laboratory(find, job_limits);
  const StateAt state = [&](const std::vector<double>& values) { return laboratory.states(values); };
  std::vector<double> values = find.values;
  if (values.size() == 1 && find.narrow)
    values = widened_until_flip(
        values[0], kDoublings, [&](double value) { return is_allowed(find, value); }, state);
  if (find.narrow) {
    search_flips(find.search, values, state);
  } else {
    state(values);
  }
  return std::move(laboratory.trials);
}

}  // namespace griffith::app
