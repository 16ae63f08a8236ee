// Uses the installed library the way a user would: a scan in, its clusters and a filter out.
#include <cstdio>

#include "scanfuse/core/random.hpp"
#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/io/recording.hpp"

int main() {
  const auto missing = scanfuse::io::open_recording("no/such/recording.mcap");
  if (missing) {
    std::puts("a missing file was opened");
    return 1;
  }
  std::printf("scanfuse answers: %s\n", missing.error().message.c_str());
  return 0;
}
