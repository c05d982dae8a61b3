#pragma once

#include <optional>

#include "sim/mesh/mesh_limits.h"
#include "sim/scene/field.h"
#include "sim/scene/quantities.h"
#include "sim/scene/scene.h"
#include "sim/scene/shape_fields.h"
#include "sim/scene/splinter_fields.h"
#include "sim/scene/view_fields.h"

// Table of all fields of a scene: name, member, values and meaning. An archive (the reader, the writer, the maker of
// the schema) is passed to describe() with a value and gets a call per field:
//   archive.field(name, member, values, description)
//   archive.alternative<T>(name, variant, values, description, projection): the variant may hold a T, which the file
//     shows by its `projection` (itself by default)
//   archive.require(holds, name, problem, remedy): a condition beyond the field's own values
// A field that a file omits keeps the default of its struct.

namespace griffith {

/// Version of the format that this program reads and writes.
inline constexpr int kSceneVersion = 1;

/// Limit of all bursts of a scene together.
inline constexpr std::int64_t kMaxProjectiles = 10'000;

/// Limit of steps, beyond any real run.
inline constexpr double kMaxSteps = 1e9;

inline constexpr Numbers kShotSpeed = between(0, 1e5, "m/s");
inline constexpr Numbers kShotMass = between(1e-6, 1e9, "kg");
inline constexpr Numbers kShotRadius = between(1e-4, 1e4, "m");

/// True if T may be absent, which a file shows as null.
template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <class Archive>
void describe_properties(Archive& archive, Material& m) {
  archive.field("young_modulus", m.young_modulus, between(1, 1e13, "Pa"), "Young's modulus E: stiffness");
  archive.field("poisson_ratio", m.poisson_ratio, between(0, 0.495, "-"), "Poisson's ratio ν");
  archive.field("density", m.density, between(0.01, 1e6, "kg/m³"), "Density ρ");
  archive.field("tensile_strength", m.tensile_strength, between(1e-3, 1e13, "Pa"),
                "Tensile strength σ_t: a node separates above it (criterion \"strength\")");
  archive.field("compressive_strength", m.compressive_strength, between(1e-3, 1e13, "Pa"),
                "Compressive strength σ_c: the stress state decides, by Drucker and Prager's surface through both "
                "strengths; null: the largest tension decides");
  archive.require(!m.compressive_strength || *m.compressive_strength >= m.tensile_strength, "compressive_strength",
                  "is below the tensile strength", "raise it, or remove it: the largest tension decides then");
  archive.field("fracture_toughness", m.fracture_toughness, between(1e-3, 1e13, "Pa·√m"),
                "Fracture toughness K_Ic: limits the resistance at crack fronts");
  archive.field("separation_toughness", m.separation_toughness, between(1e-6, 1e15, "N"),
                "Separation toughness τ: only used by the criterion \"separation_force\"");
  archive.field("criterion", m.criterion, OneOf{{"strength", "separation_force"}},
                "Load compared with the resistance: a stress (independent of the mesh) or the raw eigenvalue");
  archive.field("element_model", m.element_model, OneOf{{"corotational", "green_strain"}},
                "Strain measure of elements: linear and rotating with the element, or Green's strain");
  archive.field("yield_strength", m.yield_strength, between(1e-3, 1e13, "Pa"),
                "Yield strength: the von Mises stress above which it flows; null: brittle, no flow");
  archive.field("plastic_limit", m.plastic_limit, between(0, 1, "-"),
                "Plastic limit γ₂: the norm of the plastic strain at which flow ends");
  archive.field("friction", m.friction, between(0, 10, "-"), "Coulomb's coefficient of friction");
  archive.field("restitution", m.restitution, between(0, 1, "-"),
                "Coefficient of restitution of impacts too slow to cause damage; faster ones rebound by their waves");
  archive.field("mass_damping", m.mass_damping, between(0, 1e6, "1/s"), "Rayleigh damping α, proportional to mass");
  archive.field("stiffness_damping", m.stiffness_damping, between(0, 1e3, "s"),
                "Rayleigh damping β, proportional to stiffness");
}

template <class Archive>
void describe(Archive& archive, Material& m) {
  archive.field("name", m.name, Text{1}, "Name of the material");
  describe_properties(archive, m);
}

template <class Archive>
void describe(Archive& archive, BoxRegion& box) {
  archive.field("minimum", box.minimum, kPlace, "Lower corner");
  archive.field("maximum", box.maximum, kPlace, "Upper corner");
  archive.require((box.minimum.array() <= box.maximum.array()).all(), "maximum", "is below the minimum",
                  "each component of maximum must be at least that of minimum");
}

template <class Archive>
void describe(Archive& archive, SphereRegion& sphere) {
  archive.field("center", sphere.center, kPlace, "Center");
  archive.field("radius", sphere.radius, between(0, 1e6, "m"), "Radius");
}

template <class Archive>
void describe(Archive& archive, HalfSpaceRegion& half_space) {
  archive.field("point", half_space.point, kPlace, "Point of the bounding plane");
  archive.field("normal", half_space.normal, kDirection, "Normal into the region; any length but 0");
}

template <class Archive>
void describe(Archive& archive, Region& region) {
  archive.template alternative<BoxRegion>("box", region, Parts{}, "Box along the axes of the body's rest space");
  archive.template alternative<SphereRegion>("sphere", region, Parts{}, "Sphere");
  archive.template alternative<HalfSpaceRegion>("half_space", region, Parts{}, "Half-space on one side of a plane");
  archive.template alternative<NodeListRegion>("nodes", region, between(0, 2147483647),
                                               "Nodes by their index in the body's mesh", &NodeListRegion::nodes);
}

template <class Archive>
void describe(Archive& archive, Support& support) {
  archive.field("region", support.region, Parts{}, "Supported nodes, in the body's rest space");
  archive.field("kind", support.kind, OneOf{{"fixed", "sliding", "prescribed"}},
                "Kind of support: no motion, sliding in a plane, or a prescribed velocity");
  archive.field("normal", support.normal, kDirection,
                "Normal of the plane of a sliding support, in world axes; any length but 0");
  archive.field("velocity", support.velocity, between(-1e5, 1e5, "m/s"),
                "Velocity of the nodes of a prescribed support, in world axes");
  archive.field("can_tear", support.can_tear, Flag{}, "The body tears off where its material fails there");
  archive.field("stop", support.stop, between(0, 1e6, "s"), "Time at which a prescribed support stops; null: never");
  archive.require(support.kind == SupportKind::sliding || support.normal == Support{}.normal, "normal",
                  "belongs to another kind of support", "add \"kind\": \"sliding\" or remove it");
  archive.require(support.kind == SupportKind::prescribed || support.velocity.isZero(0), "velocity",
                  "belongs to another kind of support", "add \"kind\": \"prescribed\" or remove it");
  archive.require(support.kind == SupportKind::prescribed || !support.stop, "stop",
                  "belongs to another kind of support", "add \"kind\": \"prescribed\" or remove it");
}

template <class Archive>
void describe(Archive& archive, Load& load) {
  constexpr const char* kProblem = "belongs to another kind of load";
  archive.field("region", load.region, Parts{}, "Loaded region, in the body's rest space");
  archive.field("kind", load.kind, OneOf{{"point_force", "traction", "pressure", "body_force"}}, "Kind of load");
  archive.field("force", load.force, between(-1e12, 1e12, "N"),
                "Total force of a point force, in equal parts on the region's nodes");
  archive.field("traction", load.traction, between(-1e12, 1e12, "Pa"),
                "Force of a traction per undeformed area, on surface faces with all nodes in the region");
  archive.field("pressure", load.pressure, between(-1e12, 1e12, "Pa"),
                "Pressure on such faces, inward, following their rotation");
  archive.field("acceleration", load.acceleration, between(-1e6, 1e6, "m/s²"),
                "Acceleration by a body force, as by gravity, of tetrahedra with all nodes in the region");
  archive.field("start", load.start, between(0, 1e6, "s"), "Start of the load");
  archive.field("duration", load.duration, between(1e-6, 1e6, "s"), "Duration of the load; null: forever");
  archive.field("ramp", load.ramp, between(0, 1e6, "s"), "Time of linear growth to the full load");
  archive.require(load.kind == LoadKind::point_force || load.force.isZero(0), "force", kProblem,
                  "add \"kind\": \"point_force\" or remove it");
  archive.require(load.kind == LoadKind::traction || load.traction.isZero(0), "traction", kProblem,
                  "add \"kind\": \"traction\" or remove it");
  archive.require(load.kind == LoadKind::pressure || load.pressure == 0, "pressure", kProblem,
                  "add \"kind\": \"pressure\" or remove it");
  archive.require(load.kind == LoadKind::body_force || load.acceleration.isZero(0), "acceleration", kProblem,
                  "add \"kind\": \"body_force\" or remove it");
}

template <class Archive>
void describe(Archive& archive, Weakness& weakness) {
  archive.field(
      "kind", weakness.kind, OneOf{{"grain", "layers"}},
      "grain: planes that contain the direction are weak, as in wood; layers: planes normal to it, as in slate");
  archive.field("direction", weakness.direction, kDirection, "Direction in the body's rest space; any length but 0");
  archive.field("strength_ratio", weakness.strength_ratio, between(1e-4, 1, "-"),
                "Resistance of the weak planes over that of the strongest, which is the material's");
}

template <class Archive>
void describe(Archive& archive, StrengthScatter& scatter) {
  archive.field("weibull_modulus", scatter.weibull_modulus, between(1, 1000, "-"),
                "Weibull's m: smaller values scatter more; glass and ceramics 5 to 20");
  archive.field("reference_volume", scatter.reference_volume, between(1e-15, 1e9, "m³"),
                "Volume of the specimens whose mean strength is tensile_strength; larger bodies are weaker");
  archive.field("seed", scatter.seed, between(0, 2147483647), "Seed of the random numbers");
}

template <class Archive>
void describe(Archive& archive, ParabolicStress& stress) {
  archive.field("normal", stress.normal, kDirection, "Direction of the thickness in the body's rest space");
  archive.field("surface_stress", stress.surface_stress, between(-1e12, 1e12, "Pa"),
                "Stress at both surfaces, negative in tempered glass; in the middle it is half as large and opposite");
}

template <class Archive>
void describe(Archive& archive, UniformStrain& uniform) {
  archive.field("strain", uniform.strain, between(-0.02, 0.02, "-"), "Strain along x, y, z of the body's rest space");
  archive.field("shear", uniform.shear, between(-0.02, 0.02, "-"), "Components yz, xz, xy of the strain tensor");
}

template <class Archive>
void describe(Archive& archive, StrainFile& file) {
  archive.field("path", file.path, MeshPath{"file of strains"},
                "Text file with xx, yy, zz, yz, xz, xy for each tetrahedron of the mesh; relative to the scene file's "
                "folder");
}

template <class Archive>
void describe(Archive& archive, ResidualStress& stress) {
  archive.template alternative<ParabolicStress>("parabolic", stress, Parts{},
                                                "Parabolic through the thickness, as in tempered glass");
  archive.template alternative<UniformStrain>("uniform", stress, Parts{},
                                              "The same strain everywhere, such as thermal strain");
  archive.template alternative<StrainFile>("file", stress, Parts{}, "Strain of each tetrahedron from a file");
}

template <class Archive>
void describe(Archive& archive, BodyDescription& body) {
  archive.field("name", body.name, Text{1}, "Name, different from every other body's");
  archive.field("shape", body.shape, Parts{}, "Geometry");
  archive.field("position", body.position, kPlace, "Position of the shape's origin");
  archive.field("rotation_degrees", body.rotation_degrees, between(-1e6, 1e6, "degrees"),
                "Rotation about the fixed x, then y, then z axis");
  archive.field("velocity", body.velocity, between(-1e5, 1e5, "m/s"), "Initial velocity, where supports allow it");
  archive.field("angular_velocity", body.angular_velocity, between(-1e5, 1e5, "rad/s"),
                "Initial angular velocity about the center of mass");
  archive.field("material", body.material, MaterialChoice{},
                "Name of a preset or of one of the scene's materials, or an object with its properties");
  archive.field(
      "elements", body.elements, OneOf{{"auto", "linear", "quadratic"}},
      "Order of displacements in tetrahedra: linear ones are cheap, quadratic ones bend correctly where few lie across "
      "the body; auto: quadratic if it is slender and fewer than four lie across its thinnest part");
  archive.field("remeshing", body.remeshing, Flag{},
                "Cracks cut tetrahedra along their plane; false: they follow faces");
  archive.field("minimum_element_size", body.minimum_element_size, between(0, 1e6, "m"),
                "Shortest edge of remeshing; 0: a quarter of the initial element size");
  archive.field("weakness", body.weakness, Parts{}, "Direction in which it is weaker; null: none");
  archive.field("strength_scatter", body.strength_scatter, Parts{}, "Random strength from flaws; null: none");
  archive.field("residual_stress", body.residual_stress, Parts{},
                "Stress without loads, as a strain without stress of each tetrahedron; null: none");
  archive.field("supports", body.supports, Parts{}, "Supported regions");
  archive.field("loads", body.loads, Parts{}, "Loads on regions");
  archive.field("splinters", body.splinters, Parts{},
                "Visible fragments instead of its tetrahedra; they do not affect the simulation unless \"collision\" "
                "uses them");
  archive.field("collision", body.collision, OneOf{{"elements", "splinters"}},
                "Shape in contacts: its tetrahedra, or the splinters of pieces that have at most 256 of them");
  archive.require(!body.remeshing || !body.splinters, "remeshing", "is set together with splinters",
                  "remove one of them: splinters need unchanged tetrahedra");
  archive.require(body.collision == CollisionShape::elements || body.splinters, "splinters",
                  "are missing, but \"collision\" uses them", "add some to the body, or remove the collision");
}

template <class Archive>
void describe(Archive& archive, BoxProjectile& box) {
  archive.field("size", box.size, between(1e-4, 1e4, "m"), "Edge lengths along x, y, z");
}

template <class Archive>
void describe(Archive& archive, SurfaceProjectile& surface) {
  archive.field("path", surface.path, MeshPath{"surface"},
                "Surface: .obj, .stl, .ply, .off, .gltf or .glb; relative to the scene file's folder");
  archive.field("scale", surface.scale, between(1e-9, 1e6), "Meters per unit of the file");
}

template <class Archive>
void describe(Archive& archive, ProjectileShape& shape) {
  archive.template alternative<BoxProjectile>("box", shape, Parts{}, "Box");
  archive.template alternative<PointsProjectile>("points", shape, between(-1e4, 1e4, "m"),
                                                 "Convex hull of at least four points, not all in a plane",
                                                 &PointsProjectile::points);
  archive.template alternative<SurfaceProjectile>("surface", shape, Parts{}, "Convex hull of a surface's points");
  const auto* hull = std::get_if<PointsProjectile>(&shape);
  archive.require(!hull || span_volume(hull->points), "points", "span no volume",
                  "give at least four points that do not lie in one plane");
}

template <class Archive>
void describe(Archive& archive, ProjectileBurst& burst) {
  archive.field("count", burst.count, between(1, 10000), "Number of projectiles");
  archive.field("interval", burst.interval, between(0, 1e4, "s"), "Time between two projectiles");
  archive.field("start", burst.start, between(0, 1e6, "s"), "Launch of the first projectile");
  archive.field("position", burst.position, kPlace, "Initial position of the center of mass");
  archive.field("direction", burst.direction, kDirection, "Direction of flight; any length but 0");
  archive.field("speed", burst.speed, kShotSpeed, "Speed at launch");
  archive.field("mass", burst.mass, kShotMass, "Mass");
  archive.field("radius", burst.radius, kShotRadius, "Radius of a sphere");
  archive.field("density", burst.density, between(0.01, 1e6, "kg/m³"),
                "Density that sets the mass in place of \"mass\"; null: none");
  archive.field("shape", burst.shape, Parts{}, "Shape; null: a sphere");
  archive.field("rotation_degrees", burst.rotation_degrees, between(-1e6, 1e6, "degrees"),
                "Rotation at launch about the fixed x, then y, then z axis");
  archive.field("angular_velocity", burst.angular_velocity, between(-1e4, 1e4, "rad/s"), "Angular velocity at launch");
  archive.field("friction", burst.friction, between(0, 10, "-"), "Coulomb's coefficient of friction");
  archive.field("restitution", burst.restitution, between(0, 1, "-"), "Coefficient of restitution; 1: no loss");
  archive.require(!burst.density || burst.mass == ProjectileBurst{}.mass, "density", "is set together with a mass",
                  "remove one of them");
  archive.require(!burst.shape || burst.radius == ProjectileBurst{}.radius, "radius", "is set together with a shape",
                  "remove one of them: only spheres have a radius");
}

template <class Archive>
void describe(Archive& archive, Ground& ground) {
  archive.field("height", ground.height, kPlace, "Height of the plane; everything below is solid");
  archive.field("friction", ground.friction, between(0, 10, "-"), "Coulomb's coefficient of friction");
  archive.field("restitution", ground.restitution, between(0, 1, "-"), "Coefficient of restitution");
}

template <class Archive>
void describe(Archive& archive, SimulationSettings& settings) {
  archive.field("time_step", settings.time_step, between(1e-5, 0.1, "s"), "Time step");
  archive.field(
      "integrator", settings.integrator, OneOf{{"implicit", "hybrid", "explicit"}},
      "Time integration of bodies: by a linear system (implicit), with microsteps in bodies that are hit or crack "
      "(hybrid), or only by small steps as stability requires (explicit)");
  archive.field("static_start", settings.static_start, Flag{},
                "Supported bodies start in equilibrium with gravity and their loads at time 0");
  archive.field("impact_substeps", settings.impact_substeps, between(1, 256),
                "Equilibria of a static step, one after each round of cracks");
  archive.field(
      "step_budget", settings.step_budget, between(0.1, 1e6, "ms"),
      "Work of a step on waves, as time on a typical core; counted, not timed. Bodies that need more are scaled: "
      "softer, weaker and slower, so that they break alike");
  archive.field("relative_residual", settings.relative_residual, between(1e-12, 0.1, "-"),
                "Residual at which the linear solver stops, relative to the right-hand side");
  archive.field("max_solver_iterations", settings.max_solver_iterations, between(1, 100000),
                "Iterations at which the linear solver stops, per body and substep");
  archive.field("fracture", settings.fracture, Flag{}, "Bodies can break");
  archive.field("max_cracks_per_step", settings.max_cracks_per_step, between(1, 1000000),
                "Largest number of nodes split in a step; the rest waits for the next step");
  archive.field("min_fragment_tets", settings.min_fragment_tets, between(1, 1000),
                "Smallest number of tetrahedra that a split may cut off");
}

template <class Archive>
void describe(Archive& archive, ProbePlace& place) {
  archive.template alternative<ProbePoint>("point", place, kPlace,
                                           "Point of the body's rest space; outside, the nearest one of the body",
                                           &ProbePoint::point);
  archive.template alternative<ProbeNode>("node", place, between(0, 2147483647), "Node by its index in the body's mesh",
                                          &ProbeNode::node);
  archive.template alternative<Region>("region", place, Parts{}, "Mean over a region's nodes");
}

template <class Archive>
void describe(Archive& archive, Probe& probe) {
  archive.field("name", probe.name, Text{1}, "Name, different from every other probe's: its columns start with it");
  archive.field("body", probe.body, Text{1}, "Name of a body");
  archive.field("at", probe.at, Parts{}, "Place of the measurement");
  archive.field("quantities", probe.quantities, OneOf{keys_of(probe_quantities())}, "Measured quantities");
}

template <class Archive>
void describe(Archive& archive, Scene& scene) {
  archive.field("name", scene.name, Text{}, "Name of the scene");
  archive.field("description", scene.description, Text{}, "Description of the scene");
  archive.field("gravity", scene.gravity, between(-1e4, 1e4, "m/s²"), "Gravity; y is up");
  archive.field("ground", scene.ground, Parts{}, "Horizontal plane; null: none");
  archive.field("bodies", scene.bodies, Parts{}, "Bodies, which can break");
  archive.field("projectiles", scene.projectiles, Parts{}, "Bursts of rigid projectiles");
  archive.field("analysis", scene.analysis, OneOf{{"dynamic", "static"}},
                "Motion in time, or equilibrium with the loads at each time");
  archive.field("simulation", scene.simulation, Parts{}, "Settings of a step");
  archive.field("probes", scene.probes, Parts{}, "Measurements in every frame");
  archive.field("cameras", scene.cameras, Parts{}, "Views; the first is used unless another is named");
  archive.field("view", scene.view, Parts{}, "Initial view; it does not affect the simulation");
  double tets = 0;
  for (const BodyDescription& body : scene.bodies) tets += tet_count(body.shape);
  archive.require(tets <= static_cast<double>(kMaxTets), "bodies", "have more than 4 million tetrahedra in total",
                  "use larger element sizes or fewer bodies");
  std::int64_t projectiles = 0;
  for (const ProjectileBurst& burst : scene.projectiles) projectiles += burst.count;
  archive.require(projectiles <= kMaxProjectiles, "projectiles", "are more than 10,000 in total", "use smaller counts");
}

}  // namespace griffith
