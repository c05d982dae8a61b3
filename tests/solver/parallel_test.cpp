#include "sim/core/parallel.h"

#include <gtest/gtest.h>
#ifdef __linux__
#include <sys/resource.h>
#endif

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "sim/core/low_priority.h"

namespace griffith {
namespace {

TEST(Parallel, CollectsInTheOrderOfIndicesForAnyNumberOfThreads) {
  for (const int count : {0, 1, 1023, 1024, 1025, 10'000}) {
    std::vector<int> expected = {-1};
    for (int i = 0; i < count; ++i)
      if (i % 3 != 1) expected.push_back(i);
    for (const int threads : {1, 2, 4}) {
      const ThreadLimit limit(threads);
      std::vector<int> all = {-1};  // stays
      parallel_collect(count, all, [](int begin, int end, std::vector<int>& found) {
        for (int i = begin; i < end; ++i)
          if (i % 3 != 1) found.push_back(i);
      });
      EXPECT_EQ(all, expected) << count << " on " << threads;
    }
  }
}

TEST(Parallel, VisitsEveryIndexOnce) {
  for (const int count : {1, 63, 64, 65, 5000})
    for (const int threads : {1, 2, 4}) {
      const ThreadLimit limit(threads);
      std::vector<int> visits(count, 0);
      parallel_for(count, 64, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << count << " on " << threads;
    }
}

TEST(Parallel, PartsAreAsManyAsThreadsAndCoverAllOnce) {
  for (const int threads : {1, 2, 4})
    for (const int count : {0, 1, 99, 100, 250, 1001}) {
      const ThreadLimit limit(threads);
      std::vector<int> visits(count, 0);
      std::atomic<int> parts = 0;
      parallel_parts(count, 100, [&](int begin, int end) {
        EXPECT_GE(end - begin, std::min(count, 100));
        for (int i = begin; i < end; ++i) ++visits[i];
        ++parts;
      });
      EXPECT_EQ(parts, count == 0 ? 0 : std::clamp(count / 100, 1, threads)) << count;
      EXPECT_EQ(std::ranges::count(visits, 1), count);
    }
}

#ifdef __linux__
TEST(LowPriority, IsThatOfAThreadAndOfItsWorkersAlone) {
  const int usual = getpriority(PRIO_PROCESS, 0);
  std::thread background([usual] {
    const LowPriority low;
    EXPECT_GT(getpriority(PRIO_PROCESS, 0), usual);
    parallel_for(1 << 20, 1 << 10, [usual](int, int) { EXPECT_GT(getpriority(PRIO_PROCESS, 0), usual); });
  });
  background.join();
  EXPECT_EQ(getpriority(PRIO_PROCESS, 0), usual);
}
#endif

TEST(Parallel, SumsToTheSameBitsForAnyNumberOfThreads) {
  constexpr int kCount = 100'000;
  const auto sum = [](int threads) {
    const ThreadLimit limit(threads);
    return parallel_sum(kCount, [](int begin, int end) {
      double part = 0;
      for (int i = begin; i < end; ++i) part += std::sin(i);
      return part;
    });
  };
  const double one = sum(1);
  EXPECT_EQ(sum(2), one);
  EXPECT_EQ(sum(4), one);
  double plain = 0;
  for (int i = 0; i < kCount; ++i) plain += std::sin(i);
  EXPECT_NEAR(one, plain, 1e-10);
}

}  // namespace
}  // namespace griffith
