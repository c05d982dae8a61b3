#pragma once

#include <span>
#include <vector>

#include "sim/solver/element_rows.h"

namespace griffith {

/// Inputs of the last assembly of a system's matrix. They show whether another assembly would give the same matrix: in
/// small motions the elements of a body hardly rotate, and only their rotation changes the matrix.
class AssemblyInputs {
 public:
  /// Nothing yet. `rows`: all that are assembled; those of `supports` have columns for all nodes.
  AssemblyInputs(const ElementRows& rows, const ElementRows& supports);

  /// Spans are per node or tet of the mesh.
  void record(const MatrixFactors& factors, const ElasticLaw& law, std::span<const ElementState> states,
              std::span<const double> masses);
  /// True if the matrix would be the same except for negligible changes: factors, law and masses are equal, and frames
  /// differ by less than 1e-4 (Frobenius norm), far below the residual to which systems are solved; false if a tet is
  /// compacted.
  bool still_hold(const MatrixFactors& factors, const ElasticLaw& law, std::span<const ElementState> states,
                  std::span<const double> masses) const;
  /// Returns its approximate memory [bytes].
  std::size_t memory() const;

 private:
  bool any_compacted(std::span<const ElementState> states) const;

  using Frame = Eigen::Matrix<float, 3, 3, Eigen::DontAlign>;  // single precision suffices to see it turn

  bool is_recorded_ = false, is_compacted_ = false;
  MatrixFactors factors_;
  ElasticLaw law_;
  std::vector<TetId> tets_;
  std::vector<Frame> frames_;  // per entry of tets_
  std::vector<NodeId> nodes_;
  std::vector<double> masses_;  // per entry of nodes_
};

}  // namespace griffith
