#include "process_memory.hpp"

#include <malloc.h>

#include <fstream>
#include <string>

namespace scanfuse::app {
namespace {

/// A line of /proc/self/status, which counts kB.
double status_mb(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == name && status >> kilobytes) return kilobytes / 1024;
  }
  return 0;
}

}  // namespace

double resident_mb() { return status_mb("VmRSS:"); }

double peak_memory_mb() { return status_mb("VmHWM:"); }

void forget_peak_memory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // proc(5): resets the peak
}

}  // namespace scanfuse::app
