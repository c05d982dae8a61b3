#pragma once

#include "sim/explicit/element_block.h"

namespace griffith::explicit_dynamics {

/// Additional data of eight quadratic tetrahedra beside an ElementBlock: displacements of edges as in
/// quadratic_element.h, and strains at each corner. None of them is relieved. Edges are ordered as kTetEdges.
struct QuadraticBlock {
  int edges[6][kLanes];  ///< indices into the arrays of edges
  Lanes offset[4][6];    ///< stress-free strain, in place of that of the ElementBlock [-]
  Lanes strain[4][6];    ///< elastic strain in the last force_quadratic_elements(), for its rate [-]
  Lanes rate[4][6];      ///< change of strain in the last call [-]
};

/// Displacements of all nodes from their reference positions, and offsets of all edges [m].
struct QuadraticDisplacements {
  const WideQuad* nodes;
  const WideQuad* edges;
};

/// As force_elements(): computes forces on corners, each with the largest principal stress there, and on edges,
/// edge_forces[6·lane + edge].
void force_quadratic_elements(const BlockLaw& law, ElementBlock& block, QuadraticBlock& quadratic,
                              const QuadraticDisplacements& displacements, Quad* forces, Quad* edge_forces,
                              ViscousWork& work, float viscosity, bool finds_largest);

/// As work_of_last() and settle_elements().
Lanes work_of_last(const BlockLaw& law, const ElementBlock& block, const QuadraticBlock& quadratic);
void settle_quadratic_elements(const BlockLaw& law, ElementBlock& block, QuadraticBlock& quadratic,
                               const QuadraticDisplacements& displacements);

}  // namespace griffith::explicit_dynamics
