#include "sim/world/energy/energy_account.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace griffith {
namespace {

using enum EnergySide;

constexpr std::array kEntries = {
    EnergyEntry{"kinetic", "Kinetic", "Of all that moves, now.", stored, &EnergyAccount::kinetic},
    EnergyEntry{"elastic", "Elastic", "Stored in strained elements, now.", stored, &EnergyAccount::elastic},
    EnergyEntry{"start", "At the start", "Kinetic and elastic energy before the first step.", put_in,
                &EnergyAccount::start},
    EnergyEntry{"gravity", "Gravity", "Its work: what potential energy has fallen by.", put_in,
                &EnergyAccount::gravity},
    EnergyEntry{"loads", "Loads", "Their work.", put_in, &EnergyAccount::loads},
    EnergyEntry{"supports", "Moving supports", "Work of supports that move.", put_in, &EnergyAccount::supports},
    EnergyEntry{"projectiles", "Projectiles", "Their kinetic energy when they were launched.", put_in,
                &EnergyAccount::projectiles},
    EnergyEntry{"edits", "Edits", "What changes of material added while the scene ran.", put_in, &EnergyAccount::edits},
    EnergyEntry{"plastic", "Plastic", "Work of yielding.", lost, &EnergyAccount::plastic},
    EnergyEntry{"contacts", "Lost in contacts", "Friction, blows without rebound and rolling.", lost,
                &EnergyAccount::contacts},
    EnergyEntry{"material_damping", "Material damping", "Mass and stiffness damping of the materials.", lost,
                &EnergyAccount::material_damping},
    EnergyEntry{"microstep_damping", "Microstep damping", "Damping of the highest frequencies in microsteps.", lost,
                &EnergyAccount::microstep_damping},
    EnergyEntry{"time_integration", "Time integration", "What long implicit steps damp: shorter ones damp less.", lost,
                &EnergyAccount::time_integration},
    EnergyEntry{"hand_over", "Hand-over",
                "Lost by bodies that turn rigid, fall asleep, enter or leave microsteps, or are cut anew.", lost,
                &EnergyAccount::hand_over},
    EnergyEntry{"scaling", "Scaling",
                "What external forces would have done more to scaled bodies under their full stiffness, and what their "
                "change of shape takes when scaling ends.",
                lost, &EnergyAccount::scaling},
    EnergyEntry{"limited", "Limited", "Cut off by limits: overlaps pushed out, frozen bodies.", lost,
                &EnergyAccount::limited},
    EnergyEntry{
        "fracture_energy", "Fracture energy",
        "What the opened area would take by the fracture toughness, for comparison: cracks open for nothing here.",
        beside, &EnergyAccount::fracture_energy},
};

}  // namespace

double EnergyAccount::turned_over() const {
  double sum = 0;
  for (const EnergyEntry& entry : kEntries)
    if (entry.side == EnergySide::put_in) sum += std::max(0.0, this->*entry.value);
  return sum;
}

EnergyAccount& EnergyAccount::operator+=(const EnergyAccount& other) {
  for (const EnergyEntry& entry : kEntries) this->*entry.value += other.*entry.value;
  crack_area += other.crack_area;
  return *this;
}

EnergyAccount& EnergyAccount::operator-=(const EnergyAccount& other) {
  for (const EnergyEntry& entry : kEntries) this->*entry.value -= other.*entry.value;
  crack_area -= other.crack_area;
  return *this;
}

std::span<const EnergyEntry> energy_entries() { return kEntries; }

}  // namespace griffith
