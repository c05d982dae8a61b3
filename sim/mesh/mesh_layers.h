#pragma once

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Number of tets across a mesh where it is thinnest, >= 1; 0 for no tets. It counts layers of nodes, whatever their
/// distances: the depth of a node is the least number of edges to the surface, and a body of n layers has nodes down to
/// depth n/2, or tets with all corners at depth (n − 1)/2. A tet belongs to as many layers as the deepest place that
/// paths inward from it or its neighbors lead to. Where it is thinnest: a tenth of the volume has no more.
int layers_across(const TetMesh& mesh);

}  // namespace griffith
