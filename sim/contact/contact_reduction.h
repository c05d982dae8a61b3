#pragma once

#include <span>
#include <vector>

#include "sim/contact/contact_world.h"

namespace griffith {

/// Returns the contacts that suffice to hold a pair of objects apart: of those with similar normals (within 18°), the
/// four outermost, of those that are deeper than these and than `allowed_overlap` [m] again the four outermost, and so
/// on. Ascending indices.
std::vector<int> representative_contacts(std::span<const Contact> contacts, double allowed_overlap);

}  // namespace griffith
