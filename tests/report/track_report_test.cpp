#include "scanfuse/report/track_report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scanfuse/report/page.hpp"
#include "scanfuse/report/svg_plot.hpp"

namespace scanfuse::report {
namespace {

/// Two cars ahead of a moving ego vehicle; the second is missed for some frames.
struct Drive {
  StepResult step;
  Scan scan;
  VirtualScan flat;
  Clusters clusters;
  TruthFrame truth;
};

void add_box_points(Drive& drive, const Box2& box) {
  for (int i = 0; i <= 40; ++i) {
    const double u = i / 40.0;
    const auto c = box.corners();
    const Eigen::Vector2d p = c[1] + u * (c[2] - c[1]);
    drive.clusters.indices.push_back(static_cast<std::uint32_t>(drive.flat.points.size()));
    drive.flat.points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y())});
  }
  drive.clusters.close();
}

Drive drive_at(int k) {
  Drive d;
  d.step.frame = k;
  d.step.stamp = time_from_seconds(1000 + 0.08 * k);
  d.step.world_from_ego = Pose3::from_planar({0.8 * k, 0, 0.002 * k});
  d.truth.frame = k;
  d.truth.stamp = d.step.stamp;
  d.truth.coordinate_frame = "ego";
  for (int id = 1; id <= 2; ++id) {
    const Box2 ego_box{
        {14.0 * id + 3 * std::sin(0.03 * k), 3.5 - 3.5 * id + 0.2 * std::cos(0.1 * k)},
        0.05 * std::sin(0.05 * k),
        4.4,
        1.8};
    add_box_points(d, ego_box);
    TruthObject object;
    object.id = id;
    object.object_class = ObjectClass::kVehicle;
    object.position_m = ego_box.centre_m;
    object.heading_rad = ego_box.heading_rad;
    object.length_m = ego_box.length_m;
    object.width_m = ego_box.width_m;
    d.truth.objects.push_back(object);
    const Pose2 world = d.step.world_from_ego.planar();
    Track t;
    t.id = id;
    t.object_class = ObjectClass::kVehicle;
    const bool missed = id == 2 && k % 50 >= 30 && k % 50 < 38;
    t.status = k < 4    ? TrackStatus::kTentative
               : missed ? TrackStatus::kCoasting
                        : TrackStatus::kConfirmed;
    t.box = ego_box;
    t.box.centre_m = world * (ego_box.centre_m + Eigen::Vector2d(0.1 * std::sin(k), 0.1));
    t.box.heading_rad += world.heading_rad;
    t.state.mean << t.box.centre_m.x(), 10, t.box.centre_m.y(), 0.5;
    t.state.covariance = Eigen::Vector4d(0.09, 0.2, 0.02, 0.2).asDiagonal();
    if (!missed) {
      Detection seen;
      seen.box = ego_box;
      seen.box.centre_m = world * (ego_box.centre_m + Eigen::Vector2d(0.2 * std::cos(2 * k), 0));
      t.detection = static_cast<int>(d.step.detections.size());
      d.step.detections.push_back(seen);
    }
    d.step.tracks.push_back(t);
  }
  for (int i = 0; i < 60; ++i) d.flat.points.push_back({static_cast<float>(i), 7.5F});
  return d;
}

TrackReport driven(int frames, TrackReportOptions options = {}) {
  TrackReport report(options);
  for (int k = 0; k < frames; ++k) {
    const Drive d = drive_at(k);
    report.add(d.truth);
    report.add(d.step, d.scan, &d.flat, &d.clusters);
  }
  return report;
}

TrackReportHeader header() {
  TrackReportHeader h;
  h.input = "drive.mcap";
  h.configuration = "preset vehicle-pag, digest 1a2b3c4d";
  h.summary = {{"scan to tracks, median", "84 us"}, {"99th percentile", "130 us"}};
  h.metrics = {{"MOTA", "0.95"}, {"position RMSE", "0.14 m"}};
  h.diagnostics = {{"ego pose extrapolated", "3"}};
  return h;
}

TEST(TrackReport, NeedsNothingFromOutside) {
  const std::string page = driven(60).html(header());
  for (const auto* outside :
       {"http://", "https://", "src=", "@import", "url(", "fetch(", "<link"}) {
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  }
  if (const char* path = std::getenv("SCANFUSE_REPORT_OUT"))
    std::ofstream(path) << driven(180).html(header());
}

TEST(TrackReport, EscapesNamesThatCouldEndTheScript) {
  TrackReportHeader evil = header();
  evil.input = "</script><script>alert(1)</script>&\"'";
  evil.diagnostics = {{"</script>", "<img onerror=x>"}};
  const std::string page = driven(3).html(evil);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_NE(page.find("&lt;/script&gt;"), std::string::npos);
}

