#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace griffith {

/// Groups of what a world keeps from step to step, each hashed by itself: where two runs part, their names say in what.
/// Earlier ones tend to follow from later ones of the step before.
///   positions, velocities   of nodes
///   mesh         corners of tets and their bodies, rest positions, masses
///   stresses     of elements, and strains without stress
///   separations  separation tensors of nodes with what they are judged by, forces of supports
///   cracks       faces that opened, crack fronts, cracks put off, walls of splinters
///   bodies       motion, rest and explicit dynamics of pieces
///   projectiles  motion, and shots that are still to come
///   contacts     what is remembered of them, and who sleeps
///   energy       the account
inline constexpr std::array<std::string_view, 10> kStateFields = {"positions",   "velocities", "mesh",   "stresses",
                                                                  "separations", "cracks",     "bodies", "projectiles",
                                                                  "contacts",    "energy"};

/// Hashes for each of kStateFields: equal bits have equal hashes.
using StateHashes = std::array<std::uint64_t, kStateFields.size()>;

}  // namespace griffith
