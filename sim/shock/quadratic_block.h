#pragma once

#include "sim/shock/element_block.h"

namespace griffith::shock {

/// What eight quadratic tetrahedra have beside an ElementBlock, none of which is relieved: displacements of edges, as
/// quadratic_element.h has them, and strains at each corner. Edges are as kTetEdges.
struct QuadraticBlock {
  int edges[6][kLanes];  ///< indices into the arrays of edges
  Lanes strain[4][6];    ///< elastic, as force_quadratic_elements() saw it last, for its rate [-]
  Lanes rate[4][6];      ///< change of strain in the last call [-]
};

/// Displacements of all nodes from their reference places, and offsets of all edges [m].
struct QuadraticDisplacements {
  const WideQuad* nodes;
  const WideQuad* edges;
};

/// As force_elements(): forces on corners, each with the largest principal stress there, and on edges,
/// edge_forces[6·lane + edge].
void force_quadratic_elements(const BlockLaw& law, ElementBlock& block, QuadraticBlock& quadratic,
                              const QuadraticDisplacements& displacements, Quad* forces, Quad* edge_forces,
                              ViscousWork& work, float viscosity);

/// As work_of_last() and settle_elements().
Lanes work_of_last(const BlockLaw& law, const ElementBlock& block, const QuadraticBlock& quadratic);
void settle_quadratic_elements(const BlockLaw& law, ElementBlock& block, QuadraticBlock& quadratic,
                               const QuadraticDisplacements& displacements);

}  // namespace griffith::shock
