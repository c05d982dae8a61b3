#include "sim/world/output/step_counters.h"

#include <algorithm>

namespace griffith {
namespace {

constexpr auto kSum = CounterTotal::sum, kLargest = CounterTotal::largest;
constexpr auto kNone = CounterConcern::none, kWarning = CounterConcern::warning, kError = CounterConcern::error;

constexpr StepCounter kCounters[] = {
    {"substeps", "Substeps", "", "Parts of the step, each with contacts of its own.", kSum, kNone,
     &StepReport::substeps},
    {"microsteps", "Microsteps", "", "Explicit steps of bodies in explicit dynamics.", kSum, kNone,
     &StepReport::microsteps},
    {"microstep_work", "Work of microsteps", "ms",
     "Largest of any step, as time on a typical core: elements, contacts, overload checks and cracks. A step does "
     "at most 20 times step_budget, or 50 ms.",
     kLargest, kNone, &StepReport::microstep_work},
    {"impacts", "Impacts", "", "Bodies whose impacts caused waves that are followed.", kSum, kNone,
     &StepReport::impacts},
    {"contacts", "Contacts", "", "Points at which objects touched.", kSum, kNone, &StepReport::contacts},
    {"cracks_postponed", "Cracks postponed", "", "Beyond the limit of cracks per step; they follow in the next steps.",
     kSum, kWarning, &StepReport::cracks_postponed},
    {"cracks_suppressed", "Cracks suppressed", "", "Omitted because the fragment would be too small.", kSum, kWarning,
     &StepReport::cracks_suppressed},
    {"remeshing_refused", "Cuts rejected", "",
     "Edges that remeshing did not cut because tetrahedra would have become too small or too flat.", kSum, kWarning,
     &StepReport::remeshing_refused},
    {"supports_torn", "Supports torn", "", "Cracks at which a support detached.", kSum, kNone,
     &StepReport::supports_torn},
    {"unfinished_equilibria", "Unfinished equilibria", "",
     "Cracks were still opening at the limit of substeps: raise impact_substeps of the scene.", kSum, kWarning,
     &StepReport::unfinished_equilibria},
    {"unfinished_explicit", "Unfinished impacts", "",
     "Bodies in which waves were still running at the limit of a step: 20 times the work of step_budget, or 10,000 "
     "microsteps per millisecond of it. Raise it, or use larger elements or a shorter time step.",
     kSum, kWarning, &StepReport::unfinished_explicit},
    {"relieved_tets", "Relieved tetrahedra", "",
     "Largest number of slivers that kept only a part of their stiffness in microsteps.", kLargest, kNone,
     &StepReport::relieved_tets},
    {"unconverged_solves", "Unconverged solves", "",
     "Solves stopped by the iteration limit: allow more iterations or a larger residual.", kSum, kWarning,
     &StepReport::unconverged_solves},
    {"unconverged_motions", "Unconverged motions", "",
     "Nonlinear steps of strongly deforming bodies that did not converge: use a shorter time step.", kSum, kWarning,
     &StepReport::unconverged_motions},
    {"unconverged_contacts", "Unconverged contacts", "",
     "Contacts of elastic bodies that still overlapped, slid or pulled by more than the tolerance.", kSum, kWarning,
     &StepReport::unconverged_contacts},
    {"contact_iterations", "Contact iterations", "", "Linear iterations for the impulses of elastic bodies.", kSum,
     kNone, &StepReport::contact_iterations},
    {"sleeping_bodies", "Sleeping bodies", "", "Bodies at rest that are not computed until something disturbs them.",
     kLargest, kNone, &StepReport::sleeping_bodies},
    {"max_penetration", "Penetration", "m", "The deepest overlap in a contact.", kLargest, kNone,
     &StepReport::max_penetration},
    {"max_relative_residual", "Relative residual", "-",
     "Unbalanced force left by the solver, relative to the right-hand side.", kLargest, kNone,
     &StepReport::max_relative_residual},
    {"solver_iterations", "Iterations", "", "Largest number of any body and substep.", kLargest, kNone,
     &StepReport::solver_iterations},
    {"inverted_tets", "Inverted tetrahedra", "", "Elements turned inside out: use more substeps or stiffer material.",
     kLargest, kWarning, &StepReport::inverted_tets},
    {"non_finite_values", "Values not finite", "",
     "Bodies frozen because a value was not finite, or because they would take more than 100,000 explicit substeps "
     "per step. Reset, and use a shorter time step.",
     kLargest, kError, &StepReport::non_finite_values},
};

}  // namespace

std::span<const StepCounter> step_counters() { return kCounters; }

int warnings_of(const StepCounter& counter, const StepReport& step) {
  const auto* const value = std::get_if<int StepReport::*>(&counter.value);
  return value && counter.concern != kNone ? step.**value : 0;
}

int warnings_of(const StepReport& step) {
  int sum = 0;
  for (const StepCounter& counter : kCounters) sum += warnings_of(counter, step);
  return sum;
}

void add_step(const StepReport& step, StepReport& total) {
  for (const StepCounter& counter : kCounters)
    std::visit(
        [&](auto value) {
          total.*value = counter.total == kSum ? total.*value + step.*value : std::max(total.*value, step.*value);
        },
        counter.value);
}

}  // namespace griffith
