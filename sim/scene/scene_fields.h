#pragma once

#include <optional>

#include "sim/mesh/mesh_limits.h"
#include "sim/scene/field.h"
#include "sim/scene/scene.h"
#include "sim/scene/shape_fields.h"
#include "sim/scene/splinter_fields.h"
#include "sim/scene/view_quantity.h"
#include "sim/scene/world_input.h"

// The table of all fields of a scene: name, member, values and meaning. An archive (the reader, the writer, the
// maker of the schema) is handed to describe() with a value and gets a call per field:
//   archive.field(name, member, values, description)
//   archive.alternative<T>(name, variant, values, description, projection): the variant may hold a T, whose
//     `projection` (itself, unless given) is what the file shows
//   archive.require(holds, name, problem, remedy): what must hold beyond the field's own values
// A field that a file leaves out keeps the default of its struct.

namespace griffith {

/// The format that this program reads and writes.
inline constexpr int kSceneVersion = 1;

/// Limit of all bursts of a scene together.
inline constexpr std::int64_t kMaxProjectiles = 10'000;

/// More steps than anybody makes.
inline constexpr double kMaxSteps = 1e9;

inline constexpr Numbers kPlace = between(-1e6, 1e6, "m");
inline constexpr Numbers kShotSpeed = between(0, 1e5, "m/s");
inline constexpr Numbers kShotMass = between(1e-6, 1e9, "kg");
inline constexpr Numbers kShotRadius = between(1e-4, 1e4, "m");
inline constexpr Numbers kDirection = {.minimum = -1e6, .maximum = 1e6, .unit = "-", .nonzero = true};

/// Whether T may be absent, which a file shows as null.
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
  archive.field("fracture_toughness", m.fracture_toughness, between(1e-3, 1e13, "Pa·√m"),
                "Fracture toughness K_Ic: lowers the resistance at a crack's front");
  archive.field("separation_toughness", m.separation_toughness, between(1e-6, 1e15, "N"),
                "Separation toughness τ: used by the criterion \"separation_force\" alone");
  archive.field("criterion", m.criterion, OneOf{{"strength", "separation_force"}},
                "What is compared with the resistance: a stress (the same on every mesh) or the raw eigenvalue");
  archive.field("element_model", m.element_model, OneOf{{"corotational", "green_strain"}},
                "How elements measure strain: linear and turning with the element, or Green's strain");
  archive.field("yield_strength", m.yield_strength, between(1e-3, 1e13, "Pa"),
                "Yield strength: the von Mises stress above which it flows; null: brittle, it never flows");
  archive.field("plastic_limit", m.plastic_limit, between(0, 1, "-"),
                "Plastic limit γ₂: the norm of the plastic strain at which flow ends");
  archive.field("friction", m.friction, between(0, 10, "-"), "Coulomb's coefficient of friction");
  archive.field("restitution", m.restitution, between(0, 1, "-"), "Coefficient of restitution: 1 bounces back fully");
  archive.field("mass_damping", m.mass_damping, between(0, 1e6, "1/s"), "Rayleigh damping α, in proportion to mass");
  archive.field("stiffness_damping", m.stiffness_damping, between(0, 1e3, "s"),
                "Rayleigh damping β, in proportion to stiffness");
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
  archive.require((box.minimum.array() <= box.maximum.array()).all(), "maximum", "lies below the minimum",
                  "each component of maximum has to be at least that of minimum");
}

template <class Archive>
void describe(Archive& archive, SphereRegion& sphere) {
  archive.field("center", sphere.center, kPlace, "Centre");
  archive.field("radius", sphere.radius, between(0, 1e6, "m"), "Radius");
}

template <class Archive>
void describe(Archive& archive, HalfSpaceRegion& half_space) {
  archive.field("point", half_space.point, kPlace, "A point of the bounding plane");
  archive.field("normal", half_space.normal, kDirection, "Into the region; any length but 0");
}

template <class Archive>
void describe(Archive& archive, Region& region) {
  archive.template alternative<BoxRegion>("box", region, Parts{}, "A box along the axes of the body's rest space");
  archive.template alternative<SphereRegion>("sphere", region, Parts{}, "A ball");
  archive.template alternative<HalfSpaceRegion>("half_space", region, Parts{}, "Everything on one side of a plane");
  archive.template alternative<NodeListRegion>("nodes", region, between(0, 2147483647),
                                               "Nodes by their index in the body's mesh", &NodeListRegion::nodes);
}

