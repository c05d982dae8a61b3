#include "sim/solver/assembly_inputs.h"

#include <algorithm>
#include <cstring>

#include "sim/core/lanes.h"
#include "sim/core/parallel.h"

namespace griffith {

AssemblyInputs::AssemblyInputs(const ElementRows& rows, const ElementRows& supports) : nodes_(rows.nodes) {
  nodes_.insert(nodes_.end(), supports.nodes.begin(), supports.nodes.end());
  for (const ElementRows::TetAtNode& entry : rows.tets) {
    if (entry.corner >= 4) break;  // rows of edges, whose tets have nodes with rows
    const auto corner = entry.slots.begin() + entry.corner;
    const bool is_first = std::all_of(entry.slots.begin(), corner, [](int slot) { return slot < 0; });
    if (is_first) tets_.push_back(entry.tet);  // once, though each of its corners has a row
  }
  for (const ElementRows::TetAtNode& entry : supports.tets) tets_.push_back(entry.tet);
}

void AssemblyInputs::record(const MatrixFactors& factors, const ElasticLaw& law, std::span<const ElementState> states,
                            std::span<const double> masses) {
  is_recorded_ = true;
  factors_ = factors;
  law_ = law;
  is_compacted_ = any_compacted(states);
  frames_.resize(tets_.size());
  for (std::size_t i = 0; i < tets_.size(); ++i) frames_[i] = states[tets_[i]].frame.cast<float>();
  masses_.resize(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) masses_[i] = masses[nodes_[i]];
}

bool AssemblyInputs::still_hold(const MatrixFactors& factors, const ElasticLaw& law,
                                std::span<const ElementState> states, std::span<const double> masses) const {
  constexpr double kSameFrame = 1e-4;
  if (!(is_recorded_ && factors == factors_ && law == law_) || is_compacted_ || any_compacted(states)) return false;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (masses[nodes_[i]] != masses_[i]) return false;
  const auto has_turned = [](const Mat3& frame, const Frame& then) {
    const auto change_from = [&](int first) {
      simd::Quad four;
      std::memcpy(&four, then.data() + first, sizeof four);
      return simd::load(frame.data() + first) - __builtin_convertvector(four, simd::WideQuad);
    };
    const simd::WideQuad low = change_from(0), high = change_from(4), squares = low * low + high * high;
    const double last = frame.data()[8] - static_cast<double>(then.data()[8]);
    const double square = (squares[0] + squares[1]) + (squares[2] + squares[3]) + last * last;
    return !(square <= kSameFrame * kSameFrame);
  };
  const double turned = parallel_sum(static_cast<int>(tets_.size()), [&](int begin, int end) {
    double count = 0;
    for (int i = begin; i < end; ++i) count += has_turned(states[tets_[i]].frame, frames_[i]);
    return count;
  });
  return turned == 0;
}

bool AssemblyInputs::any_compacted(std::span<const ElementState> states) const {
  return std::ranges::any_of(tets_, [&](TetId tet) { return states[tet].is_compacted(); });
}

std::size_t AssemblyInputs::memory() const {
  return tets_.size() * (sizeof(TetId) + sizeof(Frame)) + nodes_.size() * (sizeof(NodeId) + sizeof(double));
}

}  // namespace griffith
