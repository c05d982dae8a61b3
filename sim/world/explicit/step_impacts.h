#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "sim/world/explicit/lone_impact.h"

namespace griffith {

/// The impacts of a step. Those of bodies with each other and with the ground are judged one by one, as what two things
/// do to each other while waves cross them depends on no one else: most are harmless, and are left to contacts. Of the
/// others,
///   those between free bodies of few elements are followed alone: the two things by microsteps, at the time of their
///     impact, ahead of all else; what remains of the step, they make with all others;
///   those of bodies that supports hold, or that would take much work, are shared: the step is cut at them.
/// Those of projectiles are shared, too.
class StepImpacts {
 public:
  /// Finds and judges what will meet within `duration` [s]. Returns the impacts that are shared.
  std::vector<Impact> find(const WorldState& world, double duration);
  /// Follows those that go alone within `duration` [s], the first ones first. Bodies of harmless ones turn rigid.
  void follow_alone(WorldState& world, double duration);
  /// Takes the bodies that are ahead back by that time, once all have moved by a substep.
  void catch_up(WorldState& world);

  double work() const { return work_; }           ///< that all took so far [µs of a usual core]
  int microsteps() const { return microsteps_; }  ///< of impacts that were followed alone

 private:
  /// A harmful impact of bodies that need no one else.
  struct Alone {
    Impact impact;
    double contact = 0;  ///< from when they are seen to strike until they touch [s]
  };
  bool is_safe(const Impact& impact) const;
  bool goes_alone(const WorldState& world, const Impact& impact) const;
  Flights flights_of(const Impact& impact) const;
  bool is_ahead(const Impact& impact) const;
  void turn_rigid(WorldState& world);

  std::map<std::pair<ProxyId, ProxyId>, double> safe_speeds_;  ///< speeds of impacts that were tried [m/s]
  std::vector<Alone> alone_;
  std::vector<BodyId> safe_bodies_;  ///< of harmless impacts
  std::map<BodyId, double> ahead_;   ///< by how much a body is ahead of all others [s]
  double work_ = 0;
  int microsteps_ = 0;
};

}  // namespace griffith
