#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/serve/requests.hpp"
#include "scanfuse/serve/shown_frame.hpp"

/// What the server sends in binary; docs/viewer-protocol.md gives the layout byte by byte. All
/// positions are given against the scene's origin (a point of the world frame near the data), so
/// that 4-byte numbers are exact to a fraction of a millimetre.
namespace scanfuse::serve {

enum class MessageKind : std::uint32_t {
  kFrame = 1,
  kIndex = 2,
  kEvents = 3,
  kHistory = 4,
  kTrails = 5
};

/// The frame without its truth, which may be known later only. Coordinates are rounded to 1/1024 m,
/// which packs well.
[[nodiscard]] std::string frame_message(const ShownFrame& shown, RunName run, std::uint32_t frame,
                                        double time_s, const Eigen::Vector3d& origin_m);

/// Appends the truth to a message of `frame_message`.
void append_truth(std::string& message, std::span<const TruthObject> truth,
                  const Eigen::Vector3d& origin_m);

/// Stamps of frames, seconds since the start.
[[nodiscard]] std::string index_message(RunName run, std::uint32_t from,
                                        std::span<const double> times_s);

enum class EventKind : std::uint32_t { kBirth = 0, kCoast = 1, kLoss = 2, kSwitch = 3 };

/// Something that happened to a track: it was confirmed, lost sight of its object, was given up, or
/// follows an object that another track followed before (by the truth).
struct Event {
  std::uint32_t frame = 0;
  EventKind kind = EventKind::kBirth;
  std::int64_t track = 0;
};
[[nodiscard]] std::string events_message(RunName run, std::uint32_t from,
                                         std::span<const Event> events);

/// One track at one frame.
struct HistorySample {
  std::uint32_t frame = 0;
  double time_s = 0;
  Track track;
};
[[nodiscard]] std::string history_message(RunName run, std::int64_t track,
                                          std::span<const HistorySample> samples,
                                          const Eigen::Vector3d& origin_m);

/// Where the tracks of one frame were, confirmed or not.
struct TrailStep {
  std::uint32_t frame = 0;
  std::vector<Track> tracks;
};
[[nodiscard]] std::string trails_message(RunName run, std::span<const TrailStep> steps,
                                         const Eigen::Vector3d& origin_m);

}  // namespace scanfuse::serve
