#pragma once

#include <functional>

#include "sim/fracture/separation_tensor.h"
#include "sim/meshing/monitor.h"
#include "sim/world/given_meshes.h"
#include "sim/world/world_state.h"

/// The phases of a step, in the order in which advance() calls them.
namespace griffith {

/// A whole step.
void advance(WorldState& world);

/// Builds meshes, bodies and the contact world. Throws InputError for meshes that cannot be simulated.
WorldState build_world(const Scene& scene, const Monitor& monitor = {}, const GivenMeshes& given = {});

/// Makes a body's splinters, if it has a pattern for them. Throws InputError for one that cannot be made.
void place_splinters(Model& model, int scene_body, const RestBody& body, const Monitor& monitor);
/// After the splinters of all bodies were made: what is known of them together.
void close_splinters(Model& model);

/// Queues the shots of a burst, its start counted from now. Throws InputError, about the field `where` of the scene,
/// for a surface file that cannot be read or has no volume.
void queue_burst(WorldState& world, const ProjectileBurst& burst, const std::string& where);
/// All bursts of the scene. Throws InputError where they make a crowd in one place.
void queue_bursts(WorldState& world);
/// A burst while the scene runs. Throws InputError, with nothing queued, as queue_burst() does, for a crowd, and where
/// there would be more projectiles than a scene may have.
void fire_burst(WorldState& world, const ProjectileBurst& burst);
/// Puts the shots whose time has come into the contact world.
void launch_projectiles(WorldState& world);

/// Brings the elastic bodies for which `concerns` holds to rest where what acts on them at `time` [s] is in balance.
/// Prescribed supports go on for `displacement_time` [s]. Free bodies get inertia relief (solve_static()). Throws
/// Cancelled when the monitor says so.
void find_equilibrium(WorldState& world, double time, double displacement_time,
                      const std::function<bool(const Body&)>& concerns, const Monitor& monitor = {});
/// Starts supported bodies in equilibrium, if the scene asks for that: the pieces of `scene_body`, or all (−1). Throws
/// as find_equilibrium() does.
void find_static_start(WorldState& world, int scene_body = -1, const Monitor& monitor = {});

/// The longest time in which nothing strikes hard enough to hurt, up to `most` and within `tolerance` [s].
double time_before_impact(const WorldState& world, double most, double tolerance);

/// No slower approach is an impact [m/s].
double least_impact_speed(const WorldState& world);

/// Elastic state of a body's tets, or of all of bodies that are not rigid.
void update_elements(WorldState& world, const Body& body);
void update_elements(WorldState& world);
/// Makes a rigid body elastic again.
void wake(WorldState& world, Body& body);
/// Assembles the systems of elastic bodies for a substep of `dt` [s].
void assemble_systems(WorldState& world, double dt);
/// The same for one body, which was rigid until now.
void assemble_system(WorldState& world, Body& body, double dt);
/// Puts the proxies where their bodies are: after bodies move, so that impacts are foreseen from where they are now.
void place_proxies(WorldState& world);
/// External force on each node [N]: gravity and loads.
std::vector<Vec3> external_forces(const WorldState& world);
/// The velocities after a substep of `dt` under `external` and elastic forces [N] as if nothing touched; the nodes of
/// rigid bodies keep theirs until they move.
void predict_velocities(WorldState& world, std::vector<Vec3> external, double dt);
void predict_rigid(const WorldState& world, Body& body, const std::vector<Vec3>& forces, double dt);
/// Finds all contacts and changes the velocities so that nothing penetrates; moves the projectiles.
void resolve_contacts(WorldState& world, double dt);
/// Moves every body by its velocities and takes the elastic state after; `external` as in predict_velocities().
void move_bodies(WorldState& world, const std::vector<Vec3>& external, double dt);
/// Puts the nodes of a rigid body where its motion and orientation say.
void place_rigid_nodes(WorldState& world, const Body& body);
/// Takes the stress out of a body that is rigid from now on.
void clear_stress(WorldState& world, const Body& body);
/// A body whose numbers broke down goes on as a rigid one, at rest where it was: one lost body, not a lost scene. Where
/// its positions are lost too, it has the shape again that it had when it was made or last turned rigid, in the place
/// of its proxy. A supported one stays there for good.
void freeze_if_broken_down(WorldState& world, Body& body);
/// Takes the shape as it is now for that of a rigid body.
void make_rigid(WorldState& world, Body& body);
/// Makes a body rigid from now on, its stress gone. A free one keeps its momentum, a supported one stands still.
void freeze(WorldState& world, Body& body);
/// The sum of nodal forces on a body [N], and their torque about its centre of mass [N·m].
struct Wrench {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
};
Wrench wrench_of(const WorldState& world, const Body& body, const std::vector<Vec3>& forces);
/// Kinetic and elastic energy of a body [J].
double mechanical_energy(const WorldState& world, const Body& body);
/// The implicit step of a body.
ImplicitStep implicit_step(const WorldState& world, const Body& body, double dt);
/// Takes what the supports of a body did from its system, after a solve.
void take_reactions(WorldState& world, const Body& body);
/// Counts what a linear solve for a body needed.
void count_solve(WorldState& world, const SolveReport& solve);
/// The longest substep in which explicit integration of all elastic bodies, as they are now, is stable [s]. Freezes
/// bodies that would take more substeps a step than it makes, as those may that have slivers.
double stable_substep(WorldState& world);
/// Throws InputError where the pieces of a scene body, of this material, would take more substeps a step than explicit
/// integration makes.
void check_substep_count(const WorldState& world, int scene_body, const Material& material);
/// Velocities of a body by explicit integration; `forces` hold the elastic and external ones.
void predict_explicitly(WorldState& world, Body& body, std::vector<Vec3>& forces, double dt);
/// Separation tensors, and the margin of every node against the material's resistance. `averaged`: the stress is the
/// mean of this evaluation and the last, so that the noise of a stiff body in motion does not crack it.
void evaluate_separation(WorldState& world, bool averaged);
/// The same for one body, of its stress as it is now.
void evaluate_separation(WorldState& world, const Body& body);
/// Edge length of the cells round a node: that of a cube of six of its tets [m].
double element_size_at(const WorldState& world, NodeId node);
/// The separation of one node of a body under the states of its elements now.
NodeSeparation evaluate_node(const WorldState& world, const SeparationInput& input, const Body& body, NodeId node,
                             bool averaged);
/// What the separation tensors are made of.
SeparationInput separation_input(const WorldState& world);
/// Opens the mesh where the margin is passed, worst first; parted pieces become bodies. What exceeds the budget of
/// cracks opens in the next step. New cracks start no nearer to each other than a wave gets in the `substep` [s].
void open_cracks(WorldState& world, double substep);
/// Bodies whose stress has died, and single tets, which cannot break, turn rigid.
void rigidify_quiet_bodies(WorldState& world);
/// Rigid bodies that lie still fall asleep; after a step of this length [s].
void update_sleep(WorldState& world, double time_step);

/// Gives the tets of bodies that may have come apart to one body for each connected piece.
void split_bodies(WorldState& world, std::span<const BodyId> opened);
/// The same for pieces that are known: one goes on as the body itself, each other becomes a new body, of which nothing
/// but the tets is known yet.
void assign_pieces(WorldState& world, BodyId id, std::vector<std::vector<TetId>> pieces);
/// Rebuilds what follows from the tets of a body with a proxy: all that rebuild_shape() does, collision parts and
/// proxy.
void rebuild_body(WorldState& world, Body& body);
/// Nodes, surface, system and motion of a body. Writes to what is the body's own alone. Returns the energy that it lost
/// where it is rigid from now on [J].
double rebuild_shape(WorldState& world, Body& body);
/// Makes the proxies of bodies that have none yet out of their collision parts, in the contact world.
void add_proxies(WorldState& world, std::span<Body> bodies);
/// Convex parts of the body's present shape, relative to its centre of mass: of the splinters that it owns where the
/// scene asks for that and they are not too many to be told from a whole, else of its tets.
std::vector<ConvexPart> collision_parts(const WorldState& world, const Body& body);
/// The rigid motion that carries the momentum of a body's nodes.
RigidMotion motion_of(const WorldState& world, const Body& body);
/// Takes mass, momentum and orientation of a body from its nodes.
void update_motion(WorldState& world, Body& body);
/// A tet's values out of values per node of the mesh.
inline Corners corners_of(const TetMesh& mesh, TetId tet, std::span<const Vec3> values) {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = values[mesh.tets[tet][i]];
  return corners;
}
/// Edge length of the cubes that six of these tets would fill [m].
double mean_element_size(const WorldState& world, std::span<const TetId> tets);
/// The least stress, spread over the face of an element, that could open a crack somewhere in the body, or could let
/// one run on that is there already [Pa].
double least_breaking_stress(const WorldState& world, const Body& body, bool at_crack_front);
/// The speed of an impact from which a body could be hurt [m/s]; infinite for a single tet, which cannot break.
double damage_speed(const WorldState& world, const Body& body);
/// Lumped mass of a node from its star [kg].
double node_mass(const WorldState& world, NodeId node);

/// Adds the contacts of a substep that carry an impulse to those of the step, for the frame.
void note_contacts(WorldState& world);
/// Views and totals, for the frame.
void publish(WorldState& world);

}  // namespace griffith
