#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

namespace griffith {

/// Limits the threads of the simulation during its lifetime. Results do not depend on the number.
class ThreadLimit {
 public:
  /// `threads` >= 1.
  explicit ThreadLimit(int threads);
  ~ThreadLimit();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the number of threads in use without a limit.
int default_thread_count();

/// Calls body(begin, end) for ranges that together cover [0, count), each at least `grain` long, in any order and on
/// any thread. The body writes only to its own range, so results do not depend on the threads.
void parallel_for(int count, int grain, const std::function<void(int begin, int end)>& body);

/// Calls body(begin, end) for as many equal ranges of [0, count) as there are threads, or for fewer so that each is at
/// least `grain` long. For work whose cost grows with the number of ranges.
void parallel_parts(int count, int grain, const std::function<void(int begin, int end)>& body);

/// Returns the sum of block(begin, end) over consecutive blocks of fixed length, added in order. Has the same bits for
/// any number of threads.
double parallel_sum(int count, const std::function<double(int begin, int end)>& block);

/// Appends to `all` the results that find(begin, end, found) appends to `found`, for consecutive blocks that cover [0,
/// count), in the order of the blocks. The result is the same for any number of threads.
template <class T, class Find>
void parallel_collect(int count, std::vector<T>& all, const Find& find) {
  constexpr int kBlock = 1024;
  if (count <= kBlock) return find(0, count, all);
  std::vector<std::vector<T>> found((count + kBlock - 1) / kBlock);
  parallel_for(static_cast<int>(found.size()), 1, [&](int first, int last) {
    for (int i = first; i < last; ++i) find(i * kBlock, std::min(count, (i + 1) * kBlock), found[i]);
  });
  for (const std::vector<T>& of_block : found) all.insert(all.end(), of_block.begin(), of_block.end());
}

}  // namespace griffith
