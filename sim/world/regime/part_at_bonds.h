#pragma once

namespace griffith {

struct WorldState;

/// Parts deformable bodies at their bonds, which act in explicit dynamics and hold rigid bodies: those parts that
/// supports hold, or all where nothing does. What bonds hold together apart from these becomes rigid.
void part_at_bonds(WorldState& world);
/// Parts deformable bodies at bonds between parts that move apart with more energy than these bonds can take. For
/// bodies whose microsteps end before their waves: as rigid ones they would stop what flies apart.
void part_at_torn_bonds(WorldState& world);

}  // namespace griffith
