#include "sim/timeline/timeline.h"

#include <algorithm>
#include <utility>

namespace griffith {
namespace {

StepRecord record_of(const World& world, const StepNeeds& needs) {
  StepRecord record;
  if (needs.hashes) record.hashes = world.state_hashes();
  if (needs.copy) record.copy = std::make_shared<const World>(world);
  return record;
}

StepRecord step_and_record(World& world, const StepNeeds& needs) {
  world.step();
  return record_of(world, needs);
}

}  // namespace

MadeStep make_step(NextStep next) {
  StepRecord record = step_and_record(next.world, next.needs);
  return {std::move(next.world), std::move(record)};
}

MadeStep make_step(NextStep next, const MicrostepObserver& observer) {
  next.world.step(observer);
  StepRecord record = record_of(next.world, next.needs);
  return {std::move(next.world), std::move(record)};
}

void apply(World& world, WorldInput& input) {
  struct Apply {
    World& world;
    void operator()(ProjectileBurst& burst) const { burst = world.fire(burst); }
    void operator()(const MaterialChange& change) const { world.set_material(change.scene_body, change.material); }
    void operator()(const Grab& grab) const { world.grab(grab); }
    void operator()(const GrabMove& move) const { world.move_grab(move.target); }
    void operator()(const GrabRelease&) const { world.release(); }
    void operator()(const Push& push) const { world.push(push); }
  };
  std::visit(Apply{world}, input.action);
}

Timeline::Timeline(World world, std::size_t memory)
    : world_(std::move(world)), start_hashes_(world_.state_hashes()), memory_(memory) {
  step_ = world_.frame().step;
  branches_.push_back({-1, step_, step_, {}, {}, {}});
  copies_.emplace_back();
  keep_copy(std::make_shared<const World>(world_));
}

std::vector<StepMark> Timeline::marks() const {
  std::vector<StepMark> all;
  std::int64_t end = last_step();
  for (int branch = branch_; branch >= 0; branch = branches_[branch].parent) {
    const std::vector<StepMark>& marks = branches_[branch].marks;
    for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark)
      if (mark->step <= end) all.push_back(*mark);
    end = branches_[branch].first_step;
  }
  std::ranges::reverse(all);
  return all;
}

/// Returns the branch and its ancestors, the first one first.
std::vector<int> Timeline::way_to_branch() const {
  std::vector<int> way;
  for (int line = branch_; line >= 0; line = branches_[line].parent) way.push_back(line);
  std::ranges::reverse(way);
  return way;
}

std::vector<WorldInput> Timeline::inputs() const {
  std::vector<WorldInput> all;
  for (const int line : way_to_branch()) {
    const Branch& branch = branches_[line];
    std::erase_if(all, [&](const WorldInput& input) { return input.step >= branch.first_step; });
    all.insert(all.end(), branch.inputs.begin(), branch.inputs.end());
  }
  return all;
}

std::vector<StateHashes> Timeline::hashes() const {
  std::vector<StateHashes> all = {start_hashes_};
  for (const int line : way_to_branch()) {
    const Branch& branch = branches_[line];
    all.resize(static_cast<std::size_t>(branch.first_step - first_step() + 1));
    all.insert(all.end(), branch.hashes.begin(), branch.hashes.end());
  }
  return all;
}

void Timeline::advance(std::optional<World>* before) {
  redo_inputs();
  if (before) before->emplace(world_);
  const std::size_t cracks_before = world_.frame().crack_events.size();
  finish_step(step_and_record(world_, needs_of_step()), cracks_before);
}

NextStep Timeline::before_step() {
  redo_inputs();
  return {world_, needs_of_step()};
}

World Timeline::take_step(MadeStep made) {
  const std::size_t cracks_before = world_.frame().crack_events.size();
  std::swap(world_, made.world);
  finish_step(std::move(made.record), cracks_before);
  return std::move(made.world);
}

void Timeline::take_back(World before) {
  world_ = std::move(before);
  --step_;
  ++revision_;
  inputs_done_ = inputs_before_;
  line_ = line_before_;
}

void Timeline::fire(const ProjectileBurst& burst) { do_input({step_, burst}); }
void Timeline::set_material(int scene_body, const Material& material) {
  do_input({step_, MaterialChange{scene_body, material}});
}

void Timeline::grab(const Grab& grab) { do_input({step_, grab}); }
void Timeline::move_grab(const Vec3& target) { do_input({step_, GrabMove{target}}); }
void Timeline::release() { do_input({step_, GrabRelease{}}); }
void Timeline::push(const Push& push) { do_input({step_, push}); }

/// Applies the input to the world first, since a refused input is none.
void Timeline::do_input(WorldInput input) {
  apply(world_, input);
  ++revision_;
  enter_line();
  if (step_ < last_step() || inputs_done_ < branches_[line_].inputs.size()) begin_branch();
  branches_[branch_].inputs.push_back(std::move(input));
  ++inputs_done_;
}

