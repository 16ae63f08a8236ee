#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <shared_mutex>
#include <string>
#include <utility>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/io/spool.hpp"
#include "scanfuse/serve/messages.hpp"
#include "scanfuse/serve/scan_log.hpp"

namespace scanfuse::serve {

/// What one configuration made of the scans from frame `first` on: ready for sending, on disk. In
/// memory stay a few numbers a frame, the events, and when each track lived. One thread adds, any
/// thread reads.
class Run {
 public:
  Run(RunName name, const ScanLog& log, io::Spool& spool, std::uint32_t first)
      : name_(name), log_(&log), spool_(&spool), first_(first) {}

  /// The results of the next frame.
  [[nodiscard]] Result<void> add(const ShownFrame& shown);

  [[nodiscard]] std::uint32_t first() const { return first_; }
  /// One past the last frame.
  [[nodiscard]] std::uint32_t end() const;
  /// As the viewer takes it, with truth; an error for a frame that is not here (yet).
  [[nodiscard]] Result<std::string> message(std::uint32_t frame) const;
  [[nodiscard]] Result<StepResult> step(std::uint32_t frame) const;
  [[nodiscard]] std::vector<Event> events(std::uint32_t from) const;
  [[nodiscard]] std::uint32_t event_count() const;
  /// From its birth to its end; of a track that lived longer than `kLongestHistory` frames, every
  /// second one, or fourth, ...
  [[nodiscard]] Result<std::vector<HistorySample>> history(std::int64_t track) const;
  /// First and last frame of a track.
  [[nodiscard]] std::optional<std::pair<std::uint32_t, std::uint32_t>> life(
      std::int64_t track) const;
  [[nodiscard]] std::uint32_t confirmed_count() const;

  static constexpr std::uint32_t kLongestHistory = 4000;

 private:
  struct Places {
    io::Spool::Place shown;
    io::Spool::Place step;
  };
  struct Life {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    TrackStatus status = TrackStatus::kTentative;
    bool confirmed = false;
  };
  void note(std::uint32_t frame, EventKind kind, std::int64_t track);
  void follow(std::uint32_t frame, const std::vector<Track>& tracks);
  /// Of the frame before: its truth may come after its scan.
  void find_switches(const std::vector<TruthObject>& truth);

  RunName name_;
  const ScanLog* log_;
  io::Spool* spool_;
  std::uint32_t first_;
  mutable std::shared_mutex guard_;
  std::vector<Places> places_;
  std::vector<Event> events_;
  std::map<std::int64_t, Life> lives_;
  std::set<std::int64_t> alive_;
  std::map<std::int64_t, std::int64_t>
      followed_by_;                 ///< truth object -> the track that had it last
  std::vector<Track> last_tracks_;  ///< of the newest frame
  std::uint32_t confirmed_ = 0;
};

}  // namespace scanfuse::serve
