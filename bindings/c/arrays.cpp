#include <algorithm>
#include <array>
#include <span>
#include <type_traits>

#include "bindings/c/guarded.h"
#include "bindings/c/handles.h"

using namespace griffith;
using namespace griffith::c;

namespace {

/// Memory layout of an entry of an array.
template <class T>
struct Layout;

template <griffith_type type_value, int... lengths>
struct LayoutOf {
  static constexpr griffith_type type = type_value;
  static constexpr std::array<std::int32_t, sizeof...(lengths)> shape = {lengths...};
};

template <>
struct Layout<double> : LayoutOf<GRIFFITH_FLOAT64> {};
template <>
struct Layout<float> : LayoutOf<GRIFFITH_FLOAT32> {};
template <>
struct Layout<std::int64_t> : LayoutOf<GRIFFITH_INT64> {};
template <>
struct Layout<std::int32_t> : LayoutOf<GRIFFITH_INT32> {};
template <>
struct Layout<std::uint8_t> : LayoutOf<GRIFFITH_UINT8> {};
template <>
struct Layout<bool> : LayoutOf<GRIFFITH_UINT8> {};
template <class Tag>
struct Layout<Id<Tag>> : LayoutOf<GRIFFITH_INT32> {};
template <class Tag>
struct Layout<std::array<Id<Tag>, 4>> : LayoutOf<GRIFFITH_INT32, 4> {};
template <>
struct Layout<Vec3> : LayoutOf<GRIFFITH_FLOAT64, 3> {};
template <>
struct Layout<Quat> : LayoutOf<GRIFFITH_FLOAT64, 4> {};
template <>
struct Layout<Mat3> : LayoutOf<GRIFFITH_FLOAT64, 3, 3> {};
static_assert(sizeof(bool) == 1 && sizeof(NodeId) == 4 && sizeof(Vec3) == 24 && sizeof(Mat3) == 72 &&
              sizeof(Quat) == 32);

template <class T>
griffith_array view_of(const T* data, std::size_t count, std::size_t stride) {
  griffith_array view = {data,
                         static_cast<std::int64_t>(count),
                         static_cast<std::int64_t>(stride),
                         Layout<T>::type,
                         static_cast<std::int32_t>(Layout<T>::shape.size()),
                         {1, 1}};
  for (std::size_t i = 0; i < Layout<T>::shape.size(); ++i) view.shape[i] = Layout<T>::shape[i];
  return view;
}

template <class T>
griffith_array view_of(std::span<const T> values) {
  return view_of(values.data(), values.size(), sizeof(T));
}

/// Returns a view of one member of each struct of an array.
template <class Struct, class T>
griffith_array member_of(std::span<const Struct> values, T Struct::*member) {
  return view_of<T>(values.empty() ? nullptr : &(values.front().*member), values.size(), sizeof(Struct));
}

/// Returns a view of rows of `width` by `width` numbers.
template <class T>
griffith_array rows_of(const std::vector<T>& values, int width) {
  griffith_array view = view_of(values.data(), values.size() / width, width * sizeof(T));
  view.dimensions = 1;
  view.shape[0] = width;
  return view;
}

template <class T>
griffith_array numbers_of(const std::vector<T>& values) {
  return view_of(std::span<const T>(values));
}

/// Objects behind the arrays.
struct Source {
  Frame frame;
  const Surfaces& surfaces;
};

struct ArrayEntry {
  griffith_array_id id;
  griffith_array_info info;
  griffith_array (*view)(const Source& source);
};

using View = const Source&;

constexpr ArrayEntry kArrays[] = {
    {GRIFFITH_NODE_POSITIONS,
     {"node_positions", "m", "Positions of nodes."},
     [](View s) { return view_of(s.frame.nodes.positions); }},
    {GRIFFITH_NODE_REST_POSITIONS,
     {"node_rest_positions", "m", "Positions of nodes in the rest space of their body."},
     [](View s) { return view_of(s.frame.nodes.rest_positions); }},
    {GRIFFITH_NODE_VELOCITIES,
     {"node_velocities", "m/s", "Velocities of nodes."},
     [](View s) { return view_of(s.frame.nodes.velocities); }},
    {GRIFFITH_NODE_MASSES,
     {"node_masses", "kg", "Masses of nodes: a quarter of each tetrahedron's."},
     [](View s) { return view_of(s.frame.nodes.masses); }},
    {GRIFFITH_NODE_UTILIZATION,
     {"node_utilization", "", "Load over resistance; a node separates above 1."},
     [](View s) { return member_of(s.frame.nodes.separations, &NodeSeparation::utilization); }},
    {GRIFFITH_NODE_SEPARATION_TENSORS,
     {"node_separation_tensors", "N", "Separation tensors of nodes (O'Brien & Hodgins 1999)."},
     [](View s) { return member_of(s.frame.nodes.separations, &NodeSeparation::tensor); }},
    {GRIFFITH_NODE_SEPARATION_NORMALS,
     {"node_separation_normals", "", "Unit normals of the planes across which nodes would separate."},
     [](View s) { return member_of(s.frame.nodes.separations, &NodeSeparation::direction); }},
    {GRIFFITH_NODE_SEPARATION_STRESS,
     {"node_separation_stress", "Pa", "Stress across that plane, averaged over the last substeps."},
     [](View s) { return member_of(s.frame.nodes.separations, &NodeSeparation::stress); }},
    {GRIFFITH_NODE_RESISTANCE,
     {"node_resistance", "Pa", "Resistance of that plane; in newtons with the force criterion."},
     [](View s) { return member_of(s.frame.nodes.separations, &NodeSeparation::resistance); }},
    {GRIFFITH_NODE_REACTIONS,
     {"node_reactions", "N", "Forces of supports on nodes in the last step."},
     [](View s) { return view_of(s.frame.nodes.reactions); }},
    {GRIFFITH_NODE_HAS_SUPPORT,
     {"node_has_support", "", "1 if a support acts on the node."},
     [](View s) { return view_of(s.frame.nodes.has_support); }},
    {GRIFFITH_NODE_AT_CRACK_FRONT,
     {"node_at_crack_front", "", "1 if crack faces end at the node."},
     [](View s) { return view_of(s.frame.nodes.at_crack_front); }},
    {GRIFFITH_TET_NODES,
     {"tet_nodes", "", "Nodes of tetrahedra, positively oriented at rest."},
     [](View s) { return view_of(s.frame.elements.tets); }},
    {GRIFFITH_TET_NEIGHBORS,
     {"tet_neighbors", "", "Tetrahedra behind the face opposite each node; -1 on the surface."},
     [](View s) { return view_of(s.frame.elements.neighbors); }},
    {GRIFFITH_TET_BODIES,
     {"tet_bodies", "", "Bodies of tetrahedra."},
     [](View s) { return view_of(s.frame.elements.bodies); }},
    {GRIFFITH_TET_STRESS,
     {"tet_stress", "Pa", "Cauchy stress in the world's axes."},
     [](View s) { return view_of(s.frame.elements.stresses); }},
    {GRIFFITH_BODY_POSITIONS,
     {"body_positions", "m", "Centers of mass."},
     [](View s) { return member_of(s.frame.bodies, &BodyView::center_of_mass); }},
    {GRIFFITH_BODY_ORIENTATIONS,
     {"body_orientations", "", "Unit quaternions x, y, z, w from the shape that the body began with."},
     [](View s) { return member_of(s.frame.bodies, &BodyView::orientation); }},
    {GRIFFITH_BODY_VELOCITIES,
     {"body_velocities", "m/s", "Velocities of centers of mass."},
     [](View s) { return member_of(s.frame.bodies, &BodyView::velocity); }},
    {GRIFFITH_BODY_ANGULAR_VELOCITIES,
     {"body_angular_velocities", "rad/s", "Angular velocities."},
     [](View s) { return member_of(s.frame.bodies, &BodyView::angular_velocity); }},
    {GRIFFITH_BODY_MASSES,
     {"body_masses", "kg", "Masses of bodies."},
     [](View s) { return member_of(s.frame.bodies, &BodyView::mass); }},
    {GRIFFITH_BODY_PARENTS,
     {"body_parents", "", "Bodies that pieces broke off; -1 for an original."},
     [](View s) { return member_of(s.frame.bodies, &BodyView::parent); }},
    {GRIFFITH_BODY_SCENE_BODIES,
     {"body_scene_bodies", "", "Indices into the scene's bodies."},
     [](View s) { return member_of(s.frame.bodies, &BodyView::scene_body); }},
    {GRIFFITH_BODY_IS_RIGID,
     {"body_is_rigid", "", "1 if the body moves as a whole."},
     [](View s) { return member_of(s.frame.bodies, &BodyView::rigid); }},
    {GRIFFITH_BODY_IS_ASLEEP,
     {"body_is_asleep", "", "1 if the body is at rest until something disturbs it."},
     [](View s) { return member_of(s.frame.bodies, &BodyView::asleep); }},
    {GRIFFITH_BODY_IS_SUPPORTED,
     {"body_is_supported", "", "1 if supports hold nodes of the body."},
     [](View s) { return member_of(s.frame.bodies, &BodyView::supported); }},
    {GRIFFITH_CRACK_STEPS,
     {"crack_steps", "", "Steps in which nodes separated."},
     [](View s) { return member_of(s.frame.crack_events, &CrackEvent::step); }},
    {GRIFFITH_CRACK_TIMES,
     {"crack_times", "s", "Times at which nodes separated."},
     [](View s) { return member_of(s.frame.crack_events, &CrackEvent::time); }},
    {GRIFFITH_CRACK_NODES,
     {"crack_nodes", "", "Nodes that separated."},
     [](View s) { return member_of(s.frame.crack_events, &CrackEvent::node); }},
    {GRIFFITH_CRACK_BODIES,
     {"crack_bodies", "", "Bodies that cracked."},
     [](View s) { return member_of(s.frame.crack_events, &CrackEvent::body); }},
    {GRIFFITH_CRACK_POSITIONS,
     {"crack_positions", "m", "Positions at which nodes separated."},
     [](View s) { return member_of(s.frame.crack_events, &CrackEvent::position); }},
    {GRIFFITH_CRACK_NORMALS,
     {"crack_normals", "", "Unit normals of the crack planes."},
     [](View s) { return member_of(s.frame.crack_events, &CrackEvent::normal); }},
    {GRIFFITH_CRACK_LOADS,
     {"crack_loads", "Pa", "Load at separation; in newtons with the force criterion."},
     [](View s) { return member_of(s.frame.crack_events, &CrackEvent::load); }},
    {GRIFFITH_CRACK_RESISTANCE,
     {"crack_resistance", "Pa", "Resistance at separation; in newtons with the force criterion."},
     [](View s) { return member_of(s.frame.crack_events, &CrackEvent::resistance); }},
    {GRIFFITH_CONTACT_BODIES_A,
     {"contact_bodies_a", "", "First bodies of contacts; -1 for a projectile or the ground."},
     [](View s) { return member_of(s.frame.contacts, &ContactView::a); }},
    {GRIFFITH_CONTACT_BODIES_B,
     {"contact_bodies_b", "", "Second bodies of contacts; -1 for a projectile or the ground."},
     [](View s) { return member_of(s.frame.contacts, &ContactView::b); }},
    {GRIFFITH_CONTACT_POSITIONS,
     {"contact_positions", "m", "Positions of contacts of the last step."},
     [](View s) { return member_of(s.frame.contacts, &ContactView::position); }},
    {GRIFFITH_CONTACT_NORMALS,
     {"contact_normals", "", "Unit normals of contacts, from the second body to the first."},
     [](View s) { return member_of(s.frame.contacts, &ContactView::normal); }},
    {GRIFFITH_CONTACT_IMPULSES,
     {"contact_impulses", "N s", "Impulses on the first body in the last step."},
     [](View s) { return member_of(s.frame.contacts, &ContactView::impulse); }},
    {GRIFFITH_PROJECTILE_POSITIONS,
     {"projectile_positions", "m", "Centers of projectiles."},
     [](View s) { return member_of(s.frame.projectiles, &ProjectileView::position); }},
    {GRIFFITH_PROJECTILE_VELOCITIES,
     {"projectile_velocities", "m/s", "Velocities of projectiles."},
     [](View s) { return member_of(s.frame.projectiles, &ProjectileView::velocity); }},
    {GRIFFITH_PROJECTILE_ROTATIONS,
     {"projectile_rotations", "", "Unit quaternions x, y, z, w of projectiles."},
     [](View s) { return member_of(s.frame.projectiles, &ProjectileView::rotation); }},
    {GRIFFITH_PROJECTILE_RADII,
     {"projectile_radii", "m", "Radii of spheres, or of the bounding sphere of a projectile."},
     [](View s) { return member_of(s.frame.projectiles, &ProjectileView::radius); }},
    {GRIFFITH_PROJECTILE_MASSES,
     {"projectile_masses", "kg", "Masses of projectiles."},
     [](View s) { return member_of(s.frame.projectiles, &ProjectileView::mass); }},
    {GRIFFITH_SURFACE_POSITIONS,
     {"surface_positions", "m", "Vertices of surfaces in the frame of their body."},
     [](View s) { return rows_of(s.surfaces.positions, 3); }},
    {GRIFFITH_SURFACE_NORMALS,
     {"surface_normals", "", "Unit normals at vertices in the frame of their body."},
     [](View s) { return rows_of(s.surfaces.normals, 3); }},
    {GRIFFITH_SURFACE_TRIANGLES,
     {"surface_triangles", "", "Vertices of triangles, counted from the first of their body."},
     [](View s) { return rows_of(s.surfaces.triangles, 3); }},
    {GRIFFITH_SURFACE_IS_CRACK,
     {"surface_is_crack", "", "1 for triangles of crack faces."},
     [](View s) { return numbers_of(s.surfaces.is_crack); }},
    {GRIFFITH_SURFACE_FIRST_VERTICES,
     {"surface_first_vertices", "", "First vertices of bodies."},
     [](View s) { return numbers_of(s.surfaces.first_vertices); }},
    {GRIFFITH_SURFACE_VERTEX_COUNTS,
     {"surface_vertex_counts", "", "Numbers of vertices of bodies."},
     [](View s) { return numbers_of(s.surfaces.vertex_counts); }},
    {GRIFFITH_SURFACE_FIRST_TRIANGLES,
     {"surface_first_triangles", "", "First triangles of bodies."},
     [](View s) { return numbers_of(s.surfaces.first_triangles); }},
    {GRIFFITH_SURFACE_TRIANGLE_COUNTS,
     {"surface_triangle_counts", "", "Numbers of triangles of bodies."},
     [](View s) { return numbers_of(s.surfaces.triangle_counts); }},
    {GRIFFITH_SURFACE_VERSIONS,
     {"surface_versions", "", "Counts of changes of bodies' vertices."},
     [](View s) { return numbers_of(s.surfaces.versions); }},
};

constexpr bool are_in_order() {
  for (std::size_t i = 0; i < std::size(kArrays); ++i)
    if (kArrays[i].id != static_cast<griffith_array_id>(i)) return false;
  return std::size(kArrays) == GRIFFITH_ARRAY_COUNT;
}
static_assert(are_in_order(), "an array is missing, or not where its id is");

std::vector<griffith_value_info> quantity_infos() {
  std::vector<griffith_value_info> infos;
  for (const Quantity* quantity : file_quantities())  // their texts are literals, which end with 0
    infos.push_back({quantity->key.data(), quantity->unit.data(), quantity->meaning.data()});
  return infos;
}

const std::vector<griffith_value_info>& described_quantities() {
  static const std::vector<griffith_value_info> infos = quantity_infos();
  return infos;
}

const Quantity& quantity_of(const std::string& name) {
  const std::vector<const Quantity*> all = file_quantities();
  const auto found = std::ranges::find(all, name, &Quantity::key);
  require(found != all.end(), "name", "is no quantity", "griffith_quantity_describe() lists them");
  return **found;
}

bool is_array(std::int32_t array) { return array >= 0 && array < GRIFFITH_ARRAY_COUNT; }

}  // namespace