TEST(TrackReport, EmbedsAllFramesAsJson) {
  const auto json = nlohmann::json::parse(track_report_data(driven(20)));
  ASSERT_EQ(json["frames"].size(), 20U);
  EXPECT_EQ(json["frames"][5]["k"].size(), 2U);
  EXPECT_EQ(json["frames"][5]["g"].size(), 2U);
  EXPECT_NEAR(json["frames"][5]["t"].get<double>(), 0.4, 1e-9);
}

TEST(TrackReport, TellsTheSensorAndWhichEndsAreHidden) {
  Drive d = drive_at(10);
  d.step.ego_from_sensor.translation_m.x() = 2;
  d.step.detections[0].left_end_occluded = true;
  d.step.detections[1].right_end_occluded = true;
  TrackReport report;
  report.add(d.step, d.scan, &d.flat, &d.clusters);
  const auto frame = nlohmann::json::parse(track_report_data(report))["frames"][0];
  EXPECT_EQ(frame["k"][0][15], 1);
  EXPECT_EQ(frame["k"][1][15], 2);
  EXPECT_NEAR(frame["s"][0].get<double>() - frame["e"][0].get<double>(), 2, 0.02);
}

TEST(TrackReport, ShowsTablesAndChartsAgainstTruthEscaped) {
  TrackReportHeader with = header();
  with.tables = {{"Each <class>", {"class", "recall"}, {{"vehicle", "0.98"}}, "note & more"}};
  with.charts = {
      {"vehicle: against range", "range [m]", "share", {{"recall", {{5, 1}, {15, 0.9}}}}}};
  const std::string page = driven(3).html(with);
  EXPECT_NE(page.find("Each &lt;class&gt;"), std::string::npos);
  EXPECT_NE(page.find("<td>0.98</td>"), std::string::npos);
  EXPECT_NE(page.find("note &amp; more"), std::string::npos);
  EXPECT_NE(page.find("vehicle: against range"), std::string::npos);
}

TEST(TrackReport, HasAColourForEveryClassOfRoadUser) {
  const std::string page = driven(3).html(header());
  for (const auto* name : {"vehicle", "pedestrian", "cyclist", "other"}) {
    const std::string variable = std::string("--") + name + ": #";
    EXPECT_NE(page.find(variable), std::string::npos) << name;
    EXPECT_NE(page.find("var(--" + std::string(name) + ")"), std::string::npos) << name;
  }
}

TEST(TrackReport, StaysWithinItsSizeAndSaysSo) {
  TrackReportOptions options;
  options.max_bytes = 40'000;
  const auto report = driven(500, options);
  EXPECT_LE(track_report_data(report).size(), 60'000U);
  EXPECT_EQ(report.frames_seen(), 500);
  EXPECT_EQ(report.lives().at(1).frames, 500);
  EXPECT_NE(report.html(header()).find("one frame in"), std::string::npos);
  for (std::size_t i = 0; i < report.frames().size(); ++i) {
    EXPECT_EQ(report.frames()[i].frame, static_cast<std::int64_t>(i) * report.frame_stride());
  }
}

TEST(TrackReport, LeavesMissedFramesOutOfTheDifference) {
  const auto report = driven(100);
  const TrackLife& life = report.lives().at(2);
  EXPECT_EQ(life.frames, 100);
  EXPECT_EQ(life.measured, 84);
  EXPECT_NEAR(std::sqrt(life.square_difference_m2[0] / 84.0), 0.1, 1e-9);  // lateral offset
}

TEST(TrackReport, StandsNothingAndNotANumber) {
  EXPECT_NE(TrackReport().html({}).find("No track was confirmed"), std::string::npos);
  TrackReport report;
  StepResult step;
  Track bad;
  bad.status = TrackStatus::kConfirmed;
  bad.box.centre_m = {NAN, INFINITY};
  step.tracks = {bad};
  Scan scan;
  scan.returns.push_back({NAN, 1e30F, 0});
  report.add(step, scan);
  EXPECT_TRUE(nlohmann::json::accept(track_report_data(report)));
  EXPECT_EQ(report.html({}).find("nan"), std::string::npos);
}

TEST(LineChart, BreaksTheLineWhereAPointIsMissing) {
  const Chart chart{"t", "x", "y", {{"a", {{0, 0}, {1, 1}, {2, NAN}, {3, 1}, {4, 0}}}}};
  const std::string svg = line_chart(chart);
  const auto path = svg.substr(svg.find("stroke-width=\"1.6\"") - 200, 200);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
}

TEST(LineChart, SaysWhenThereIsNoDataAndEscapesTexts) {
  const std::string svg = line_chart({"<b>", "", "", {}});
  EXPECT_NE(svg.find("no data"), std::string::npos);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
}

TEST(LineChart, StandsConstantAndExtremeValues) {
  for (const double v : {0.0, 5.0, 1e-300, 1e300}) {
    const std::string svg = line_chart({"t", "x", "y", {{"a", {{0, v}, {0, v}}}}});
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
  }
}

}  // namespace
}  // namespace scanfuse::report
