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

/// Does to a world what was done. Throws as World::fire() and World::set_material() do. What it read from a file is
/// part of the input afterwards.
void apply(World& world, WorldInput& input);

/// What happened in a step, for a mark on the bar of time.
struct StepMark {
  std::int64_t step = 0;
  double time = 0;  ///< [s], at its end
  int cracks = 0, impacts = 0;
  bool alarm = false;  ///< a solve without convergence, or values that broke down
};

/// What of a step a timeline does not have yet.
struct StepNeeds {
  bool hashes = false, copy = false;
};
/// That, where it was needed.
struct StepRecord {
  StateHashes hashes = {};
  std::shared_ptr<const World> copy;  ///< of the world after the step
};

/// A world before a step, with all that was to be done, and after it. Which thread makes the step is all the same.
struct NextStep {
  World world;
  StepNeeds needs;
};
struct MadeStep {
  World world;
  StepRecord record;
};
MadeStep make_step(NextStep next);

/// A line of steps. All but the first begin at a step of another, where something else was done.
struct Branch {
  int parent = -1;
  std::int64_t first_step = 0, last_step = 0;
  std::vector<WorldInput> inputs;   ///< since first_step, in their order
  std::vector<StepMark> marks;      ///< of steps after first_step in which anything happened
  std::vector<StateHashes> hashes;  ///< of the steps after first_step, as they were made first
};

/// A world with its past. Every step of it can be gone back to, to the bit: from the nearest copy of the world on, the
/// steps and inputs after it are done again. Copies are kept at equal intervals, which double where they would take
/// more memory than allowed. Going on from the past repeats what was; doing something else there begins a branch.
class Timeline {
 public:
  /// The past starts with `world`, as it is. `memory`: for copies of the world, about [bytes].
  explicit Timeline(World world, std::size_t memory = std::size_t{768} << 20);

  const World& world() const { return world_; }
  /// Branches by their numbers; 0 is the first.
  std::span<const Branch> branches() const { return branches_; }
  int branch() const { return branch_; }
  std::int64_t step() const { return step_; }
  /// Bounds of the branch, its parents' part included.
  std::int64_t first_step() const { return branches_.front().first_step; }
  std::int64_t last_step() const { return branches_[branch_].last_step; }
  /// What happened on the way to the end of the branch, its parents' part included, by step.
  std::vector<StepMark> marks() const;
  /// What was done on the way to the end of the branch, in its order.
  std::vector<WorldInput> inputs() const;
  /// What the steps on the way to the end of the branch left, first_step() first, as they were made first.
  std::vector<StateHashes> hashes() const;

  /// Makes a step: the one that was made before, where there is one. `before`, if any, becomes a copy of the world as
  /// it was before the step, with all that was done to it.
  void advance(std::optional<World>* before = nullptr);
  /// The same in two parts, between which make_step() may be called elsewhere: on a copy of the world,
  NextStep before_step();
  /// and to what that made the timeline goes on. Nothing else may have been done since. Returns the world as it was
  /// before the step.
  World take_step(MadeStep made);
  /// Takes the step back that advance() has just made, which gave `before`. It stays known.
  void take_back(World before);
  /// As World has them; a branch begins where steps or inputs after this one are known.
  void fire(const ProjectileBurst& burst);
  void set_material(int scene_body, const Material& material);
  /// Goes to a step of a branch, between first_step() and the branch's last. Others are clamped.
  void go_to(int branch, std::int64_t step);
  void go_to(std::int64_t step) { go_to(branch_, step); }
  /// Begins to go there: to the nearest copy of the world, or not at all where that is further. advance(), again and
  /// again, leads on to the step, which is returned.
  std::int64_t approach(int branch, std::int64_t step);
  /// Lets copies of the world take so many bytes, about, from now on.
  void limit_memory(std::size_t memory);

  /// Changes whenever the world does.
  std::int64_t revision() const { return revision_; }

  /// How many steps are between copies of the world.
  std::int64_t interval() const { return interval_; }
  /// Bytes that copies take, about; what they share counts once.
  std::size_t memory_used() const { return used_; }

 private:
  static constexpr std::int64_t kMaxInterval = 4096;

  std::vector<int> way_to_branch() const;
  void do_input(WorldInput input);
  void begin_branch();
  void enter_line();
  void redo_inputs();
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
      copies_;                 ///< per branch, by step: before its inputs of that step
  int branch_ = 0, line_ = 0;  ///< the second: it, or the ancestor to which the next step belongs
  std::int64_t step_ = 0, revision_ = 0;
  std::size_t inputs_done_ = 0;  ///< of the line
  int line_before_ = 0;          ///< both, before the last step
  std::size_t inputs_before_ = 0;
};

}  // namespace griffith
