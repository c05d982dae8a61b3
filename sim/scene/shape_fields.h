#pragma once

#include <algorithm>

#include "sim/scene/field.h"
#include "sim/scene/shape.h"

// Fields of shapes, a part of the table in scene_fields.h.

namespace griffith {

/// Largest number of cells in the box around a shape. More are taken for a mistake in the element size.
inline constexpr double kMaxShapeCells = 2e6;

inline constexpr Numbers kLength = between(1e-4, 1e5, "m");
inline constexpr Numbers kElementSize = {.minimum = 1e-5, .maximum = 1e5, .unit = "m", .uniform = true};

template <class Archive>
void describe_pattern(Archive& archive, BoxPattern& pattern) {
  archive.field("pattern", pattern, OneOf{{"kuhn", "five_tet", "bcc"}}, "Division of a cell into tetrahedra");
}

/// Returns cell edges along x, y, z of a shape that is swept along z.
inline Vec3 swept(const Vec2& element_size) { return {element_size.x(), element_size.x(), element_size.y()}; }

/// Returns the number of cells in the box around a shape, whose edges are `extent` [m].
inline double cells_in(const Vec3& extent, const Vec3& element_size) {
  return (extent.array() / element_size.array()).round().max(1).prod();
}
inline double cell_count(const BoxShape& box) { return cells_in(box.size, box.element_size); }
inline double cell_count(const CylinderShape& cylinder) {
  return cells_in({2 * cylinder.radius, 2 * cylinder.radius, cylinder.length}, swept(cylinder.element_size));
}
inline double cell_count(const DiscShape& disc) {
  return cells_in({2 * disc.radius, 2 * disc.radius, disc.thickness}, swept(disc.element_size));
}
inline double cell_count(const SphereShape& sphere) {
  return cells_in(Vec3::Constant(2 * sphere.radius), Vec3::Constant(sphere.element_size));
}
inline double cell_count(const PlateWithHoleShape& plate) { return cells_in(plate.size, swept(plate.element_size)); }
inline double cell_count(const NotchedBeamShape& beam) { return cells_in(beam.size, beam.element_size); }

inline double tets_per_cell(BoxPattern pattern) {
  switch (pattern) {
    case BoxPattern::kuhn:
      return 6;
    case BoxPattern::five_tet:
      return 5;
    case BoxPattern::bcc:
      return 12;
  }
  return 0;
}

/// Returns about the number of tets of a shape, at most that of the box around it; 0 if it depends on a file.
inline double tet_count(const Shape& shape) {
  const auto count = [](const auto& known) -> double {
    if constexpr (requires { cell_count(known); }) {
      return cell_count(known) * tets_per_cell(known.pattern);
    } else {
      return 0;
    }
  };
  return std::visit(count, shape);
}

template <class Archive, class AnyShape>
void require_few_cells(Archive& archive, const AnyShape& shape) {
  archive.require(cell_count(shape) <= kMaxShapeCells, "element_size", "cuts the shape into more than 2 million cells",
                  "use a larger element_size or a smaller shape");
}

template <class Archive>
void describe(Archive& archive, BoxShape& box) {
  archive.field("size", box.size, kLength, "Edge lengths along x, y, z");
  archive.field("element_size", box.element_size, kElementSize,
                "Target cell edge, one number or one each for x, y, z; rounded to fit the box");
  describe_pattern(archive, box.pattern);
  require_few_cells(archive, box);
}

template <class Archive>
void describe(Archive& archive, CylinderShape& cylinder) {
  archive.field("radius", cylinder.radius, kLength, "Radius");
  archive.field("length", cylinder.length, kLength, "Length along z");
  archive.field("element_size", cylinder.element_size, kElementSize,
                "Target cell edge, one number or one each for across and along the axis");
  describe_pattern(archive, cylinder.pattern);
  require_few_cells(archive, cylinder);
}

template <class Archive>
void describe(Archive& archive, DiscShape& disc) {
  archive.field("radius", disc.radius, kLength, "Radius");
  archive.field("thickness", disc.thickness, kLength, "Thickness along z");
  archive.field("element_size", disc.element_size, kElementSize,
                "Target cell edge, one number or one each for across and through the thickness");
  describe_pattern(archive, disc.pattern);
  require_few_cells(archive, disc);
}

template <class Archive>
void describe(Archive& archive, SphereShape& sphere) {
  archive.field("radius", sphere.radius, kLength, "Radius");
  archive.field("element_size", sphere.element_size, between(kElementSize.minimum, kElementSize.maximum, "m"),
                "Target cell edge");
  describe_pattern(archive, sphere.pattern);
  require_few_cells(archive, sphere);
}

template <class Archive>
void describe(Archive& archive, PlateWithHoleShape& plate) {
  archive.field("size", plate.size, kLength, "Edge lengths along x, y, z");
  archive.field("hole_radius", plate.hole_radius, kLength, "Radius of the hole along z");
  archive.field("element_size", plate.element_size, kElementSize,
                "Target cell edge, one number or one each for the plate's edge and its thickness");
  describe_pattern(archive, plate.pattern);
  archive.require(plate.hole_radius < std::min(plate.size.x(), plate.size.y()) / 2, "hole_radius",
                  "reaches the plate's edge", "use less than half the plate's smaller side");
  require_few_cells(archive, plate);
}

template <class Archive>
void describe(Archive& archive, NotchedBeamShape& beam) {
  archive.field("size", beam.size, kLength, "Edge lengths along x, y, z");
  archive.field("notch_depth", beam.notch_depth, kLength, "Depth of the slit in the plane x = 0, from below");
  archive.field("element_size", beam.element_size, kElementSize,
                "Target cell edge, one number or one each for x, y, z; rounded to fit the beam");
  describe_pattern(archive, beam.pattern);
  archive.require(beam.notch_depth < beam.size.y(), "notch_depth", "cuts the beam through",
                  "use less than the beam's height, size[1]");
  require_few_cells(archive, beam);
}

template <class Archive>
void describe(Archive& archive, MeshFileShape& mesh) {
  archive.field("path", mesh.path, MeshPath{},
                "Mesh file, or the folder that holds verts.csv and tets.csv; relative to the scene file's folder");
  archive.field("scale", mesh.scale, between(1e-9, 1e6), "Meters per unit of the file");
}

template <class Archive>
void describe(Archive& archive, SurfaceShape& surface) {
  MeshingOptions& meshing = surface.meshing;
  archive.field("path", surface.path, MeshPath{},
                "Surface: .obj, .stl, .ply, .off, .gltf or .glb; relative to the scene file's folder");
  archive.field("scale", surface.scale, between(1e-9, 1e6), "Meters per unit of the file");
  archive.field("element_size", meshing.element_size, between(kElementSize.minimum, kElementSize.maximum, "m"),
                "Target edge of tetrahedra; null: a twentieth of the bounding box's diagonal");
  archive.field(
      "method", meshing.method, OneOf{{"automatic", "tetgen", "volumetric"}},
      "TetGen keeps the surface's triangles and needs a sound surface; volumetric accepts any, with equal elements; "
      "automatic: TetGen if possible");
  archive.field("grading", meshing.grading, between(1, 100),
                "Largest ratio of inner edges to surface edges (volumetric: 2, 4, 8, ...)");
  archive.field("radius_edge_ratio", meshing.radius_edge_ratio, between(1.1, 10),
                "TetGen: largest circumradius over shortest edge");
  archive.field("min_dihedral_angle", meshing.min_dihedral_angle, between(0, 18, "degrees"),
                "TetGen: smallest dihedral angle that it aims at");
}

template <class Archive>
void describe(Archive& archive, Shape& shape) {
  archive.template alternative<BoxShape>("box", shape, Parts{}, "Box centered on the body's origin");
  archive.template alternative<CylinderShape>("cylinder", shape, Parts{}, "Cylinder about the z axis");
  archive.template alternative<DiscShape>("disc", shape, Parts{}, "Disc normal to the z axis, as in a Brazilian test");
  archive.template alternative<SphereShape>("sphere", shape, Parts{}, "Sphere");
  archive.template alternative<PlateWithHoleShape>("plate_with_hole", shape, Parts{},
                                                   "Plate with a round hole through its center along z");
  archive.template alternative<NotchedBeamShape>("notched_beam", shape, Parts{},
                                                 "Box with a slit of zero width from below, across its length");
  archive.template alternative<MeshFileShape>("mesh", shape, Parts{}, "Tetrahedral mesh from a file");
  archive.template alternative<SurfaceShape>("surface", shape, Parts{},
                                             "Surface from a file, to be filled with tetrahedra");
}

}  // namespace griffith
