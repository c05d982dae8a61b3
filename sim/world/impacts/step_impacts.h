#pragma once

#include <array>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "sim/world/impacts/lone_impact.h"

namespace griffith {

/// Impacts of a step. Those of bodies with each other and with the ground are examined one by one, since the effect of
/// two objects on each other while waves cross them is independent of all others. Most cause no damage and are left to
/// contacts. Of the others,
///   those between free bodies of few elements are followed alone: the two objects by microsteps, at the time of their
///     impact, ahead of all others; they take part in the rest of the step;
///   those of supported bodies, or with much work, are shared: the step is divided at them.
/// Those of projectiles are shared, too.
class StepImpacts {
 public:
  /// Finds and examines impacts within `duration` [s]. Returns the impacts that are shared.
  std::vector<Impact> find(const WorldState& world, double duration);
  /// Follows those that go alone within `duration` [s], in order of time. Bodies of safe ones become rigid.
  void follow_alone(WorldState& world, double duration);
  /// Takes over the harmful ones among meetings in a substep that is being solved, and removes them from `meetings`.
  /// They replace those of an earlier call. What would overlap far and cannot be followed stays: as a contact.
  void take_harmful(const WorldState& world, double duration, std::vector<ContactWorld::Meeting>& meetings);
  /// Follows those taken over, after all have moved by a substep of `duration` [s] from the time `start` [s].
  void follow_late(WorldState& world, double start, double duration);
  /// Moves the bodies that are ahead back by that time, after all have moved by a substep.
  void catch_up(WorldState& world);

  double work() const { return work_; }           ///< work of all so far [µs of a typical core]
  int microsteps() const { return microsteps_; }  ///< number of microsteps of impacts followed alone

 private:
  /// Harmful impact that can be followed without other bodies.
  struct Alone {
    Impact impact;
    double contact = 0;  ///< time from the predicted impact to the contact [s]
  };
  std::vector<TrialOutcome> try_all(const WorldState& world, const std::vector<Impact>& impacts,
                                    const std::function<std::array<RigidState, 2>(const Impact&)>& states_of,
                                    double until);
  /// `wait`: time by which the contact may come later than predicted [s].
  void follow(WorldState& world, Alone alone, double wait = 0);
  bool is_safe(const Impact& impact) const;
  bool goes_alone(const WorldState& world, const Impact& impact) const;
  bool needs_no_trial(const WorldState& world, const Impact& impact) const;
  Flights flights_of(const Impact& impact) const;
  bool is_ahead(const Impact& impact) const;
  void turn_rigid(WorldState& world);

  std::map<std::pair<ProxyId, ProxyId>, double> safe_speeds_;  ///< speeds of impacts that were tried [m/s]
  std::vector<Alone> alone_;
  std::vector<Alone> late_;          ///< impacts that impulses of the substep bring about
  std::vector<BodyId> safe_bodies_;  ///< bodies of safe impacts
  std::map<BodyId, double> ahead_;   ///< time by which a body is ahead of all others [s]
  double work_ = 0;
  int microsteps_ = 0;
};

}  // namespace griffith
