#include "sim/core/low_priority.h"

#include <tbb/task_scheduler_observer.h>
#ifdef __linux__
#include <sys/resource.h>
#endif

namespace griffith {
namespace {

/// Lowers the priority of the calling thread.
void lower_priority() {
#ifdef __linux__
  constexpr int kNice = 10;  // a tenth of the processor time of a thread of the usual priority that wants as much
  setpriority(PRIO_PROCESS, 0, kNice);
#endif
}

}  // namespace

class LowPriority::Workers : public tbb::task_scheduler_observer {
 public:
  Workers() { observe(true); }
  ~Workers() override { observe(false); }
  void on_scheduler_entry(bool is_worker) override {
    if (is_worker) lower_priority();
  }
};

LowPriority::LowPriority() : workers_(std::make_unique<Workers>()) { lower_priority(); }
LowPriority::~LowPriority() = default;

}  // namespace griffith
