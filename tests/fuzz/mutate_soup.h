#pragma once

#include "sim/mesh/tet_mesh.h"
#include "tests/fuzz/choice.h"

namespace griffith::fuzz {

/// Small meshes as they should be: one tet, boxes of each pattern.
std::vector<TetSoup> small_soups();

/// Makes a mesh odd: points joined, moved or put far away, tets removed, repeated, turned or with a corner that is not
/// there. What comes of it may hold together by an edge or a node alone.
TetSoup mutate_soup(TetSoup soup, RandomValues& random);

}  // namespace griffith::fuzz
