#include <gtest/gtest.h>

#include "scanfuse/simulate/simulate.hpp"

namespace scanfuse::simulate {
namespace {

std::vector<std::vector<int>> points_seen(std::string_view scenario, std::uint64_t seed) {
  auto simulation = Simulation::create(scenario, seed);
  std::vector<std::vector<int>> seen;
  while (auto frame = simulation->next()) {
    seen.resize(frame->truth.objects.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      seen[i].push_back(*frame->truth.objects[i].visible_points);
    }
  }
  return seen;
}

TEST(Print, Print) {
  for (const auto* name : {"lu2018-1", "lu2018-2", "lu2018-3"}) {
    for (int seed = 1; seed <= 4; ++seed) {
      const auto seen = points_seen(name, seed);
      for (const auto& object : seen) {
        std::string line = fmt::format("{} {}:", name, seed);
        for (std::size_t f = 0; f < object.size(); ++f) line += fmt::format(" {}", object[f]);
        std::puts(line.c_str());
      }
    }
  }
}

}  // namespace
}  // namespace scanfuse::simulate
