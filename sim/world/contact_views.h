#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// Adds the contacts of a substep that carry an impulse to those of the step, for the frame.
void record_contacts(WorldState& world);

/// Merges two contacts into `contact`: their mean, weighted by their impulses, which are added. At least one impulse is
/// not zero.
void merge(ContactView& contact, const ContactView& other);

/// Merges the step's contacts that act at one place.
void merge_contacts(WorldState& world);

}  // namespace griffith
