#include "scanfuse/io/tables.hpp"

#include <gmock/gmock.h>

#include "io/reading.hpp"
#include "io/temporary_folder.hpp"
#include "scanfuse/io/csv/tables_of_lines.hpp"
#include "scanfuse/io/result_writer.hpp"

namespace scanfuse::io {
namespace {

using scanfuse::io_testing::content_of;
using scanfuse::io_testing::lines_of;
using scanfuse::io_testing::TemporaryFolder;
using ::testing::HasSubstr;

StepResult sample_step() {
  StepResult step;
  step.stamp = time_from_nanos(1575811624359102488);
  step.frame = 12;
  for (int k = 0; k < 2; ++k) {
    Track track;
    track.id = 40 + k;
    track.object_class = k == 0 ? ObjectClass::kVehicle : ObjectClass::kCyclist;
    track.class_probability = 0.875;
    track.status = k == 0 ? TrackStatus::kConfirmed : TrackStatus::kCoasting;
    track.box = {{1.0 / 3, -2.5e-7}, 0.1, 4.5, 1.8};
    track.z_m = 0.7;
    track.height_m = 1.5;
    track.state.mean << 1.0 / 3, 5.5, -2.5e-7, -0.25;
    track.state.covariance.setZero();
    track.state.covariance(0, 0) = 0.04;
    track.state.covariance(2, 2) = 0.09;
    track.state.covariance(0, 2) = track.state.covariance(2, 0) = -0.01;
    track.speed_m_per_s = 5.505;
    track.accel_m_per_s2 = -0.5;
    track.yaw_rate_rad_per_s = 0.02;
    track.age_frames = 9;
    track.missed_frames = k;
    track.moving_probability = 0.25 + 0.5 * k;
    step.tracks.push_back(track);
  }
  return step;
}

TEST(ResultWriter, TracksReadBackAsTheyWereWrittenInEveryTextFormat) {
  const TemporaryFolder folder;
  for (const char* name : {"tracks.csv", "tracks.jsonl"}) {
    const auto path = folder.path() / name;
    const StepResult step = sample_step();
    {
      auto writer = open_result_writer(path);
      ASSERT_TRUE(writer);
      ASSERT_TRUE((*writer)->write(step, Scan{}));
      EXPECT_FALSE(std::filesystem::exists(path)) << "half-written files must not look whole";
      ASSERT_TRUE((*writer)->finish());
    }
    Diagnostics diagnostics;
    const auto read = read_tracks(path, &diagnostics);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(diagnostics.empty());
    ASSERT_EQ(read->size(), 1u);
    const StepResult& back = read->front();
    EXPECT_EQ(back.stamp, step.stamp);
    EXPECT_EQ(back.frame, step.frame);
    ASSERT_EQ(back.tracks.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      const Track &a = step.tracks[k], &b = back.tracks[k];
      EXPECT_EQ(a.id, b.id);
      EXPECT_EQ(a.object_class, b.object_class);
      EXPECT_EQ(a.status, b.status);
      EXPECT_EQ(a.box.centre_m, b.box.centre_m);
      EXPECT_EQ(a.box.heading_rad, b.box.heading_rad);
      EXPECT_EQ(a.state.mean, b.state.mean);
      EXPECT_EQ(a.state.covariance(0, 2), b.state.covariance(0, 2));
      EXPECT_EQ(a.missed_frames, b.missed_frames);
      EXPECT_EQ(a.moving_probability, b.moving_probability);
      EXPECT_EQ(a.height_m, b.height_m);
    }
  }
}

TEST(ResultWriter, TheHeaderIsTheOneThatScriptsRelyOn) {
  const TemporaryFolder folder;
  auto writer = open_result_writer(folder.path() / "t.csv");
  ASSERT_TRUE((*writer)->finish());
  EXPECT_EQ(content_of(folder.path() / "t.csv"),
            "time_s,frame,track_id,class,class_probability,status,x_m,y_m,z_m,heading_rad,"
            "vx_m_per_s,vy_m_per_s,speed_m_per_s,accel_m_per_s2,yaw_rate_rad_per_s,length_m,"
            "width_m,height_m,var_x_m2,cov_xy_m2,var_y_m2,age_frames,missed_frames,"
            "moving_probability\n");
  EXPECT_TRUE(read_tracks(folder.path() / "t.csv")) << "a run without tracks is no fault";
}

TEST(ResultWriter, NumbersThatAreNotFiniteNeverReachTheFile) {
  const TemporaryFolder folder;
  StepResult step = sample_step();
  step.tracks[0].accel_m_per_s2 = std::nan("");
  step.tracks[1].yaw_rate_rad_per_s = INFINITY;
  for (const char* name : {"t.csv", "t.jsonl"}) {
    auto writer = open_result_writer(folder.path() / name);
    ASSERT_TRUE((*writer)->write(step, Scan{}));
    ASSERT_TRUE((*writer)->finish());
    const std::string text = content_of(folder.path() / name);
    EXPECT_EQ(text.find("nan"), text.npos);
    EXPECT_EQ(text.find("inf"), text.npos);
    EXPECT_TRUE(read_tracks(folder.path() / name));
  }
}

TEST(ResultWriter, DestroyedUnfinishedLeavesNothingAndUnknownNamesAreRefused) {
  const TemporaryFolder folder;
  {
    auto writer = open_result_writer(folder.path() / "t.csv");
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  const auto refused = open_result_writer(folder.path() / "t.xlsx");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr(".jsonl"));
  EXPECT_FALSE(open_result_writer(folder.path() / "no" / "folder" / "t.csv"));
}

TEST(TrackTable, FewColumnsSuffice) {
  Diagnostics diagnostics;
  const auto read = read_track_table(
      lines_of("frame,time_s,track_id,class,x_m,y_m\n1,0.1,7,vehicle,1,2\n0,0,7,lorry,1,2\n"),
      diagnostics);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 2u);
  EXPECT_EQ((*read)[0].frame, 0);
  EXPECT_EQ((*read)[0].tracks[0].object_class, ObjectClass::kOther);
  EXPECT_EQ((*read)[1].tracks[0].status, TrackStatus::kConfirmed);
  EXPECT_EQ(diagnostics.count("unknown class taken as 'other'"), 1);
}

TEST(TrackTable, ImpossibleRowsAreDamage) {
  Diagnostics diagnostics;
  const auto read = read_track_table(
      lines_of("frame,time_s,track_id,x_m,y_m,status,var_x_m2,cov_xy_m2,var_y_m2\n"
               "0,0,1,1,1,confirmed,1,0,1\n0,0,2,1,1,alive,1,0,1\n0,0,3,1,1,confirmed,-1,0,1\n"
               "0,0,4,1,1,confirmed,1,5,1\n0,0,x,1,1,confirmed,1,0,1\n"),
      diagnostics);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->front().tracks.size(), 1u);
  EXPECT_EQ(diagnostics.count("bad row skipped"), 4);
}

