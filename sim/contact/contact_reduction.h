#pragma once

#include <span>
#include <vector>

#include "sim/contact/contact_world.h"

namespace griffith {

/// Which of the contacts of one pair of objects are enough to hold them apart: of those that point alike (within 18°),
/// the four outermost. Ascending indices.
std::vector<int> representative_contacts(std::span<const Contact> contacts);

}  // namespace griffith
