#pragma once

#include <span>
#include <string_view>

#include "sim/elasticity/material.h"
#include "sim/fracture/separation_tensor.h"

namespace griffith {

/// Load of a node that its resistance limits. An entry of one table, from which evaluation, files, forms and sentences
/// follow.
struct FractureLaw {
  FractureCriterion criterion;
  std::string_view key;      ///< as in a scene file: "strength"
  std::string_view label;    ///< as in a form: "strength surface"
  std::string_view unit;     ///< unit of load and resistance: "Pa" or "N"
  std::string_view meaning;  ///< a phrase for the form
  double Material::*resistance;
  /// Returns the load of a node with that candidate plane [unit].
  double (*load)(const SeparationInput& input, NodeId node, const Material& material, const CandidatePlane& plane);

  /// Further property that selects the law among those of its criterion, where a material has it.
  std::optional<double> Material::*property = nullptr;
  double usual_ratio = 0;  ///< usual value of the property over the resistance

  /// Returns the ratio of strengths of a surface of Drucker & Prager whose equivalent_tension() is nowhere below the
  /// load of an element, for screening; null: loads are at most the largest tension.
  double (*strength_ratio)(const Material& material) = nullptr;

  // Sentences, in which {tension} is the origin of the tension across the plane, {stress} that tension, {load} the load
  // and {property} the value of the property.
  std::string_view origin = "{tension}";  ///< origin of the load
  std::string_view difference = "";       ///< reason why the load differs from the tension; empty: it never does

  /// True if stress decides, so that mean tension, energy at crack fronts and bonds count too; else force does.
  bool is_stress() const { return unit == "Pa"; }
};

/// Returns all laws, in the order of forms.
std::span<const FractureLaw> fracture_laws();
/// Returns the law of a material.
const FractureLaw& fracture_law(const Material& material);
/// Makes a law that of a material. Gives it the usual value of the law's property if it has none.
void adopt(const FractureLaw& law, Material& material);

}  // namespace griffith