TEST(TrackTable, BrokenJsonLinesAreDamageAndNestingIsNoTrap) {
  Diagnostics diagnostics;
  const auto read = read_track_table(
      lines_of("{\"frame\":0,\"time_s\":1.000000001,\"track_id\":1,\"x_m\":1,\"y_m\":2,\"extra\":"
               "{\"x_m\":[9]}}\n{\"frame\":0,\n[1,2]\n" +
               std::string(100000, '[') +
               "\n{\"frame\":1,\"time_s\":2,\"track_id\":1,\"x_m\":null,"
               "\"y_m\":2}\n"),
      diagnostics);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->size(), 1u);
  EXPECT_EQ(to_nanos(read->front().stamp), 1'000'000'001);
  EXPECT_EQ(read->front().tracks[0].box.centre_m.x(), 1);
  EXPECT_EQ(diagnostics.count("bad row skipped"), 4);
}

TEST(TruthTable, OptionalColumnsStayEmptyAndFramesAreGrouped) {
  Diagnostics diagnostics;
  const auto read = read_truth_table(
      lines_of("frame,time_s,object_id,class,x_m,y_m,heading_rad,visible_points\n"
               "1,0.1,5,pedestrian,1,2,,3\n0,0,5,vehicle,1,2,0.5,\n1,0.1,6,cyclist,4,5,1,0\n"),
      diagnostics);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 2u);
  EXPECT_EQ((*read)[0].objects[0].heading_rad, 0.5);
  EXPECT_FALSE((*read)[0].objects[0].visible_points);
  EXPECT_FALSE((*read)[1].objects[0].heading_rad);
  EXPECT_EQ((*read)[1].objects[0].visible_points, 3);
  EXPECT_FALSE((*read)[1].objects[0].velocity_m_per_s);
  EXPECT_EQ((*read)[1].objects.size(), 2u);
}

