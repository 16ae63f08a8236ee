// Uses the installed library the way a user would: simulated scans in, tracks out.
#include <algorithm>
#include <cstdio>

#include "scanfuse/io/recording.hpp"
#include "scanfuse/pipeline/perception.hpp"
#include "scanfuse/simulate/simulate.hpp"

int main() {
  const auto missing = scanfuse::io::open_recording("no/such/recording.mcap");
  if (missing) {
    std::puts("a missing file was opened");
    return 1;
  }
  std::printf("scanfuse answers: %s\n", missing.error().message.c_str());

  auto simulation = scanfuse::simulate::Simulation::create("lu2018-1", 1);
  if (!simulation) return 1;
  scanfuse::pipeline::Perception perception;
  scanfuse::pipeline::PosedScan posed;
  posed.ego_from_sensor = simulation->ego_from_sensor();
  std::size_t most = 0;
  for (int i = 0; i < 30; ++i) {
    auto frame = simulation->next();
    if (!frame) return 1;
    posed.scan = std::move(frame->scan);
    posed.world_from_ego = frame->ego.pose;
    most = std::max(most, perception.step(posed).tracks.size());
  }
  std::printf("at most %zu tracks at a time\n", most);
  return most > 0 ? 0 : 1;
}