/// Begins a branch with the inputs done at this step.
void Timeline::begin_branch() {
  Branch next{line_, step_, step_, {}, {}, {}};
  const std::vector<WorldInput>& inputs = branches_[line_].inputs;
  for (std::size_t i = 0; i < inputs_done_; ++i)
    if (inputs[i].step == step_) next.inputs.push_back(inputs[i]);
  inputs_done_ = next.inputs.size();
  line_ = branch_ = static_cast<int>(branches_.size());
  branches_.push_back(std::move(next));
  copies_.emplace_back();
}

/// Finds the branch, or its ancestor, that has the next step.
void Timeline::enter_line() {
  int line = branch_;
  while (step_ < branches_[line].first_step) line = branches_[line].parent;
  if (line == line_) return;
  line_ = line;
  inputs_done_ = 0;
}

/// Applies known inputs before the next step that are not done yet. `in_past`: only materials, up to the first other
/// input: who edits one expects it wherever its step is shown.
void Timeline::redo_inputs(bool in_past) {
  enter_line();
  std::vector<WorldInput>& inputs = branches_[line_].inputs;
  for (; inputs_done_ < inputs.size() && inputs[inputs_done_].step <= step_; ++inputs_done_) {
    if (in_past && !std::holds_alternative<MaterialChange>(inputs[inputs_done_].action)) return;
    apply(world_, inputs[inputs_done_]);
    ++revision_;
  }
}

/// Returns the needs of the step after this one.
StepNeeds Timeline::needs_of_step() const {
  const bool is_new = step_ >= last_step();
  return {is_new, is_new && (step_ + 1 - first_step()) % interval_ == 0};
}

/// Finishes the step that the world has just computed.
void Timeline::finish_step(StepRecord record, std::size_t cracks_before) {
  inputs_before_ = inputs_done_;
  line_before_ = line_;
  const bool repeats = step_ < last_step();
  ++step_;
  ++revision_;
  if (repeats) {
    redo_inputs(step_ < last_step());
    return;
  }
  branches_[branch_].last_step = step_;
  branches_[branch_].hashes.push_back(record.hashes);
  mark_step(cracks_before);
  const bool is_due = (step_ - first_step()) % interval_ == 0;  // copies may have been removed meanwhile
  if (record.copy && is_due) keep_copy(std::move(record.copy));
}

void Timeline::mark_step(std::size_t cracks_before) {
  const Frame frame = world_.frame();
  const StepReport& report = frame.report;
  const StepMark mark{step_, frame.time, static_cast<int>(frame.crack_events.size() - cracks_before), report.impacts,
                      report.unconverged_solves > 0 || report.non_finite_values > 0};
  if (mark.cracks > 0 || mark.impacts > 0 || mark.alarm) branches_[branch_].marks.push_back(mark);
}

void Timeline::keep_copy(std::shared_ptr<const World> copy) {
  copies_[branch_][step_] = std::move(copy);
  used_ += size_of_copy(branch_, step_);
  while (used_ > memory_ && interval_ < kMaxInterval) thin_out();
}

void Timeline::limit_memory(std::size_t memory) {
  memory_ = memory;
  while (used_ > memory_ && interval_ < kMaxInterval) thin_out();
}

/// Removes every other copy except the first.
void Timeline::thin_out() {
  interval_ *= 2;
  const auto goes = [&](const auto& entry) { return (entry.first - first_step()) % interval_ != 0; };
  for (auto& copies : copies_) std::erase_if(copies, goes);
  used_ = 0;
  for (int branch = 0; branch < std::ssize(copies_); ++branch)
    for (const auto& [step, copy] : copies_[branch]) used_ += size_of_copy(branch, step);
}

/// Returns the size of a copy without the data that it shares with the copy before it [bytes]. Data that several copies
/// share were shared since the first of them.
std::size_t Timeline::size_of_copy(int branch, std::int64_t step) const {
  const auto [at, line] = nearest_copy(branch, step - 1);
  const World *copy = copies_[branch].at(step).get(), *before = copies_[line].at(at).get();
  return copy->memory(before == copy ? nullptr : before);
}

void Timeline::go_to(int branch, std::int64_t step) {
  step = approach(branch, step);
  while (step_ < step) advance();
}

std::int64_t Timeline::approach(int branch, std::int64_t step) {
  step = std::clamp(step, first_step(), branches_[branch].last_step);
  ++revision_;
  if (branch != branch_ || step < step_ || nearest_copy(branch, step).first > step_) {
    const auto [at, line] = nearest_copy(branch, step);
    world_ = *copies_[line].at(at);
    step_ = at;
    branch_ = branch;
    line_ = -1;  // found again with all inputs before this step done
    enter_line();
    inputs_done_ = static_cast<std::size_t>(
        std::ranges::lower_bound(branches_[line_].inputs, at, {}, &WorldInput::step) - branches_[line_].inputs.begin());
  }
  if (step_ == step) redo_inputs(step_ < last_step());
  return step;
}

/// Returns the step of the newest copy before a step of a branch, and the branch of the copy.
std::pair<std::int64_t, int> Timeline::nearest_copy(int branch, std::int64_t step) const {
  for (int line = branch; line >= 0; line = branches_[line].parent) {
    const auto after = copies_[line].upper_bound(step);
    if (after != copies_[line].begin()) return {std::prev(after)->first, line};
    step = std::min(step, branches_[line].first_step);
  }
  return {first_step(), 0};
}

}  // namespace griffith
