#include "sim/core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace griffith {
namespace {

/// Tells the thread sanitizer, which does not see into TBB, that what comes before give() in one thread comes before
/// what follows take() in another.
class Handover {
 public:
#ifdef __SANITIZE_THREAD__
  void give() { __tsan_release(this); }
  void take() { __tsan_acquire(this); }
#else
  void give() {}
  void take() {}
#endif
};

}  // namespace

struct ThreadLimit::Impl {
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads)
    : impl_(new Impl{tbb::global_control(tbb::global_control::max_allowed_parallelism, threads)}) {}
ThreadLimit::~ThreadLimit() = default;

int default_thread_count() { return tbb::info::default_concurrency(); }

void parallel_for(int count, int grain, const std::function<void(int, int)>& body) {
  if (count <= 0) return;
  if (count <= grain) return body(0, count);
  Handover start, end;
  start.give();
  tbb::parallel_for(tbb::blocked_range<int>(0, count, grain), [&](const tbb::blocked_range<int>& range) {
    start.take();
    body(range.begin(), range.end());
    end.give();
  });
  end.take();
}

double parallel_sum(int count, const std::function<double(int, int)>& block) {
  constexpr int kBlock = 2048;
  if (count <= kBlock) return count > 0 ? block(0, count) : 0.0;
  const int blocks = (count + kBlock - 1) / kBlock;
  std::vector<double> sums(blocks);
  parallel_for(blocks, 1, [&](int begin, int end) {
    for (int b = begin; b < end; ++b) sums[b] = block(b * kBlock, std::min(count, (b + 1) * kBlock));
  });
  double sum = 0;
  for (double s : sums) sum += s;
  return sum;
}

}  // namespace griffith
