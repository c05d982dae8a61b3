#include "sim/world/energy/energy_account.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace griffith {
namespace {

using enum EnergySide;

constexpr std::array kEntries = {
    EnergyEntry{"kinetic", "Kinetic", "Kinetic energy of bodies and projectiles now.", stored, &EnergyAccount::kinetic},
    EnergyEntry{"elastic", "Elastic", "Elastic energy of elements now.", stored, &EnergyAccount::elastic},
    EnergyEntry{"start", "At the start", "Kinetic and elastic energy before the first step.", put_in,
                &EnergyAccount::start},
    EnergyEntry{"gravity", "Gravity", "Work of gravity: the loss of potential energy.", put_in,
                &EnergyAccount::gravity},
    EnergyEntry{"loads", "Loads", "Work of loads, grabs and pushes.", put_in, &EnergyAccount::loads},
    EnergyEntry{"supports", "Moving supports", "Work of moving supports.", put_in, &EnergyAccount::supports},
    EnergyEntry{"projectiles", "Projectiles", "Kinetic energy of projectiles at launch.", put_in,
                &EnergyAccount::projectiles},
    EnergyEntry{"edits", "Edits", "Energy added by edits of materials during the run.", put_in, &EnergyAccount::edits},
    EnergyEntry{"plastic", "Plastic", "Work of plastic flow.", lost, &EnergyAccount::plastic},
    EnergyEntry{"fracture", "Taken by cracks", "Taken by bonds of opening cracks, up to G_c per area.", lost,
                &EnergyAccount::fracture},
    EnergyEntry{"contacts", "Lost in contacts", "Friction, impacts without rebound, and rolling resistance.", lost,
                &EnergyAccount::contacts},
    EnergyEntry{"material_damping", "Material damping", "Rayleigh damping of the materials.", lost,
                &EnergyAccount::material_damping},
    EnergyEntry{"microstep_damping", "Microstep damping", "Damping of the highest frequencies in microsteps.", lost,
                &EnergyAccount::microstep_damping},
    EnergyEntry{"time_integration", "Time integration", "Damping by long implicit steps; shorter ones damp less.", lost,
                &EnergyAccount::time_integration},
    EnergyEntry{"hand_over", "Regime changes",
                "Lost by bodies that become rigid, fall asleep, enter or leave explicit dynamics, or are remeshed.",
                lost, &EnergyAccount::regime_change},
    EnergyEntry{
        "scaling", "Scaling",
        "Additional work that external forces would have done on scaled bodies at full stiffness, and energy of their "
        "change of shape when scaling ends.",
        lost, &EnergyAccount::scaling},
    EnergyEntry{"limited", "Limited", "Removed by limits: resolved overlaps, frozen bodies.", lost,
                &EnergyAccount::limited},
    EnergyEntry{"fracture_energy", "Fracture energy",
                "Energy of the opened area by the fracture toughness, for comparison.", beside,
                &EnergyAccount::fracture_energy},
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