template <class Archive>
void describe(Archive& archive, Support& support) {
  archive.field("region", support.region, Parts{}, "The nodes that are held, in the body's rest space");
  archive.field("kind", support.kind, OneOf{{"fixed", "sliding", "prescribed"}}, "What the nodes may do");
  archive.field("normal", support.normal, kDirection,
                "Of the plane in which a sliding support lets its nodes move, in the world's axes; any length but 0");
  archive.field("velocity", support.velocity, between(-1e5, 1e5, "m/s"),
                "With which a prescribed support moves its nodes, in the world's axes");
  archive.field("can_tear", support.can_tear, Flag{}, "Whether the body tears off it where its material fails there");
  archive.field("stop", support.stop, between(0, 1e6, "s"), "When a prescribed support comes to a halt; null: never");
  archive.require(support.kind == SupportKind::sliding || support.normal == Support{}.normal, "normal",
                  "belongs to another kind of support", "add \"kind\": \"sliding\" or take it out");
  archive.require(support.kind == SupportKind::prescribed || support.velocity.isZero(0), "velocity",
                  "belongs to another kind of support", "add \"kind\": \"prescribed\" or take it out");
  archive.require(support.kind == SupportKind::prescribed || !support.stop, "stop",
                  "belongs to another kind of support", "add \"kind\": \"prescribed\" or take it out");
}

template <class Archive>
void describe(Archive& archive, Load& load) {
  constexpr const char* kProblem = "belongs to another kind of load";
  archive.field("region", load.region, Parts{}, "What is loaded, in the body's rest space");
  archive.field("kind", load.kind, OneOf{{"point_force", "traction", "pressure", "body_force"}}, "What acts there");
  archive.field("force", load.force, between(-1e12, 1e12, "N"),
                "Of a point force: in all, in equal parts on the region's nodes");
  archive.field("traction", load.traction, between(-1e12, 1e12, "Pa"),
                "Of a traction: on the surface whose nodes all lie in the region, per undeformed area");
  archive.field("pressure", load.pressure, between(-1e12, 1e12, "Pa"),
                "Of a pressure: against that surface, inwards, wherever it turns");
  archive.field("acceleration", load.acceleration, between(-1e6, 1e6, "m/s²"),
                "Of a body force: of the tetrahedra whose nodes all lie in the region, as by gravity");
  archive.field("start", load.start, between(0, 1e6, "s"), "When it begins to act");
  archive.field("duration", load.duration, between(1e-6, 1e6, "s"), "How long it acts; null: for ever");
  archive.field("ramp", load.ramp, between(0, 1e6, "s"), "How long it takes to grow to its full size");
  archive.require(load.kind == LoadKind::point_force || load.force.isZero(0), "force", kProblem,
                  "add \"kind\": \"point_force\" or take it out");
  archive.require(load.kind == LoadKind::traction || load.traction.isZero(0), "traction", kProblem,
                  "add \"kind\": \"traction\" or take it out");
  archive.require(load.kind == LoadKind::pressure || load.pressure == 0, "pressure", kProblem,
                  "add \"kind\": \"pressure\" or take it out");
  archive.require(load.kind == LoadKind::body_force || load.acceleration.isZero(0), "acceleration", kProblem,
                  "add \"kind\": \"body_force\" or take it out");
}

template <class Archive>
void describe(Archive& archive, Weakness& weakness) {
  archive.field("kind", weakness.kind, OneOf{{"grain", "layers"}},
                "grain: planes that contain the direction are weak, as in wood; layers: planes across it, as in slate");
  archive.field("direction", weakness.direction, kDirection, "In the body's rest space; any length but 0");
  archive.field("strength_ratio", weakness.strength_ratio, between(1e-4, 1, "-"),
                "Resistance of the weak planes over that of the strongest, which the material gives");
}

template <class Archive>
void describe(Archive& archive, StrengthScatter& scatter) {
  archive.field("weibull_modulus", scatter.weibull_modulus, between(1, 1000, "-"),
                "Weibull's m: the smaller, the wider the scatter; glass and ceramics 5 to 20");
  archive.field("reference_volume", scatter.reference_volume, between(1e-15, 1e9, "m³"),
                "Volume of the specimens whose mean strength is tensile_strength; larger bodies are weaker");
  archive.field("seed", scatter.seed, between(0, 2147483647), "Of the random numbers: another seed, another body");
}

