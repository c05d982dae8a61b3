#pragma once

#include <span>
#include <string_view>

namespace griffith {

/// Sources and sinks of a scene's energy [J]. The input equals the stored and the lost energy except for
/// `unaccounted()`: each entry is measured by a law of its own, none is the rest of the others.
struct EnergyAccount {
  // What is there.
  double kinetic = 0, elastic = 0;
  // What was put in.
  double start = 0;        ///< kinetic and elastic before the first step
  double gravity = 0;      ///< its work: what potential energy has fallen by
  double loads = 0;        ///< their work
  double supports = 0;     ///< work of moving supports
  double projectiles = 0;  ///< kinetic, when they were launched
  double edits = 0;        ///< energy added by changes of material while the scene runs
  // What is lost.
  double plastic = 0;            ///< work of yielding
  double fracture = 0;           ///< taken by bonds of opening cracks
  double contacts = 0;           ///< friction, impacts without rebound, rolling
  double material_damping = 0;   ///< Rayleigh's, of the material
  double microstep_damping = 0;  ///< damping of the highest frequencies in microsteps
  double time_integration = 0;   ///< damping of the implicit step; difference of a step's end and middle
  double regime_change = 0;      ///< bodies that turn rigid, fall asleep, enter or leave microsteps, or are cut
  double scaling = 0;            ///< forces that scaled bodies lack, and what their shape loses when scaling ends
  double limited = 0;            ///< cut off by limits: pushed out overlaps, frozen bodies
  // Beside the account: static steps, and implicit ones of hybrid scenes, open cracks for nothing.
  double crack_area = 0;       ///< opened so far, one side of each crack [m²]
  double fracture_energy = 0;  ///< energy of the crack area, K_Ic² (1 − ν²) / E times the area

  double stored() const { return kinetic + elastic; }
  double put_in() const { return start + gravity + loads + supports + projectiles + edits; }
  double lost() const {
    return plastic + fracture + contacts + material_damping + microstep_damping + time_integration + regime_change +
           scaling + limited;
  }
  double unaccounted() const { return put_in() - stored() - lost(); }
  /// Returns the energy that errors are compared with: all that came in from each source, even if it left again.
  double turned_over() const;

  EnergyAccount& operator+=(const EnergyAccount& other);
  EnergyAccount& operator-=(const EnergyAccount& other);
};

/// Side of the balance of an entry.
enum class EnergySide { stored, put_in, lost, beside };

struct EnergyEntry {
  std::string_view key;      ///< as in files: "time_integration"
  std::string_view label;    ///< for a person: "Time integration"
  std::string_view meaning;  ///< a sentence; all texts end with a zero
  EnergySide side;
  double EnergyAccount::*value;
};

/// Returns all entries, in joules, in the order of tables.
std::span<const EnergyEntry> energy_entries();

}  // namespace griffith
