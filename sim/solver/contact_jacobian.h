#pragma once

#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// The map J from velocities to the relative velocities at contacts, in three rows a contact.
class ContactJacobian {
 public:
  /// Part of a contact's rows: its columns begin at `offset` and are 3 (a node) or 6 (a rigid motion).
  struct Block {
    int offset = 0, width = 3;
    Eigen::Matrix<double, 3, 6> values = Eigen::Matrix<double, 3, 6>::Zero();
  };

  /// Adds to the contact that is being made; parts of the same offset add up.
  void add(int offset, const Eigen::Ref<const Eigen::Matrix3Xd>& values);
  /// Ends the rows of a contact.
  void finish_contact() { starts_.push_back(static_cast<int>(blocks_.size())); }

  int contacts() const { return static_cast<int>(starts_.size()) - 1; }
  const Block* begin(int contact) const { return blocks_.data() + starts_[contact]; }
  const Block* end(int contact) const { return blocks_.data() + starts_[contact + 1]; }

  /// J v, one column a contact.
  Eigen::Matrix3Xd multiply(const Eigen::VectorXd& v) const;
  /// v becomes v + Jᵀ p.
  void add_transposed(const Eigen::Matrix3Xd& p, Eigen::VectorXd& v) const;

 private:
  std::vector<int> starts_ = {0};
  std::vector<Block> blocks_;
};

}  // namespace griffith