const griffith_array_info* griffith_array_describe(std::int32_t array) {
  return is_array(array) ? &kArrays[array].info : nullptr;
}

griffith_status griffith_world_array(const griffith_world* world, std::int32_t array, griffith_array* view,
                                     griffith_error* error) {
  return guarded(error, [&] {
    const griffith_world& shown = object_of(world, "world");
    griffith_array& result = object_of(view, "view");
    require(is_array(array), "array", "is not an array", "a griffith_array_id");
    result = kArrays[array].view({shown.world.frame(), shown.surfaces});
  });
}

std::int32_t griffith_quantity_count(void) { return static_cast<std::int32_t>(described_quantities().size()); }

const griffith_value_info* griffith_quantity_describe(std::int32_t index) {
  const std::vector<griffith_value_info>& infos = described_quantities();
  return index >= 0 && index < griffith_quantity_count() ? &infos[static_cast<std::size_t>(index)] : nullptr;
}

griffith_status griffith_world_quantity(griffith_world* world, const char* name, griffith_array* view,
                                        griffith_error* error) {
  return guarded(error, [&] {
    griffith_world& shown = object_of(world, "world");
    griffith_array& result = object_of(view, "view");
    const Frame frame = shown.world.frame();
    const Quantity& quantity = quantity_of(text_of(name, "name"));
    shown.quantity = quantity_array(frame, quantity);
    result = std::visit([](const auto& values) { return numbers_of(values); }, shown.quantity);
    if (place_of(quantity) == ValuePlace::node) result.count = static_cast<std::int64_t>(frame.nodes.positions.size());
  });
}