TEST(TruthTable, WrittenTruthReadsBackTheSame) {
  const TemporaryFolder folder;
  TruthFrame frame{time_from_nanos(123456789), 4, "world", {}};
  TruthObject object;
  object.id = 3;
  object.object_class = ObjectClass::kVehicle;
  object.position_m = {0.1, -20.25};
  object.heading_rad = -1.25;
  object.velocity_m_per_s = Eigen::Vector2d(3, 4);
  object.length_m = 4.4;
  object.visible_points = 17;
  frame.objects = {object};
  ASSERT_TRUE(write_truth_csv(folder.path() / "truth.csv", std::vector{frame}));
  const auto read = read_truth(folder.path() / "truth.csv");
  ASSERT_TRUE(read);
  const TruthObject& back = read->front().objects.front();
  EXPECT_EQ(read->front().stamp, frame.stamp);
  EXPECT_EQ(back.position_m, object.position_m);
  EXPECT_EQ(back.velocity_m_per_s, object.velocity_m_per_s);
  EXPECT_EQ(back.length_m, 4.4);
  EXPECT_FALSE(back.width_m);
  EXPECT_EQ(back.visible_points, 17);
}

TEST(EgoTable, PosesComeInOrderOfTimeAndReadBack) {
  Diagnostics diagnostics;
  const auto read =
      read_ego_table(lines_of("time_s,x_m,y_m,heading_rad,speed_m_per_s\n2,3,4,1.5,7\n1,0,0,0,\n"
                              "3,nan,0,0,1\n"),
                     diagnostics);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 2u);
  EXPECT_FALSE(read->front().speed_m_per_s);
  EXPECT_EQ(read->back().speed_m_per_s, 7);
  EXPECT_NEAR(read->back().pose.planar().heading_rad, 1.5, 1e-12);
  EXPECT_EQ(diagnostics.count("ego motion out of order, sorted"), 1);
  EXPECT_EQ(diagnostics.count("bad row skipped"), 1);
  const TemporaryFolder folder;
  ASSERT_TRUE(write_ego_csv(folder.path() / "ego.csv", *read));
  const auto again = read_ego(folder.path() / "ego.csv");
  ASSERT_TRUE(again);
  EXPECT_NEAR(again->back().pose.planar().heading_rad, 1.5, 1e-12);
  EXPECT_FALSE(read_ego(folder.path() / "missing.csv"));
}