template <class Archive>
void describe(Archive& archive, BodyDescription& body) {
  archive.field("name", body.name, Text{1}, "Name, different from every other body's");
  archive.field("shape", body.shape, Parts{}, "Geometry");
  archive.field("position", body.position, kPlace, "Where the shape's origin stands");
  archive.field("rotation_degrees", body.rotation_degrees, between(-1e6, 1e6, "degrees"),
                "Rotation about the fixed x, then y, then z axis");
  archive.field("velocity", body.velocity, between(-1e5, 1e5, "m/s"), "Velocity at the start");
  archive.field("angular_velocity", body.angular_velocity, between(-1e5, 1e5, "rad/s"),
                "Angular velocity at the start, about the centre of mass");
  archive.field("material", body.material, MaterialChoice{},
                "Name of a preset or of one of the scene's materials, or an object with its properties");
  archive.field("elements", body.elements, OneOf{{"auto", "linear", "quadratic"}},
                "Displacements within its tetrahedra: linear ones are cheap, quadratic ones bend right where few lie "
                "across the body; auto: quadratic where fewer than four lie across its thinnest part");
  archive.field("remeshing", body.remeshing, Flag{},
                "Cracks cut tetrahedra along their plane; false: they follow faces");
  archive.field("minimum_element_size", body.minimum_element_size, between(0, 1e6, "m"),
                "Shortest edge that remeshing makes; 0: a quarter of the size of the first elements");
  archive.field("weakness", body.weakness, Parts{}, "A direction in which it is weaker; null: none");
  archive.field("strength_scatter", body.strength_scatter, Parts{}, "Random strength from flaws; null: none");
  archive.field("supports", body.supports, Parts{}, "Regions that are held");
  archive.field("loads", body.loads, Parts{}, "Forces on regions");
  archive.field("splinters", body.splinters, Parts{},
                "What it is seen to break into, instead of its tetrahedra; nothing of the simulation depends on it but "
                "what \"collision\" says");
  archive.field("collision", body.collision, OneOf{{"elements", "splinters"}},
                "What touches other bodies: its tetrahedra, or the splinters of pieces that have at most 256 of them");
  archive.require(!body.remeshing || !body.splinters, "remeshing", "is asked for beside splinters",
                  "take one of them out: splinters are carried by the tetrahedra as they are");
  archive.require(body.collision == CollisionShape::elements || body.splinters, "splinters",
                  "are missing, but \"collision\" asks for them", "give the body some, or take the collision out");
}

template <class Archive>
void describe(Archive& archive, BoxProjectile& box) {
  archive.field("size", box.size, between(1e-4, 1e4, "m"), "Edge lengths along x, y, z");
}

template <class Archive>
void describe(Archive& archive, SurfaceProjectile& surface) {
  archive.field("path", surface.path, MeshPath{"surface"},
                "Surface: .obj, .stl, .ply, .off, .gltf or .glb; relative to the scene file's folder");
  archive.field("scale", surface.scale, between(1e-9, 1e6), "Metres per unit of the file");
}

template <class Archive>
void describe(Archive& archive, ProjectileShape& shape) {
  archive.template alternative<BoxProjectile>("box", shape, Parts{}, "A box");
  archive.template alternative<PointsProjectile>("points", shape, between(-1e4, 1e4, "m"),
                                                 "The convex hull of at least four points, not all in a plane",
                                                 &PointsProjectile::points);
  archive.template alternative<SurfaceProjectile>("surface", shape, Parts{}, "The convex hull of a surface's points");
  const auto* hull = std::get_if<PointsProjectile>(&shape);
  archive.require(!hull || span_volume(hull->points), "points", "span no volume",
                  "give at least four points that do not lie in one plane");
}

template <class Archive>
void describe(Archive& archive, ProjectileBurst& burst) {
  archive.field("count", burst.count, between(1, 10000), "Number of projectiles");
  archive.field("interval", burst.interval, between(0, 1e4, "s"), "Time between two of them");
  archive.field("start", burst.start, between(0, 1e6, "s"), "When the first one is launched");
  archive.field("position", burst.position, kPlace, "Where the centre of mass starts");
  archive.field("direction", burst.direction, kDirection, "Direction of flight; any length but 0");
  archive.field("speed", burst.speed, kShotSpeed, "Speed at launch");
  archive.field("mass", burst.mass, kShotMass, "Mass");
  archive.field("radius", burst.radius, kShotRadius, "Radius of a sphere");
  archive.field("density", burst.density, between(0.01, 1e6, "kg/m³"),
                "Says the mass in place of \"mass\"; null: it does not");
  archive.field("shape", burst.shape, Parts{}, "Another shape than a sphere; null: a sphere");
  archive.field("rotation_degrees", burst.rotation_degrees, between(-1e6, 1e6, "degrees"),
                "Rotation at launch about the fixed x, then y, then z axis");
  archive.field("angular_velocity", burst.angular_velocity, between(-1e4, 1e4, "rad/s"), "Spin at launch");
  archive.field("friction", burst.friction, between(0, 10, "-"), "Coulomb's coefficient of friction");
  archive.field("restitution", burst.restitution, between(0, 1, "-"),
                "Coefficient of restitution: 1 bounces back fully");
  archive.require(!burst.density || burst.mass == ProjectileBurst{}.mass, "density", "stands beside a mass",
                  "take one of them out");
  archive.require(!burst.shape || burst.radius == ProjectileBurst{}.radius, "radius", "stands beside another shape",
                  "take one of them out: spheres alone have a radius");
}

