#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <shared_mutex>
#include <string>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/io/spool.hpp"
#include "scanfuse/pipeline/scan_feed.hpp"

namespace scanfuse::serve {

/// A sensor as the viewer lists it.
struct SensorSeen {
  std::string name;
  Pose3 ego_from_sensor;  ///< at its first scan
};

/// Every scan so far, on disk, numbered from 0 in the order in which they came; and the truth. One
/// thread adds, any thread reads.
class ScanLog {
 public:
  explicit ScanLog(io::Spool& spool) : spool_(&spool) {}

  /// Its number.
  [[nodiscard]] Result<std::uint32_t> add(const pipeline::PosedScan& posed);
  void add(TruthFrame truth);

  [[nodiscard]] Result<pipeline::PosedScan> get(std::uint32_t frame) const;
  [[nodiscard]] std::uint32_t size() const;
  /// Seconds since the first scan, of frames [from, to).
  [[nodiscard]] std::vector<double> times_s(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] Time stamp(std::uint32_t frame) const;
  [[nodiscard]] std::int64_t number(std::uint32_t frame) const;  ///< as the recording counts
  /// The truth of a frame in the world frame: that nearest in time, within half the gap between
  /// scans.
  [[nodiscard]] std::vector<TruthObject> truth_at(std::uint32_t frame) const;
  [[nodiscard]] std::vector<TruthFrame> truth() const;
  [[nodiscard]] bool has_truth() const;
  [[nodiscard]] std::vector<SensorSeen> sensors() const;
  [[nodiscard]] std::uint32_t sensor_of(std::uint32_t frame) const;
  /// A point near the data: the ego at the first scan.
  [[nodiscard]] Eigen::Vector3d origin_m() const;

 private:
  struct Entry {
    Time stamp;
    std::int64_t number = 0;
    std::uint32_t sensor = 0;
    Pose2 world_from_ego;
    io::Spool::Place place;
  };
  [[nodiscard]] const TruthFrame* truth_near(const Entry& entry, Duration reach) const;
  std::uint32_t number_of_sensor(const pipeline::PosedScan& posed);

  io::Spool* spool_;
  mutable std::shared_mutex guard_;
  std::vector<Entry> entries_;
  std::map<Time, TruthFrame> truth_;
  std::vector<SensorSeen> sensors_;
  Eigen::Vector3d origin_m_ = Eigen::Vector3d::Zero();
};

/// A scan with its poses as bytes, and back; for the spool of one process only.
[[nodiscard]] std::string pack(const pipeline::PosedScan& posed);
[[nodiscard]] Result<pipeline::PosedScan> unpack_scan(std::string_view bytes);

}  // namespace scanfuse::serve
