#pragma once

#include <map>
#include <string>
#include <vector>

#include "scanfuse/report/passive_tracks.hpp"
#include "scanfuse/triangulate/passive_tracker.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::app {

/// Collects what `scanfuse track --sensors --report` shows: every scan, or one of a few hundred
/// spread evenly, and a row a track.
class PassiveTrackReport {
 public:
  /// `scans`: how many will come.
  PassiveTrackReport(const PassiveScene& scene, std::size_t scans);

  void add(const BearingScan& scan, const triangulate::PassiveStep& step);
  /// Where targets really were, by the number of the scan.
  void show(std::span<const TruthFrame> truth);
  [[nodiscard]] std::string page(const std::string& title,
                                 const std::vector<report::ReportTable>& tables) const;

 private:
  /// A track's row.
  struct Life {
    std::int64_t first_scan = 0, last_scan = 0;
    double first_s = 0, last_s = 0;
    std::int64_t scans_seen = 0, bearings = 0;
    double sigma_m = 0;  ///< of the position, all axes, at the end
    bool confirmed = false;
  };
  void follow(const BearingScan& scan, const triangulate::PassiveStep& step, double time_s);
  [[nodiscard]] report::ReportTable lives() const;

  const PassiveScene& scene_;
  std::size_t stride_;
  std::size_t count_ = 0;
  std::optional<Time> first_;
  std::vector<report::PointTrackFrame> frames_;
  std::map<std::int64_t, Life> lives_;
  report::Series confirmed_, tentative_, bearings_, clutter_;
};

}  // namespace scanfuse::app
