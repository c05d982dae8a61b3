#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/scene/world_input.h"
#include "sim/world/world.h"

namespace griffith {

/// Applies an input to a world. Throws as the functions of World do. Data read from a file become part
/// of the input.
void apply(World& world, WorldInput& input);

/// Events of a step, for a mark on the timeline.
struct StepMark {
  std::int64_t step = 0;
  double time = 0;  ///< time at the end of the step [s]
  int cracks = 0, impacts = 0;
  bool alarm = false;  ///< a solve did not converge, or values became invalid
};

/// Data of a step that a timeline does not have yet.
struct StepNeeds {
  bool hashes = false, copy = false;
};
/// Data of a step, as far as needed.
struct StepRecord {
  StateHashes hashes = {};
  std::shared_ptr<const World> copy;  ///< world after the step
};

/// World before a step, with all inputs applied. The step may be computed on any thread.
struct NextStep {
  World world;
  StepNeeds needs;
};
struct MadeStep {
  World world;
  StepRecord record;
};
/// Makes the step.
MadeStep make_step(NextStep next);
/// Makes the step and shows its microsteps to an observer.
MadeStep make_step(NextStep next, const MicrostepObserver& observer);

/// Line of steps. All but the first begin at a step of another branch, where an input differed.
struct Branch {
  int parent = -1;
  std::int64_t first_step = 0, last_step = 0;
  std::vector<WorldInput> inputs;   ///< inputs since first_step, in order
  std::vector<StepMark> marks;      ///< marks of the steps after first_step with events
  std::vector<StateHashes> hashes;  ///< hashes of the steps after first_step, from their first computation
};

/// World with its past. Every step can be restored to the bit: the steps and inputs after the nearest earlier copy of
/// the world are computed again. Copies are kept at equal intervals, which double when the memory limit is reached.
/// Steps from the past repeat the branch, and a different input there begins a new branch.
class Timeline {
 public:
  /// Starts the past with `world` in its present state. `memory`: approximate limit for copies of the world [bytes].
  explicit Timeline(World world, std::size_t memory = std::size_t{768} << 20);

  const World& world() const { return world_; }
  /// Branches by number; 0 is the first.
  std::span<const Branch> branches() const { return branches_; }
  int branch() const { return branch_; }
  std::int64_t step() const { return step_; }
  /// Bounds of the branch, including its parents' part.
  std::int64_t first_step() const { return branches_.front().first_step; }
  std::int64_t last_step() const { return branches_[branch_].last_step; }
  /// Returns the marks up to the end of the branch, including its parents' part, by step.
  std::vector<StepMark> marks() const;
  /// Returns the inputs up to the end of the branch, in order.
  std::vector<WorldInput> inputs() const;
  /// Returns the hashes of the steps up to the end of the branch from their first computation, first_step() first.
  std::vector<StateHashes> hashes() const;

  /// Computes a step, or repeats it if it is known. `before`, if given, becomes a copy of the world before the step
  /// with all inputs applied.
  void advance(std::optional<World>* before = nullptr);
  /// Begins the same in two parts: make_step() may be called elsewhere on the returned copy of the world.
  NextStep before_step();
  /// Continues with the result of make_step(). The timeline must not have changed since before_step(). Returns the
  /// world before the step.
  World take_step(MadeStep made);
  /// Takes back the step just computed by advance(), which set `before`. The step stays known.
  void take_back(World before);
  /// As in World. A branch begins if steps or inputs after this one are known.
  void fire(const ProjectileBurst& burst);
  void set_material(int scene_body, const Material& material);
  void grab(const Grab& grab);
  void move_grab(const Vec3& target);
  void release();
  void push(const Push& push);
  /// Goes to a step of a branch, clamped to first_step() and the branch's last.
  void go_to(int branch, std::int64_t step);
  void go_to(std::int64_t step) { go_to(branch_, step); }
  /// Starts to go there, from the nearest copy of the world or from the present if that is closer. Returns the step,
  /// which repeated calls of advance() reach.
  std::int64_t approach(int branch, std::int64_t step);
  /// Sets the approximate limit for copies of the world [bytes].
  void limit_memory(std::size_t memory);

  /// Returns a number that changes with the world.
  std::int64_t revision() const { return revision_; }

  /// Returns the number of steps between copies of the world.
  std::int64_t interval() const { return interval_; }
  /// Returns the approximate size of all copies [bytes]. Shared data count once.
  std::size_t memory_used() const { return used_; }

 private:
  static constexpr std::int64_t kMaxInterval = 4096;

  std::vector<int> way_to_branch() const;
  void do_input(WorldInput input);
  void begin_branch();
  void enter_line();
  void redo_inputs(bool in_past = false);
  StepNeeds needs_of_step() const;
  void finish_step(StepRecord record, std::size_t cracks_before);
  void mark_step(std::size_t cracks_before);
  void keep_copy(std::shared_ptr<const World> copy);
  void thin_out();
  std::size_t size_of_copy(int branch, std::int64_t step) const;
  std::pair<std::int64_t, int> nearest_copy(int branch, std::int64_t step) const;

  World world_;
  StateHashes start_hashes_;
  std::size_t memory_, used_ = 0;
  std::int64_t interval_ = 8;
  std::vector<Branch> branches_;
  std::vector<std::map<std::int64_t, std::shared_ptr<const World>>>
      copies_;                 ///< per branch, by step: copies before the step's inputs
  int branch_ = 0, line_ = 0;  ///< branch; line: the branch or its ancestor that has the next step
  std::int64_t step_ = 0, revision_ = 0;
  std::size_t inputs_done_ = 0;  ///< number of the line's inputs that are done
  int line_before_ = 0;          ///< both, before the last step
  std::size_t inputs_before_ = 0;
};

}  // namespace griffith
