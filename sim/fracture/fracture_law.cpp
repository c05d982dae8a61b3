#include "sim/fracture/fracture_law.h"

#include <array>

#include "sim/elasticity/principal_stress.h"
#include "sim/fracture/strength_surface.h"

namespace griffith {
namespace {

double stress_of_plane(const SeparationInput&, NodeId, const Material&, const CandidatePlane& plane) {
  return plane.stress;
}

double force_on_plane(const SeparationInput&, NodeId, const Material&, const CandidatePlane& plane) {
  return plane.eigenvalue;
}

double ratio_of_strengths(const Material& material) {
  return material.tensile_strength / *material.compressive_strength;
}

/// Returns the equivalent_tension() of the mean stress in which the plane's stress takes the place of the largest
/// principal stress [Pa], >= 0; 0 where the surface lies far away, under pressure.
double equivalent_load(const SeparationInput& input, NodeId node, const Material& material,
                       const CandidatePlane& plane) {
  const Mat3 stress = mean_stress(input, node);
  // The plane's stress is at least the mean tension. Under pressure on all planes it comes on top of the mean stress.
  const double largest = largest_principal(stress).value, replaced = plane.stress + std::min(0.0, largest);
  const double trace = stress.trace() + (replaced - largest),
               squared_norm = stress.squaredNorm() + (replaced * replaced - largest * largest);
  return std::max(0.0, equivalent_tension(trace, squared_norm, ratio_of_strengths(material)));
}

constexpr std::array kLaws = {
    FractureLaw{.criterion = FractureCriterion::strength,
                .key = "strength",
                .label = "strength",
                .unit = "Pa",
                .meaning = "the largest tension decides",
                .resistance = &Material::tensile_strength,
                .load = stress_of_plane},
    FractureLaw{.criterion = FractureCriterion::strength,
                .key = "strength",
                .label = "strength surface",
                .unit = "Pa",
                .meaning = "the whole state of stress, by Drucker and Prager's surface through the tensile and "
                           "compressive strengths",
                .resistance = &Material::tensile_strength,
                .load = equivalent_load,
                .property = &Material::compressive_strength,
                .usual_ratio = 10,  // of concrete and rock
                .strength_ratio = ratio_of_strengths,
                .origin = "equivalent to the stress state, with {stress} across the plane: {tension}",
                .difference = "The stress state decides, not its largest tension: now {stress} across the plane count "
                              "as {load}, by the compressive strength of {property}."},
    FractureLaw{.criterion = FractureCriterion::separation_force,
                .key = "separation_force",
                .label = "separation force",
                .unit = "N",
                .meaning = "the largest eigenvalue of the separation tensor, which depends on the element size",
                .resistance = &Material::separation_toughness,
                .load = force_on_plane,
                .origin = "the tensile force across the plane"},
};

}  // namespace

std::span<const FractureLaw> fracture_laws() { return kLaws; }

const FractureLaw& fracture_law(const Material& material) {
  const FractureLaw* found = nullptr;
  for (const FractureLaw& law : kLaws)
    if (law.criterion == material.criterion && (law.property ? (material.*law.property).has_value() : !found))
      found = &law;
  return *found;
}

void adopt(const FractureLaw& law, Material& material) {
  material.criterion = law.criterion;
  for (const FractureLaw& other : kLaws)
    if (other.criterion == law.criterion && other.property && other.property != law.property)
      (material.*other.property).reset();
  if (law.property && !(material.*law.property)) material.*law.property = law.usual_ratio * material.*law.resistance;
}

}  // namespace griffith