TEST(DetectionTable, EverythingOfADetectionReadsBackAndEmptyFramesStay) {
  const TemporaryFolder folder;
  Detection detection;
  detection.object_class = ObjectClass::kPedestrian;
  detection.score = 0.25;
  detection.box = {{5, -6}, 0.75, 0.6, 0.5};
  detection.z_m = -0.5;
  detection.height_m = 1.75;
  detection.covariance << 0.04, 0.01, 0.002, 0.01, 0.09, -0.003, 0.002, -0.003, 0.16;
  detection.var_length_m2 = 0.3;
  detection.length_seen = true;
  detection.faces_seen = 2;
  detection.right_end_occluded = true;
  detection.points = 31;
  detection.seen_from_m = {0.5, 0.25};
  detection.visible_middle_m = {4.75, -6};
  const std::vector<DetectionFrame> frames = {{time_from_nanos(5), 0, "/front", {detection}},
                                              {time_from_nanos(100), 1, "/front", {}}};
  ASSERT_TRUE(write_detections(folder.path() / "d.csv", frames));
  EXPECT_EQ(table_kind(folder.path() / "d.csv"), TableKind::kDetections);
  Diagnostics diagnostics;
  const auto read = read_detections(folder.path() / "d.csv", &diagnostics);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(diagnostics.empty());
  ASSERT_EQ(read->size(), 2u);
  EXPECT_TRUE((*read)[1].detections.empty());
  const Detection& back = (*read)[0].detections.front();
  EXPECT_EQ((*read)[0].sensor, "/front");
  EXPECT_EQ(back.covariance, detection.covariance);
  EXPECT_EQ(back.box.centre_m, detection.box.centre_m);
  EXPECT_EQ(back.object_class, detection.object_class);
  EXPECT_EQ(back.length_seen, true);
  EXPECT_EQ(back.width_seen, false);
  EXPECT_EQ(back.faces_seen, 2);
  EXPECT_EQ(back.left_end_occluded, false);
  EXPECT_EQ(back.right_end_occluded, true);
  EXPECT_EQ(back.points, 31);
  EXPECT_EQ(back.seen_from_m, detection.seen_from_m);
  EXPECT_EQ(back.visible_middle_m, detection.visible_middle_m);
}

TEST(DetectionTable, WithoutVariancesAUsualOneIsTakenAndImpossibleOnesAreDamage) {
  Diagnostics diagnostics;
  const auto read = read_detection_table(
      lines_of("frame,time_s,class,x_m,y_m,var_x_m2,cov_xy_m2\n0,0,vehicle,1,2,,\n"
               "0,0,vehicle,1,2,-1,\n0,0,vehicle,1,2,0.01,5\n"),
      diagnostics);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->front().detections.size(), 1u);
  EXPECT_NEAR(read->front().detections[0].covariance(0, 0), 0.09, 1e-12);
  EXPECT_EQ(diagnostics.count("bad row skipped"), 2);
}

TEST(TableKind, IsToldByTheHeader) {
  EXPECT_EQ(table_kind_of_header("frame,time_s,x_m,y_m,layer"), TableKind::kPoints);
  EXPECT_EQ(table_kind_of_header("frame,time_s,track_id,class,x_m,y_m"), TableKind::kTracks);
  EXPECT_EQ(table_kind_of_header("frame,time_s,object_id,class,x_m,y_m"), TableKind::kTruth);
  EXPECT_EQ(table_kind_of_header("frame,time_s,class,score,x_m,y_m"), TableKind::kDetections);
  EXPECT_EQ(table_kind_of_header("time_s,x_m,y_m,heading_rad"), TableKind::kEgo);
  EXPECT_EQ(table_kind_of_header("scan,time_s,sensor,measurement,azimuth_rad,elevation_rad"),
            TableKind::kBearings);
  EXPECT_EQ(table_kind_of_header("x,y"), TableKind::kPoints);
  EXPECT_EQ(table_kind_of_header("hello, world"), TableKind::kNone);
}

TEST(TruthTable, TheRoadSequencesTablesAreReadWhole) {
  const std::filesystem::path folder = SCANFUSE_SHARED_DATA "/road/kitti_seq0000";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data: skipped";
  Diagnostics diagnostics;
  const auto truth = read_truth(folder / "truth_lidar_frame.csv", &diagnostics);
  const auto ego = read_ego(folder / "ego.csv", &diagnostics);
  ASSERT_TRUE(truth && ego);
  EXPECT_EQ(truth->size(), 90u);
  EXPECT_EQ(ego->size(), 90u);
  EXPECT_FALSE(diagnostics.any_damage());
}

}  // namespace
}  // namespace scanfuse::io
