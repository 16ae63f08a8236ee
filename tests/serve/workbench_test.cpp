#include "scanfuse/serve/workbench.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "scanfuse/serve/wire.hpp"
#include "serve/simulated_source.hpp"

namespace scanfuse::serve {
namespace {

using scanfuse::testing::simulated_bench;
using scanfuse::testing::SimulatedScans;

constexpr int kFrames = 40;

void wait_for_trial(const Workbench& bench) {
  while (bench.status().trial_runs || bench.run(RunName::kTrial) == nullptr) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

TEST(Workbench, KeepsEveryFrameInAnyOrder) {
  const auto bench = simulated_bench(kFrames);
  ASSERT_TRUE(bench);
  EXPECT_EQ(bench->status().frames, static_cast<std::uint32_t>(kFrames));
  EXPECT_TRUE(bench->status().done);
  for (const std::uint32_t frame : {39U, 0U, 17U, 5U}) {
    const auto message = bench->run(RunName::kMain)->message(frame);
    ASSERT_TRUE(message) << message.error().message;
    WireReader in(*message);
    EXPECT_EQ(in.get<std::uint32_t>(), 1U);
    EXPECT_EQ(in.get<std::uint32_t>(), 0U);
    EXPECT_EQ(in.get<std::uint32_t>(), frame);
  }
  EXPECT_FALSE(bench->run(RunName::kMain)->message(40));
}

TEST(Workbench, GivesWhatTheChainGives) {
  const auto bench = simulated_bench(kFrames);
  SimulatedScans again(kFrames);
  pipeline::Perception perception;
  for (std::uint32_t frame = 0;; ++frame) {
    const auto posed = again.next();
    if (!posed || !*posed) break;
    const StepResult& wanted = perception.step(**posed);
    const auto given = bench->run(RunName::kMain)->step(frame);
    ASSERT_TRUE(given);
    ASSERT_EQ(given->tracks.size(), wanted.tracks.size()) << frame;
    for (std::size_t i = 0; i < wanted.tracks.size(); ++i) {
      EXPECT_EQ(given->tracks[i].id, wanted.tracks[i].id);
      EXPECT_NEAR((given->tracks[i].box.centre_m - wanted.tracks[i].box.centre_m).norm(), 0, 1e-6);
    }
  }
}

TEST(Workbench, TellsBirthsOnceForEachConfirmedTrack) {
  const auto bench = simulated_bench(kFrames);
  const auto run = bench->run(RunName::kMain);
  std::map<std::int64_t, int> births;
  for (const auto& event : run->events(0)) births[event.track] += event.kind == EventKind::kBirth;
  ASSERT_FALSE(births.empty());
  for (const auto& [track, count] : births) {
    EXPECT_EQ(count, 1) << track;
    const auto history = run->history(track);
    ASSERT_TRUE(history);
    EXPECT_EQ(history->front().frame, run->life(track)->first);
    EXPECT_EQ(history->back().frame, run->life(track)->second);
  }
  EXPECT_FALSE(run->history(123456));
}

TEST(Workbench, ATrialOfTheSameOptionsAgreesOnceItHasSeenAsMuch) {
  const auto bench = simulated_bench(kFrames);
  bench->start_trial(0, bench->options().options);
  wait_for_trial(*bench);
  const auto comparison = bench->compare();
  ASSERT_TRUE(comparison);
  ASSERT_TRUE(comparison->main && comparison->trial);
  EXPECT_EQ(comparison->end, static_cast<std::uint32_t>(kFrames));
  EXPECT_EQ(evaluate::to_json(*comparison->main), evaluate::to_json(*comparison->trial));
}

TEST(Workbench, TheNewestTrialWins) {
  const auto bench = simulated_bench(kFrames);
  auto options = bench->options().options;
  for (int i = 0; i < 20; ++i) {
    options.track.confirm_hits = 2 + i % 3;
    bench->start_trial(static_cast<std::uint32_t>(i), options);
  }
  wait_for_trial(*bench);
  EXPECT_EQ(bench->status().trial, 20U);
  EXPECT_EQ(bench->status().trial_from, 19U);
  EXPECT_EQ(bench->run(RunName::kTrial)->first(), 14U) << "five frames to warm up";
  bench->stop_trial();
  EXPECT_EQ(bench->run(RunName::kTrial), nullptr);
}

TEST(Workbench, EndsWhileItReads) {
  WorkbenchOptions options;
  const auto bench = Workbench::create(std::make_unique<SimulatedScans>(100000),
                                       show_with(options.options), options);
  ASSERT_TRUE(bench);
  while ((*bench)->status().frames < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(ScanLog, GivesBackTheScanBitForBit) {
  SimulatedScans source(1);
  auto posed = *source.next();
  posed->mount_is_known = false;
  const auto back = unpack_scan(pack(*posed));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->scan.stamp, posed->scan.stamp);
  EXPECT_EQ(back->scan.sensor, posed->scan.sensor);
  EXPECT_FALSE(back->mount_is_known);
  ASSERT_EQ(back->scan.returns.size(), posed->scan.returns.size());
  for (std::size_t i = 0; i < posed->scan.returns.size(); ++i) {
    EXPECT_EQ(back->scan.returns[i].x_m, posed->scan.returns[i].x_m);
    EXPECT_EQ(back->scan.returns[i].beam, posed->scan.returns[i].beam);
  }
  EXPECT_EQ(back->scan.beams->columns, posed->scan.beams->columns);
  for (const auto& text : {std::string(), pack(*posed).substr(0, 90)}) {
    EXPECT_FALSE(unpack_scan(text));
  }
}

}  // namespace
}  // namespace scanfuse::serve
