#pragma once

#include <map>
#include <string>
#include <vector>

#include "scanfuse/associate/packing_posterior.hpp"
#include "scanfuse/report/passive_report.hpp"
#include "scanfuse/triangulate/associate_scan.hpp"

namespace scanfuse::app {

/// Where targets really were, by the number of the scan.
using PassiveTruth = std::map<std::int64_t, std::vector<Eigen::Vector3d>>;

/// Collects what `scanfuse associate --report` shows: a row a scan, and a few scans in full.
class AssociationReport {
 public:
  /// `scans`: how many will come.
  AssociationReport(const PassiveScene& scene, const triangulate::AssociationOptions& options,
                    PassiveTruth truth, std::size_t scans, int threads);

  /// `ranking` null: none was asked for.
  void add(const BearingScan& scan, const triangulate::ScanAssociation& found, double seconds,
           const associate::PackingRanking* ranking);
  [[nodiscard]] std::string page(const std::string& bearings) const;

 private:
  const PassiveScene& scene_;
  triangulate::AssociationOptions options_;
  PassiveTruth truth_;
  std::size_t stride_;  ///< between scans that are shown in full
  int threads_;
  std::size_t count_ = 0;
  report::ReportTable scans_;
  std::vector<report::PassiveSection> sections_;
};

/// The sensor's name and the measurement's number of each bearing: "a:3 b:7".
[[nodiscard]] std::string bearing_names(const BearingScan& scan, const PassiveScene& scene,
                                        std::span<const std::int32_t> bearings);

}  // namespace scanfuse::app
