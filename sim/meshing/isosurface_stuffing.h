#pragma once

#include <functional>
#include <string>

#include "sim/core/linear_algebra.h"
#include "sim/core/monitor.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Solid given by its interior. Called from many threads at once.
struct ImplicitSolid {
  std::function<bool(const Vec3& point)> inside;
  /// returns the place of the border between an inner and an outer point: 0 at the first, 1 at the second
  std::function<double(const Vec3& inner, const Vec3& outer)> crossing;
};

/// Fills a solid with tets by isosurface stuffing on a body-centered cubic lattice (Labelle & Shewchuk 2007). Lattice
/// vertices near the border move onto it, and tets that still cross it are cut. All dihedral angles lie from 10.7° to
/// 164.8° (their table 1) for any solid. Parts thinner than a lattice cube may be lost. `box` contains the solid;
/// `cube_edge` is the lattice's longer edge [m] at the border; deep inside, edges may be longer by 2^`levels`. Throws
/// InputError, about `name`, if the lattice is too fine, and Cancelled.
TetSoup stuff_isosurface(const ImplicitSolid& solid, const Eigen::AlignedBox3d& box, double cube_edge,
                         const std::string& name, const Monitor& monitor = {}, int levels = 0);

}  // namespace griffith
