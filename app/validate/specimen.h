#pragma once

#include <functional>
#include <utility>

#include "sim/fracture/resistance.h"
#include "sim/mesh/hex_mesh.h"
#include "sim/scene/scene.h"
#include "sim/world/world.h"

namespace griffith::app {

/// A scene of an experiment, with the meshes that no shape makes.
struct SpecimenScene {
  Scene scene;
  InMemoryMeshes meshes;

  World world() const { return World(scene, meshes); }
};

/// Patterns of boxes by their names in scene files.
inline constexpr std::pair<const char*, BoxPattern> kNamedPatterns[] = {
    {"five_tet", BoxPattern::five_tet}, {"kuhn", BoxPattern::kuhn}, {"bcc", BoxPattern::bcc}};

/// Returns an empty scene without gravity and ground.
Scene empty_laboratory();
/// Returns a preset's material. The key must exist.
Material laboratory_material(const char* key);
/// Gives the scene a body with a mesh from memory. Returns the body.
BodyDescription& add_body(SpecimenScene& specimen, const TetSoup& mesh, const Material& material);

/// Returns the nodes at and beyond `distance` from the origin along `axis` (unit) [m].
HalfSpaceRegion end_region(const Vec3& axis, double distance);
/// Returns a support without motion along `normal`.
Support sliding_support(const Region& region, const Vec3& normal);
/// Returns the supports that keep all nodes of a specimen of this thickness along z from moving along z.
std::vector<Support> plane_strain(double thickness);
/// Returns a traction [Pa] on a region's faces.
Load traction_on(const Region& region, const Vec3& traction);

/// Returns the lowest value in [low, high] for which `breaks` holds, to within a relative tolerance, if it holds above
/// some value and not below; NaN if it holds at `low` already or not even at `high`. `low` > 0.
double lowest_breaking(double low, double high, double tolerance, const std::function<bool(double)>& breaks);

/// Returns a copy of the scene with all loads multiplied by a factor.
SpecimenScene loaded(SpecimenScene specimen, double factor);

/// True if a crack runs through the specimen under its loads: in equilibrium, cracks open more than `area` [m²].
bool fails_statically(const SpecimenScene& specimen, double area);

/// Returns the speed of Rayleigh waves by Viktorov's approximation [m/s].
double rayleigh_wave_speed(const Material& material);

}  // namespace griffith::app
