#include "sim/solver/contact_jacobian.h"

#include <algorithm>

namespace griffith {

void ContactJacobian::add(int offset, const Eigen::Ref<const Eigen::Matrix3Xd>& values) {
  const auto known = std::find_if(blocks_.begin() + starts_.back(), blocks_.end(),
                                  [&](const Block& block) { return block.offset == offset; });
  Block& block = known == blocks_.end() ? blocks_.emplace_back() : *known;
  block.offset = offset;
  block.width = static_cast<int>(values.cols());
  block.values.leftCols(values.cols()) += values;
}

Eigen::Matrix3Xd ContactJacobian::multiply(const Eigen::VectorXd& v) const {
  Eigen::Matrix3Xd product = Eigen::Matrix3Xd::Zero(3, contacts());
  for (int i = 0; i < contacts(); ++i)
    for (const Block* block = begin(i); block != end(i); ++block)
      for (int column = 0; column < block->width; ++column)
        product.col(i) += v[block->offset + column] * block->values.col(column);
  return product;
}

void ContactJacobian::add_transposed(const Eigen::Matrix3Xd& p, Eigen::VectorXd& v) const {
  for (int i = 0; i < contacts(); ++i)
    for (const Block* block = begin(i); block != end(i); ++block)
      for (int column = 0; column < block->width; ++column)
        v[block->offset + column] += block->values.col(column).dot(p.col(i));
}

}  // namespace griffith
