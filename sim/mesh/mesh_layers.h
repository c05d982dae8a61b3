#pragma once

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Number of tets across a mesh where it is thinnest, >= 1; 0 for no tets. It counts layers of nodes, whatever their
/// distances: the depth of a node is the least number of edges to the surface, and a body of n layers has nodes down to
/// depth n/2, or tets with all corners at depth (n − 1)/2. A tet belongs to as many layers as the deepest place that
/// paths inward from it or its neighbors lead to. Where it is thinnest: a tenth of the volume has no more.
int layers_across(const TetMesh& mesh);

/// Length of a mesh over its mean thickness at rest: the longest edge of its bounding box over 2 V/A, with its volume V
/// and surface A. A cube has 3, a brick 6 to 7, a plate of 1 m and 10 mm 102; 0 for no tets.
double slenderness(const TetMesh& mesh);

}  // namespace griffith
