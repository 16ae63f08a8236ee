#include "scanfuse/serve/labels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scanfuse/io/tables.hpp"
#include "serve/simulated_source.hpp"

namespace scanfuse::serve {
namespace {

using Action = LabelRequest::Action;

class LabelsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    bench_ = scanfuse::testing::simulated_bench(70);
    ASSERT_TRUE(bench_);
    run_ = bench_->run(RunName::kMain);
    for (const auto& event : run_->events(0)) {
      if (event.kind == EventKind::kBirth) tracks_.push_back(event.track);
    }
    ASSERT_GE(tracks_.size(), 2U);
  }
  Result<void> apply(Action action, std::int64_t id, std::uint32_t frame = 0,
                     std::int64_t other = 0) {
    LabelRequest request;
    request.action = action;
    request.track = request.object = id;
    request.frame = frame;
    request.other = other;
    return labels_.apply(request, *run_, bench_->log());
  }

  std::unique_ptr<Workbench> bench_;
  std::shared_ptr<const serve::Run> run_;
  std::vector<std::int64_t> tracks_;
  Labels labels_;
};

TEST_F(LabelsTest, AnAcceptedTrackIsTruthOverItsLife) {
  ASSERT_TRUE(apply(Action::kAccept, tracks_[0]));
  const auto& object = labels_.objects().at(tracks_[0]);
  EXPECT_EQ(object.boxes.begin()->first, run_->life(tracks_[0])->first);
  EXPECT_FALSE(apply(Action::kAccept, 987654));
  EXPECT_EQ(labels_.objects().size(), 1U);
}

TEST_F(LabelsTest, SplitAndMergeUndoEachOther) {
  ASSERT_TRUE(apply(Action::kAccept, tracks_[0]));
  const auto whole = labels_.objects().at(tracks_[0]).boxes.size();
  const auto life = *run_->life(tracks_[0]);
  const std::uint32_t middle = (life.first + life.second) / 2;
  ASSERT_TRUE(apply(Action::kSplit, tracks_[0], middle));
  ASSERT_EQ(labels_.objects().size(), 2U);
  const auto later = labels_.objects().rbegin()->first;
  EXPECT_EQ(labels_.objects().at(later).boxes.begin()->first, middle);
  ASSERT_TRUE(apply(Action::kMerge, later, 0, tracks_[0]));
  EXPECT_EQ(labels_.objects().size(), 1U);
  EXPECT_EQ(labels_.objects().at(tracks_[0]).boxes.size(), whole);
  EXPECT_FALSE(apply(Action::kSplit, tracks_[0], life.first)) << "nothing lies before it";
  EXPECT_FALSE(apply(Action::kMerge, tracks_[0], 0, tracks_[0]));
}

TEST_F(LabelsTest, EveryChangeCanBeUndone) {
  ASSERT_TRUE(apply(Action::kAccept, tracks_[0]));
  ASSERT_TRUE(apply(Action::kAccept, tracks_[1]));
  const std::string before = labels_.csv(bench_->log());
  LabelRequest request;
  request.object = tracks_[0];
  request.frame = labels_.objects().at(tracks_[0]).boxes.begin()->first;
  request.box = Box2{{1, 2}, 0.5, 4, 2};
  for (const auto action :
       {Action::kCorrect, Action::kClass, Action::kRemoveFrame, Action::kRemove}) {
    request.action = action;
    ASSERT_TRUE(labels_.apply(request, *run_, bench_->log()));
    EXPECT_NE(labels_.csv(bench_->log()), before);
    ASSERT_TRUE(apply(Action::kUndo, 0));
    EXPECT_EQ(labels_.csv(bench_->log()), before);
  }
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(apply(Action::kUndo, 0));
  EXPECT_TRUE(labels_.objects().empty());
}

TEST_F(LabelsTest, WhatIsSavedIsReadAgain) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "labels_truth.csv";
  labels_ = Labels(file);
  ASSERT_TRUE(apply(Action::kAccept, tracks_[0]));
  ASSERT_TRUE(apply(Action::kAccept, tracks_[1]));
  EXPECT_FALSE(labels_.is_saved());
  ASSERT_TRUE(apply(Action::kSave, 0));
  EXPECT_TRUE(labels_.is_saved());
  const auto truth = io::read_truth(file);
  ASSERT_TRUE(truth) << truth.error().message;
  Labels again(file);
  again.load(*truth, bench_->log());
  EXPECT_EQ(again.csv(bench_->log()), labels_.csv(bench_->log()));
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace scanfuse::serve
