#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "evaluate/sample.hpp"
#include "scanfuse/evaluate/evaluate.hpp"

namespace scanfuse::evaluate {
namespace {

constexpr double kAgreement = 1e-6;
constexpr int kOracleFrames = 60;  // the means of the reference run over these, empty ones too

struct OracleRow {
  std::int64_t frame = 0;
  std::int64_t id = 0;
  double x_m = 0;
  double y_m = 0;
};

std::vector<OracleRow> oracle_rows(const std::string& path) {
  std::ifstream file(path);
  std::string line, cell;
  std::getline(file, line);
  std::vector<OracleRow> rows;
  while (std::getline(file, line)) {
    std::stringstream cells(line);
    std::vector<std::string> row;
    while (std::getline(cells, cell, ',')) row.push_back(cell);
    rows.push_back({std::stoll(row[0]), std::stoll(row[2]), std::stod(row[4]), std::stod(row[5])});
  }
  return rows;
}

class MetricsOracle : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    const std::string folder =
        std::string(SCANFUSE_SHARED_DATA) + "/metrics_oracle/case" + std::to_string(GetParam());
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data: skipped";
    std::ifstream(folder + "/expected.json") >> expected_;
    std::vector<StepResult> steps;
    std::vector<TruthFrame> truth;
    for (int k = 0; k < kOracleFrames; ++k) {
      steps.push_back(sample::step(k, {}));
      truth.push_back(sample::truth(k, {}));
    }
    for (const auto& row : oracle_rows(folder + "/tracks.csv")) {
      steps[row.frame].tracks.push_back(sample::track(row.id, row.x_m, row.y_m));
    }
    for (const auto& row : oracle_rows(folder + "/truth.csv")) {
      truth[row.frame].objects.push_back(sample::object(row.id, row.x_m, row.y_m));
    }
    found_ = evaluate(steps, truth);
  }
  [[nodiscard]] double expected(const char* group, const char* key) const {
    return expected_[group][key].get<double>();
  }

  nlohmann::json expected_;
  Evaluation found_;
};

TEST_P(MetricsOracle, ClearAgrees) {
  const auto& m = found_.clear;
  EXPECT_NEAR(*m.mota, expected("clear", "MOTA"), kAgreement);
  EXPECT_NEAR(1 - *m.motp_m / 2, expected("clear", "MOTP"), kAgreement);
  EXPECT_EQ(m.true_positives, expected("clear", "CLR_TP"));
  EXPECT_EQ(m.false_positives, expected("clear", "CLR_FP"));
  EXPECT_EQ(m.false_negatives, expected("clear", "CLR_FN"));
  EXPECT_EQ(m.identity_switches, expected("clear", "IDSW"));
  EXPECT_EQ(m.fragmentations, expected("clear", "Frag"));
  EXPECT_EQ(m.mostly_tracked, expected("clear", "MT"));
  EXPECT_EQ(m.partly_tracked, expected("clear", "PT"));
  EXPECT_EQ(m.mostly_lost, expected("clear", "ML"));
}

TEST_P(MetricsOracle, IdentityAgrees) {
  EXPECT_NEAR(*found_.identity.idf1, expected("identity", "IDF1"), kAgreement);
  EXPECT_NEAR(*found_.identity.idp, expected("identity", "IDP"), kAgreement);
  EXPECT_NEAR(*found_.identity.idr, expected("identity", "IDR"), kAgreement);
  EXPECT_EQ(found_.identity.true_positives, expected("identity", "IDTP"));
}

TEST_P(MetricsOracle, HotaAgrees) {
  EXPECT_NEAR(*found_.hota.hota, expected("hota", "HOTA"), kAgreement);
  EXPECT_NEAR(*found_.hota.det_a, expected("hota", "DetA"), kAgreement);
  EXPECT_NEAR(*found_.hota.ass_a, expected("hota", "AssA"), kAgreement);
  EXPECT_NEAR(*found_.hota.loc_a, expected("hota", "LocA"), kAgreement);
  for (std::size_t a = 0; a < found_.hota.by_alpha.size(); ++a) {
    EXPECT_NEAR(found_.hota.by_alpha[a].hota, expected_["hota"]["HOTA_by_alpha"][a].get<double>(),
                kAgreement);
  }
}

TEST_P(MetricsOracle, GospaAndOspaAgree) {
  EXPECT_NEAR(*found_.sets.gospa_m, expected("gospa_mean", "gospa"), kAgreement);
  EXPECT_NEAR(*found_.sets.localisation, expected("gospa_mean", "loc"), kAgreement);
  EXPECT_NEAR(*found_.sets.missed, expected("gospa_mean", "missed"), kAgreement);
  EXPECT_NEAR(*found_.sets.false_tracks, expected("gospa_mean", "false"), kAgreement);
  EXPECT_NEAR(*found_.sets.ospa_m, expected_["ospa_mean"].get<double>(), kAgreement);
}

INSTANTIATE_TEST_SUITE_P(Cases, MetricsOracle, testing::Range(0, 8));

}  // namespace
}  // namespace scanfuse::evaluate
