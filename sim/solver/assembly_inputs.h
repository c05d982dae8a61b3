#pragma once

#include <span>
#include <vector>

#include "sim/solver/element_rows.h"

namespace griffith {

/// What a system's matrix was assembled from, to tell whether it would come out the same: while a body only sways, its
/// elements hardly turn, and all that could change the matrix is their turning.
class AssemblyInputs {
 public:
  /// Nothing yet. `rows`: all that are assembled; those of `supports` have columns for all nodes.
  AssemblyInputs(const ElementRows& rows, const ElementRows& supports);

  /// Spans are per node or tet of the mesh.
  void record(const MatrixFactors& factors, const ElasticLaw& law, std::span<const ElementState> states,
              std::span<const double> masses);
  /// Whether the same factors, law and masses, and frames within a ten-thousandth (Frobenius norm) of those then, would
  /// give the same matrix but for as much: far less than the residual that systems are solved to.
  bool still_hold(const MatrixFactors& factors, const ElasticLaw& law, std::span<const ElementState> states,
                  std::span<const double> masses) const;
  /// About [bytes].
  std::size_t memory() const;

 private:
  using Frame = Eigen::Matrix<float, 3, 3, Eigen::DontAlign>;  // single precision suffices to see it turn

  bool is_recorded_ = false;
  MatrixFactors factors_;
  ElasticLaw law_;
  std::vector<TetId> tets_;
  std::vector<Frame> frames_;  // per entry of tets_
  std::vector<NodeId> nodes_;
  std::vector<double> masses_;  // per entry of nodes_
};

}  // namespace griffith
