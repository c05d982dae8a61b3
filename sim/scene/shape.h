#pragma once

#include <filesystem>
#include <variant>

#include "sim/core/linear_algebra.h"
#include "sim/mesh/box_pattern.h"
#include "sim/meshing/meshing_options.h"

namespace griffith {

// Shapes of bodies, centered on the body's origin, except files, which have their own. Lengths are in meters and > 0.
// Element sizes are targets, rounded so that the cells fill the shape.

/// Box of equal cells.
struct BoxShape {
  Vec3 size = Vec3::Ones();                 ///< edge lengths
  Vec3 element_size = Vec3::Constant(0.5);  ///< cell edge along x, y, z
  BoxPattern pattern = BoxPattern::five_tet;
  bool operator==(const BoxShape&) const = default;
};

/// Cylinder about the z axis.
struct CylinderShape {
  double radius = 0.5, length = 2;
  Vec2 element_size = Vec2::Constant(0.25);  ///< across, along the axis
  BoxPattern pattern = BoxPattern::five_tet;
  bool operator==(const CylinderShape&) const = default;
};

/// Disc normal to the z axis, as in a Brazilian test.
struct DiscShape {
  double radius = 0.5, thickness = 0.2;
  Vec2 element_size = Vec2::Constant(0.1);  ///< across, through the thickness
  BoxPattern pattern = BoxPattern::five_tet;
  bool operator==(const DiscShape&) const = default;
};

struct SphereShape {
  double radius = 0.5;
  double element_size = 0.2;
  BoxPattern pattern = BoxPattern::five_tet;
  bool operator==(const SphereShape&) const = default;
};

/// Plate with a round hole through its center along z. Cells shrink toward the hole.
struct PlateWithHoleShape {
  Vec3 size = Vec3(2, 2, 0.1);
  double hole_radius = 0.2;                 ///< less than half the smaller of size.x and size.y
  Vec2 element_size = Vec2::Constant(0.1);  ///< at the plate's edge, through its thickness
  BoxPattern pattern = BoxPattern::five_tet;
  bool operator==(const PlateWithHoleShape&) const = default;
};

/// Box with a slit of zero width in the plane x = 0, from the side y = −size.y/2 upward, as in a three-point bending
/// test.
struct NotchedBeamShape {
  Vec3 size = Vec3(4, 1, 0.5);
  double notch_depth = 0.3;                  ///< less than size.y
  Vec3 element_size = Vec3::Constant(0.25);  ///< cell edge along x, y, z
  BoxPattern pattern = BoxPattern::five_tet;
  bool operator==(const NotchedBeamShape&) const = default;
};

/// Tetrahedral mesh from a file; for the CSV pair the folder that holds verts.csv and tets.csv.
struct MeshFileShape {
  std::filesystem::path path;  ///< as written in the scene; relative to the scene file's folder
  double scale = 1;            ///< meters per unit of the file, > 0
  bool operator==(const MeshFileShape&) const = default;
};

/// Closed surface from a file, to be filled with tets.
struct SurfaceShape {
  std::filesystem::path path;  ///< as written in the scene; relative to the scene file's folder
  double scale = 1;            ///< meters per unit of the file, > 0
  MeshingOptions meshing;
  bool operator==(const SurfaceShape&) const = default;
};

using Shape = std::variant<BoxShape, CylinderShape, DiscShape, SphereShape, PlateWithHoleShape, NotchedBeamShape,
                           MeshFileShape, SurfaceShape>;

}  // namespace griffith