template <class Archive>
void describe(Archive& archive, MaterialChange& change) {
  archive.field("scene_body", change.scene_body, between(0, 10000), "Index of the body in the scene");
  archive.field("material", change.material, MaterialChoice{}, "What it is made of from then on");
}

template <class Archive>
void describe(Archive& archive, WorldInput& input) {
  archive.field("step", input.step, between(0, kMaxSteps), "Steps made before it");
  archive.template alternative<ProjectileBurst>("fire", input.action, Parts{}, "A burst, its start counted from then");
  archive.template alternative<MaterialChange>("set_material", input.action, Parts{}, "Another material");
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
      "How bodies move through a step: by a linear system (implicit), by that and by microsteps in bodies that are "
      "struck or crack (hybrid), or by as many small steps as stability asks for (explicit)");
  archive.field("static_start", settings.static_start, Flag{},
                "Whether supported bodies start at rest under gravity and their loads at time 0");
  archive.field("impact_substeps", settings.impact_substeps, between(1, 256),
                "Equilibria of a static step, one after each round of cracks");
  archive.field(
      "step_budget", settings.step_budget, between(0.1, 1e6, "ms"),
      "Work that a step may do to follow waves, as time on a usual core; counted, not timed. Where they ask for more, "
      "bodies are scaled: softer, weaker and slower, so that they break alike");
  archive.field("relative_residual", settings.relative_residual, between(1e-12, 0.1, "-"),
                "The linear solver stops at this residual, relative to the right-hand side");
  archive.field("max_solver_iterations", settings.max_solver_iterations, between(1, 100000),
                "The linear solver stops after as many iterations, per body and substep");
  archive.field("fracture", settings.fracture, Flag{}, "Whether bodies break");
  archive.field("max_cracks_per_step", settings.max_cracks_per_step, between(1, 1000000),
                "Most nodes split in a step; what is over waits for the next step");
  archive.field("min_fragment_tets", settings.min_fragment_tets, between(1, 1000),
                "A split that would part off fewer tetrahedra does not happen");
}

template <class Archive>
void describe(Archive& archive, ProbePlace& place) {
  archive.template alternative<ProbePoint>("point", place, kPlace,
                                           "A point of the body's rest space; the nearest of the body if outside",
                                           &ProbePoint::point);
  archive.template alternative<ProbeNode>("node", place, between(0, 2147483647),
                                          "A node by its index in the body's mesh", &ProbeNode::node);
  archive.template alternative<Region>("region", place, Parts{}, "The mean over a region's nodes");
}

template <class Archive>
void describe(Archive& archive, Probe& probe) {
  archive.field("name", probe.name, Text{1}, "Name, different from every other probe's: its columns start with it");
  archive.field("body", probe.body, Text{1}, "Name of a body");
  archive.field("at", probe.at, Parts{}, "Where it measures");
  archive.field("quantities", probe.quantities,
                OneOf{{"displacement", "velocity", "stress", "principal_stress", "separation", "reaction"}},
                "What it measures");
}

template <class Archive>
void describe(Archive& archive, Camera& camera) {
  archive.field("name", camera.name, Text{1}, "Name, different from every other camera's");
  archive.field("position", camera.position, kPlace, "Where the eye is");
  archive.field("target", camera.target, kPlace, "What it looks at");
  archive.field("field_of_view_degrees", camera.field_of_view_degrees, between(5, 120, "degrees"),
                "Vertical angle of view");
  archive.require(camera.position != camera.target, "target", "is the camera's own position",
                  "move the target or the position");
}

template <class Archive>
void describe(Archive& archive, SlicePlane& slice) {
  archive.field("normal", slice.normal, kDirection, "Towards what is hidden; any length but 0");
  archive.field("offset", slice.offset, kPlace, "Distance of the plane from the origin along the normal");
}

