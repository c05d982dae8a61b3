#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace griffith::app {

/// Keeps a key down until the frame that was told of it has seen it. Where frames take longer than a tap on a key, its
/// press and its release arrive together, and an interface that asks for the state of the keys once a frame would miss
/// it.
class KeyLatch {
 public:
  void press(int key) { new_.push_back(key); }

  /// Whether the release may be told at once; if not, `end_frame` returns the key.
  bool release(int key) {
    if (std::find(new_.begin(), new_.end(), key) == new_.end()) return true;
    late_.push_back(key);
    return false;
  }

  /// To be called when the frame has read the keys: the keys whose release is due now.
  std::vector<int> end_frame() {
    new_.clear();
    return std::exchange(late_, {});
  }

 private:
  std::vector<int> new_, late_;
};

}  // namespace griffith::app
