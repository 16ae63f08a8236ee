#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scanfuse/io/recording.hpp"
#include "scanfuse/pipeline/frame_tree.hpp"
#include "scanfuse/pipeline/frozen_poses.hpp"
#include "scanfuse/pipeline/pose_buffer.hpp"
#include "scanfuse/pipeline/scan_ego.hpp"

namespace scanfuse::pipeline {

struct FeedOptions {
  std::string ego_topic;        ///< Odometry, PoseStamped, PoseWithCovarianceStamped; empty: found
  std::optional<Pose3> mount;   ///< ego_from_sensor; empty: from tf, else the identity
  std::vector<PoseSample> ego;  ///< from a file beside the recording; wins over topics and tf
  bool may_move = true;         ///< look for the ego's motion in the scans where nothing tells it
};

/// A scan with everything known about where it was taken.
struct PosedScan {
  Scan scan;
  Pose3 world_from_ego;
  Pose3 ego_from_sensor;
  PoseBuffer::Twist twist;  ///< of the ego at the scan's stamp
  std::string world_frame;  ///< what the recording calls the frames ("odom", "base_link"); where
  std::string ego_frame;    ///< nothing is known of the ego's motion, both are the ego's
  bool mount_is_known = true;
  bool ego_from_scans = false;  ///< nobody tells where the ego is: found by matching scans
};

/// Turns a recording's events into scans with poses, in order of their header stamps as far as they
/// come so. A scan waits until the ego motion around its stamp has been read; memory stays bounded.
///
/// The ego pose is taken, in this order, from: the file given, the topic given, tf (odom or map to
/// base_link), the recording's only or best named Odometry topic, else, where the scene says that
/// the sensor moves, from the scans themselves (`ScanEgo`), as while it is frozen; else the
/// identity.
class ScanFeed {
 public:
  ScanFeed(std::unique_ptr<io::RecordingReader> reader, FeedOptions options);

  /// The next scan; nothing at the end.
  [[nodiscard]] Result<std::optional<PosedScan>> next();
  /// Truth that came along since the last call.
  [[nodiscard]] std::vector<TruthFrame> take_truth();
  [[nodiscard]] const io::RecordingInfo& info() const { return reader_->info(); }
  /// Of the reader and of this feed.
  [[nodiscard]] Diagnostics diagnostics() const;

 private:
  struct Waiting {
    Scan scan;
    Time log_time;
  };
  struct Frames {
    std::string world;  ///< empty: no moving ancestor is known
    std::string ego;
  };
  Result<bool> read_one();
  void take(io::Event event);
  /// One sensor cannot take two scans at one instant: no time would pass between them, and tracks
  /// would neither move nor end.
  bool is_repeat(const Scan& scan);
  void take_pose(const std::string& topic, const PoseSample& sample);
  [[nodiscard]] bool is_ready(const Waiting& waiting) const;
  [[nodiscard]] bool uses_tf() const;
  [[nodiscard]] Frames frames_of(const std::string& sensor_frame) const;
  [[nodiscard]] PosedScan pose(Scan scan);
  void place(PosedScan& posed);
  /// False when tf knows the mounting only, not where the ego is.
  bool place_by_tf(PosedScan& posed);
  void name_frames(PosedScan& posed) const;
  void place_by_scans(PosedScan& posed);
  bool place_while_frozen(PosedScan& posed);
  void choose_ego_topic();

  std::unique_ptr<io::RecordingReader> reader_;
  FeedOptions options_;
  Diagnostics diagnostics_;
  FrameTree tree_;
  PoseBuffer ego_;
  FrozenPoses frozen_{Duration{0}, 3};
  ScanEgo scan_ego_;
  std::string ego_topic_;
  Frames ego_names_;  ///< as the ego topic has them
  bool recording_has_tf_ = false;
  std::deque<Waiting> waiting_;
  std::vector<TruthFrame> truth_;
  std::map<std::string, Time> last_stamp_;
  std::map<std::string, std::optional<Time>> last_read_;
  Time newest_log_;
  bool at_end_ = false;
};

}  // namespace scanfuse::pipeline
