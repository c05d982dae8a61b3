#include "sim/core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

namespace griffith {
namespace {

int allowed_threads() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

#ifdef __SANITIZE_THREAD__
/// The thread sanitizer does not see into TBB. Under it, visible threads do the same parts.
void run_parts(int count, int grain, const std::function<void(int, int)>& body) {
  const int threads = std::min(allowed_threads(), (count + grain - 1) / grain);
  std::vector<std::jthread> others;
  for (int i = 1; i < threads; ++i)
    others.emplace_back([=, &body] { body(count / threads * i, i + 1 < threads ? count / threads * (i + 1) : count); });
  body(0, threads > 1 ? count / threads : count);
}
#else
void run_parts(int count, int grain, const std::function<void(int, int)>& body) {
  tbb::parallel_for(tbb::blocked_range<int>(0, count, grain),
                    [&](const tbb::blocked_range<int>& range) { body(range.begin(), range.end()); });
}
#endif

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
  run_parts(count, grain, body);
}

void parallel_parts(int count, int grain, const std::function<void(int, int)>& body) {
  if (count <= 0) return;
  const std::int64_t parts = std::clamp(count / grain, 1, allowed_threads());
  const auto start = [&](int part) { return static_cast<int>(count * part / parts); };
  parallel_for(static_cast<int>(parts), 1, [&](int first, int last) {
    for (int part = first; part < last; ++part) body(start(part), start(part + 1));
  });
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
