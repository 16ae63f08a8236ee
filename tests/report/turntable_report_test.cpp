#include "scanfuse/report/turntable_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scanfuse::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Two positions, the second left out.
TurntableReport small_report() {
  TurntableReport report;
  report.title = "session <b>";
  report.method = "joint";
  report.features.boards = {BoardSpec{14, 20, 0.02}, BoardSpec{14, 20, 0.02}};
  report.features.camera = {.width_px = 1624, .height_px = 1234};
  report.rig.axis_direction = {0, -1, 0};
  report.rig.camera_from_lidar.translation_m = {0.3, 0, 0.6};
  report.rig.last_turntable_rad = 0.375;
  report.camera_from_board[0].translation_m = {0, -0.2, 1.4};
  report.camera_from_board[1].translation_m = {0, 0.1, 1.4};
  report.features.positions.resize(2);
  report.positions.resize(2);
  report.positions[0].name = "position 0";
  report.positions[0].used = true;
  report.positions[0].stripe_px = {0.11, 0.13};
  report.positions[0].lidar_m = {0.001, 0.0012};
  report.positions[1].name = "position 1";
  report.positions[1].turntable_rad = 0.375;
  report.positions[1].reason = "no stripe on board 1 & none on 2";
  report.rms = {0.07, 0.12, 1.1};
  report.table1 = {{{0.53, 1.2}, {0.2, 0.4}, {0.6, 1.3}}};
  report.chi2_per_dof = 1.01;
  report.warnings = {"turn further than 12 degrees"};
  report.point_sigma = [](double turned, double range) { return 1e-4 * (1 + turned + range); };
  return report;
}

TEST(TurntablePage, TellsFiguresReasonsAndWarnings) {
  const auto page = turntable_page(small_report());
  EXPECT_THAT(page, HasSubstr("turn further than 12 degrees"));
  EXPECT_THAT(page, HasSubstr("no stripe on board 1 &amp; none on 2"));
  EXPECT_THAT(page, HasSubstr("1.12"));  // the paper's Table 1
  EXPECT_THAT(page, HasSubstr("0.53"));
}

TEST(TurntablePage, IsOneFileAndTakesNamesForText) {
  const auto page = turntable_page(small_report());
  EXPECT_THAT(page, HasSubstr("session &lt;b&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("session <b>")));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
  EXPECT_THAT(page, Not(HasSubstr("nan")));
}

TEST(TurntablePage, EmptyReportIsAPageToo) {
  const auto page = turntable_page({});
  EXPECT_THAT(page, HasSubstr("</html>"));
}

TEST(TurntablePage, SameReportSameBytes) {
  EXPECT_EQ(turntable_page(small_report()), turntable_page(small_report()));
}

}  // namespace
}  // namespace scanfuse::report
