#pragma once

#include <span>
#include <vector>

#include "sim/world/state/world_state.h"

namespace griffith {

/// Views and totals, for the frame.
void publish(WorldState& world);

/// Adds the present contacts that carry an impulse to the views of a step.
void add_contacts(const WorldState& world, std::vector<ContactView>& views);

/// Merges two contacts into `contact`: their mean, weighted by their impulses, which are added. At least one impulse is
/// not zero.
void merge(ContactView& contact, const ContactView& other);

/// Returns views of which those that act at one place are merged.
std::vector<ContactView> merged_contacts(const WorldState& world, std::span<const ContactView> views);

}  // namespace griffith