template <class Archive>
void describe(Archive& archive, ViewSettings& view) {
  Numbers range = between(-1e15, 1e15);
  range.ascending = true;
  OneOf quantities;
  for (const ViewQuantity& quantity : view_quantities()) quantities.names.push_back(quantity.key);
  quantities.renamed = {{"margin", "utilization"}};
  OneOf layers;
  for (const ViewLayerInfo& layer : view_layers()) layers.names.push_back(layer.key);
  const auto maps = color_map_names(), styles = element_style_names(), qualities = picture_quality_names();
  archive.field("quantity", view.quantity, quantities, "What the colours show");
  archive.field("color_map", view.color_map, OneOf{{maps.begin(), maps.end()}},
                "Colours from low to high; automatic: coolwarm about 0 for what has a sign, else viridis");
  archive.field("range", view.range, range,
                "Values at the two ends of the colours, in the quantity's unit; null: automatic");
  archive.field("symmetric", view.symmetric, Flag{}, "Whether the automatic range reaches as far below 0 as above");
  archive.field("quality", view.quality, OneOf{{qualities.begin(), qualities.end()}},
                "Light and effects: draft is the fastest; standard and high have soft shadows, ambient occlusion and "
                "see-through glass");
  archive.field("shading", view.shading, Flag{},
                "Whether light falls on scalars; without, a pixel has exactly the legend's colour");
  archive.field("edges", view.edges, Flag{},
                "Whether element edges are drawn, where tetrahedra are: not in natural colours with splinters");
  archive.field("edge_width", view.edge_width, between(0.25, 10),
                "Width of element edges, in pixels of a picture 720 pixels high");
  archive.field("splinters", view.splinters, Flag{},
                "Whether splinters and surfaces are drawn in place of the tetrahedra");
  archive.field("dust", view.dust, Flag{},
                "Whether cracks throw out dust and crumbs in natural colours: an effect, not in draft quality");
  archive.field("elements", view.elements, OneOf{{styles.begin(), styles.end()}},
                "How tetrahedra are drawn: the surface, all edges, or each one by itself and smaller");
  archive.field("deformation_scale", view.deformation_scale, between(0, 1e6, "-"),
                "How many times as much as they are pieces are drawn deformed");
  archive.field("explode", view.explode, between(0, 20, "-"),
                "How much farther from the middle pieces are drawn than they are");
  archive.field("opacity", view.opacity, between(0.05, 1, "-"), "How opaque bodies are drawn");
  archive.field("slice", view.slice, Parts{}, "A plane that bodies are drawn cut by; null: none");
  archive.field("layers", view.layers, layers, "What is drawn besides the bodies");
  archive.field("fracture_planes", view.fracture_planes, between(1, 1000000),
                "Of how many cracks the layer `fracture_planes` shows the plane, newest first");
  archive.field("glyph_scale", view.glyph_scale, between(0.01, 100, "-"), "Size of arrows and other signs");
}

template <class Archive>
void describe(Archive& archive, Scene& scene) {
  archive.field("name", scene.name, Text{}, "Name of the scene");
  archive.field("description", scene.description, Text{}, "What the scene shows");
  archive.field("gravity", scene.gravity, between(-1e4, 1e4, "m/s²"), "Gravity; y is up");
  archive.field("ground", scene.ground, Parts{}, "A horizontal plane; null: none");
  archive.field("bodies", scene.bodies, Parts{}, "What can break");
  archive.field("projectiles", scene.projectiles, Parts{}, "Bursts of rigid spheres");
  archive.field("analysis", scene.analysis, OneOf{{"dynamic", "static"}},
                "Whether bodies move through time or are in equilibrium with what acts at the time");
  archive.field("simulation", scene.simulation, Parts{}, "How a step is carried out");
  archive.field("probes", scene.probes, Parts{}, "What is written down in every frame");
  archive.field("cameras", scene.cameras, Parts{}, "Views; the first is used unless another is named");
  archive.field("view", scene.view, Parts{}, "What is shown at first; nothing here influences the simulation");
  double tets = 0;
  for (const BodyDescription& body : scene.bodies) tets += tet_count(body.shape);
  archive.require(tets <= static_cast<double>(kMaxTets), "bodies", "make more than 4 million tetrahedra in all",
                  "take larger element sizes or fewer bodies");
  std::int64_t projectiles = 0;
  for (const ProjectileBurst& burst : scene.projectiles) projectiles += burst.count;
  archive.require(projectiles <= kMaxProjectiles, "projectiles", "are more than 10,000 in all", "take smaller counts");
}

}  // namespace griffith
