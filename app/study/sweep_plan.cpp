#include "app/study/sweep_plan.h"

#include <numeric>
#include <random>
#include <set>

#include "sim/core/error.h"
#include "sim/core/number_text.h"

namespace griffith::app {
namespace {

constexpr std::size_t kMaxRuns = 100'000;

/// Returns 0 .. count - 1 in random order; std::shuffle differs between libraries.
std::vector<int> permutation(int count, std::mt19937_64& random) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

bool is_sampled(const Parameter& parameter) { return parameter.values.empty(); }

void check_parameters(const std::vector<Parameter>& parameters, int samples) {
  std::set<std::string> pointers;
  bool any_sampled = false;
  for (const Parameter& parameter : parameters) {
    any_sampled |= is_sampled(parameter);
    if (is_sampled(parameter) && samples == 0)
      throw InputError("--vary " + parameter.name, "has no count",
                       "add one, such as 1:10:5, or --latin-hypercube N to take N points of all such ranges");
    for (const std::string& pointer : parameter.pointers) {
      for (const std::string& earlier : pointers)
        if (hides(pointer, earlier) && pointer != earlier)
          throw InputError("--vary " + parameter.name, "overrides " + earlier + " before it", "put it first");
      if (!pointers.insert(pointer).second)
        throw InputError("--vary " + parameter.name, "is repeated", "give all its values at once");
    }
  }
  if (samples > 0 && !any_sampled)
    throw InputError("--latin-hypercube", "has no range to sample",
                     "give one without a count, such as 1:10 or 1:10:log");
}

/// Repeats each of the `runs` with each of the values.
void multiply(std::vector<std::vector<std::string>>& runs, std::size_t parameter,
              const std::vector<std::string>& values) {
  if (runs.size() * values.size() > kMaxRuns)
    throw InputError("--vary", "makes more than 100,000 runs", "use fewer values, or a Latin hypercube");
  std::vector<std::vector<std::string>> product;
  for (const std::vector<std::string>& run : runs) {
    for (const std::string& value : values) {
      product.push_back(run);
      product.back()[parameter] = value;
    }
  }
  runs = std::move(product);
}

/// Returns one run for each point of a Latin hypercube over the sampled parameters, without values for the others.
std::vector<std::vector<std::string>> sampled_runs(const std::vector<Parameter>& parameters, int samples,
                                                   std::uint64_t seed) {
  std::vector<std::vector<std::string>> runs;
  for (const std::vector<double>& point : latin_hypercube(samples, parameters.size(), seed)) {
    std::vector<std::string>& run = runs.emplace_back(parameters.size());
    for (std::size_t i = 0; i < parameters.size(); ++i)
      if (is_sampled(parameters[i])) run[i] = number_text(parameters[i].range->at(point[i]));
  }
  return runs;
}

}  // namespace

std::vector<std::vector<double>> latin_hypercube(int samples, std::size_t dimensions, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<double>> points(static_cast<std::size_t>(samples), std::vector<double>(dimensions));
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    const std::vector<int> order = permutation(samples, random);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double within = static_cast<double>(random() >> 11) * 0x1p-53;
      points[i][axis] = (order[i] + within) / samples;
    }
  }
  return points;
}

SweepPlan make_plan(std::vector<Parameter> parameters, int samples, std::uint64_t seed) {
  check_parameters(parameters, samples);
  SweepPlan plan{std::move(parameters), {}};
  plan.runs = sampled_runs(plan.parameters, samples, seed);
  if (samples == 0) plan.runs.emplace_back(plan.parameters.size());
  for (std::size_t i = 0; i < plan.parameters.size(); ++i)
    if (!is_sampled(plan.parameters[i])) multiply(plan.runs, i, plan.parameters[i].values);
  return plan;
}

Parameter seed_parameter(const Scene& scene, int count) {
  Parameter parameter;
  parameter.name = "seed";
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].strength_scatter)
      parameter.pointers.push_back("/bodies/" + std::to_string(i) + "/strength_scatter/seed");
  if (parameter.pointers.empty())
    throw InputError(
        "--seeds", "no body of the scene has a random strength",
        "add --set 'bodies/0/strength_scatter={\"weibull_modulus\": 10}' , or vary the position of the shot");
  for (int seed = 1; seed <= count; ++seed) parameter.values.push_back(std::to_string(seed));
  return parameter;
}

}  // namespace griffith::app
