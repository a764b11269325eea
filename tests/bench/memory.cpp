#include <fstream>
#include <string>

#include "bench.h"

#ifdef __EMSCRIPTEN__
#include <emscripten/heap.h>
#else
#include <sys/resource.h>
#ifdef __linux__
#include <malloc.h>
#endif
#endif

namespace seamwise::bench {

#if defined(__EMSCRIPTEN__)

namespace {
double top() { return static_cast<double>(*emscripten_get_sbrk_ptr()); }
const double kAtStart = top();
}  // namespace

PeakMemory::PeakMemory() : before_(kAtStart) {}
double PeakMemory::bytes() const { return top() - before_; }

#elif defined(__linux__)

namespace {

/// Reads a field of /proc/self/status. [bytes]
double statusBytes(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != field) continue;
    double kilobytes = 0;
    status >> kilobytes;
    return 1024 * kilobytes;
  }
  return 0;
}

}  // namespace

PeakMemory::PeakMemory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // resets the peak
  before_ = statusBytes("VmRSS:");
}

double PeakMemory::bytes() const { return statusBytes("VmHWM:") - before_; }

#else

namespace {
double peak() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss);
}
}  // namespace

PeakMemory::PeakMemory() : before_(peak()) {}
double PeakMemory::bytes() const { return peak() - before_; }

#endif

}  // namespace seamwise::bench
