#pragma once

#include <span>
#include <string_view>

namespace griffith {

/// Where the energy of a scene came from and where it went [J]. What was put in is what is there and what is lost, but
/// for `unaccounted()`: each entry is measured by a law of its own, none is the rest of the others.
struct EnergyAccount {
  // What is there.
  double kinetic = 0, elastic = 0;
  // What was put in.
  double start = 0;        ///< kinetic and elastic before the first step
  double gravity = 0;      ///< its work: what potential energy has fallen by
  double loads = 0;        ///< their work
  double supports = 0;     ///< of those that move
  double projectiles = 0;  ///< kinetic, when they were launched
  double edits = 0;        ///< what a change of material while the scene runs added
  // What is lost.
  double plastic = 0;            ///< work of yielding
  double contacts = 0;           ///< friction, impacts without rebound, rolling
  double material_damping = 0;   ///< Rayleigh's, of the material
  double microstep_damping = 0;  ///< of the highest frequencies, in microsteps
  double time_integration = 0;   ///< what the implicit step damps, and how far a step's end is from its middle
  double regime_change = 0;      ///< bodies that turn rigid, fall asleep, enter or leave microsteps, or are cut
  double scaling = 0;            ///< forces that scaled bodies lack, and what their shape loses when scaling ends
  double limited = 0;            ///< cut off by limits: pushed out overlaps, frozen bodies
  // Beside the account: cracks open for nothing, and what they release ends as waves among the losses.
  double crack_area = 0;       ///< opened so far, one side of each crack [m²]
  double fracture_energy = 0;  ///< what opening it would take, K_Ic² (1 − ν²) / E times the area

  double stored() const { return kinetic + elastic; }
  double put_in() const { return start + gravity + loads + supports + projectiles + edits; }
  double lost() const {
    return plastic + contacts + material_damping + microstep_damping + time_integration + regime_change + scaling +
           limited;
  }
  double unaccounted() const { return put_in() - stored() - lost(); }
  /// What errors are held against: what came in from each source, whatever went out again by another.
  double turned_over() const;

  EnergyAccount& operator+=(const EnergyAccount& other);
  EnergyAccount& operator-=(const EnergyAccount& other);
};

/// The side of the balance on which an entry stands.
enum class EnergySide { stored, put_in, lost, beside };

struct EnergyEntry {
  std::string_view key;      ///< as in files: "time_integration"
  std::string_view label;    ///< for a person: "Time integration"
  std::string_view meaning;  ///< a sentence; all texts end with a zero
  EnergySide side;
  double EnergyAccount::*value;
};

/// All entries in joules, in the order in which tables show them.
std::span<const EnergyEntry> energy_entries();

}  // namespace griffith
