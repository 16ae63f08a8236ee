// An executable of its own: it counts every request for memory that the process makes.
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "scanfuse/pipeline/perception.hpp"
#include "scanfuse/simulate/simulate.hpp"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#if defined(__has_feature)
#if !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer)
#define SCANFUSE_COUNTS_MEMORY
#endif
#else
#define SCANFUSE_COUNTS_MEMORY
#endif
#endif

namespace {
thread_local long requests = 0;
}

#ifdef SCANFUSE_COUNTS_MEMORY
// operator new and Eigen's dynamic matrices both end here.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void* malloc(std::size_t size) {
  ++requests;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++requests;
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  ++requests;
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++requests;
  return __libc_memalign(alignment, size);
}
}
#endif

namespace scanfuse {
namespace {

std::vector<pipeline::PosedScan> recorded(const char* scenario, int frames) {
  simulate::SimulateOptions options;
  options.frames = frames;
  auto simulation = simulate::Simulation::create(scenario, 7, options);
  std::vector<pipeline::PosedScan> scans;
  while (auto frame = simulation->next()) {
    scans.push_back(
        {std::move(frame->scan), frame->ego.pose, simulation->ego_from_sensor(), {}, {}, {}});
    scans.back().twist.speed_m_per_s = 10;
  }
  return scans;
}

class Allocation : public testing::TestWithParam<const char*> {};

TEST_P(Allocation, AStepNeedsNoNewMemoryOnceTheBuffersHaveGrown) {
#ifndef SCANFUSE_COUNTS_MEMORY
  GTEST_SKIP() << "requests for memory cannot be counted in this build: skipped";
#endif
  auto scans = recorded(GetParam(), 60);
  pipeline::Perception perception;
  const Duration again =
      scans.back().scan.stamp - scans.front().scan.stamp + std::chrono::milliseconds(80);
  std::size_t tracks = 0;
  for (int round = 0; round < 4; ++round) {
    const long before = requests;
    for (auto& posed : scans) {
      tracks += perception.step(posed).tracks.size();
      posed.scan.stamp += again;
    }
    const long most = round >= 2 ? 0 : 1'000'000;
    EXPECT_LE(requests - before, most) << "round " << round;
  }
  EXPECT_GT(tracks, 100u);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Allocation,
                         testing::Values("lu2018-1", "lu2018-2", "lu2018-3"));

// Guards the guard: the count does see what the chain would ask for.
TEST(AllocationCount, SeesVectorsAndMatrices) {
#ifndef SCANFUSE_COUNTS_MEMORY
  GTEST_SKIP() << "requests for memory cannot be counted in this build: skipped";
#endif
  const long before = requests;
  std::vector<double> numbers(1000);
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(30, 30);
  EXPECT_GE(requests - before, 2);
  EXPECT_EQ(numbers.size() + static_cast<std::size_t>(matrix.size()), 1900u);
}

}  // namespace
}  // namespace scanfuse
