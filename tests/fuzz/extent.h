#pragma once

#include "sim/scene/shape.h"

namespace griffith::fuzz {

/// Edges of the box round a shape; of one from a file, those of the small files that the fuzzer has [m].
Vec3 extent_of(const Shape& shape);

/// About how many cells a shape is cut into.
double cells_of(const Shape& shape);

/// The shortest of its cells' edges that the shape asks for [m].
double finest_edge_of(const Shape& shape);

/// Leaves the shape two cells along each edge; files become small ones.
void coarsen(Shape& shape);

}  // namespace griffith::fuzz
