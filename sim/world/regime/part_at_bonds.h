#pragma once

namespace griffith {

struct WorldState;

/// Parts deformable bodies at their bonds, which act in explicit dynamics and hold rigid bodies: those parts that
/// supports hold, or all where nothing does. What bonds hold together apart from these becomes rigid.
void part_at_bonds(WorldState& world);

}  // namespace griffith
