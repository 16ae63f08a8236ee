#include "scanfuse/serve/run.hpp"

#include <algorithm>
#include <mutex>

#include "scanfuse/io/mcap/result_messages.hpp"

namespace scanfuse::serve {
namespace {

/// A track this near to an object follows it.
constexpr double kFollowsM = 2;

}  // namespace

void Run::note(std::uint32_t frame, EventKind kind, std::int64_t track) {
  events_.push_back({frame, kind, track});
}

void Run::follow(std::uint32_t frame, const std::vector<Track>& tracks) {
  std::set<std::int64_t> now;
  for (const Track& track : tracks) {
    now.insert(track.id);
    Life& life = lives_.try_emplace(track.id, Life{frame, frame}).first->second;
    life.last = frame;
    const bool is_confirmed = track.status != TrackStatus::kTentative;
    if (is_confirmed && !life.confirmed) {
      life.confirmed = true;
      ++confirmed_;
      note(frame, EventKind::kBirth, track.id);
    }
    if (track.status == TrackStatus::kCoasting && life.status == TrackStatus::kConfirmed) {
      note(frame, EventKind::kCoast, track.id);
    }
    life.status = track.status;
  }
  for (const auto id : alive_) {
    if (now.contains(id)) continue;
    if (lives_[id].confirmed) note(frame, EventKind::kLoss, id);
  }
  alive_ = std::move(now);
}

void Run::find_switches(const std::vector<TruthObject>& truth) {
  const auto frame = static_cast<std::uint32_t>(first_ + places_.size() - 1);
  for (const auto& object : truth) {
    const Track* nearest = nullptr;
    double best = kFollowsM;
    for (const Track& track : last_tracks_) {
      const double distance = (track.box.centre_m - object.position_m).norm();
      if (track.status == TrackStatus::kTentative || !(distance < best)) continue;
      best = distance;
      nearest = &track;
    }
    if (nearest == nullptr) continue;
    const auto [last, is_new] = followed_by_.try_emplace(object.id, nearest->id);
    if (!is_new && last->second != nearest->id) note(frame, EventKind::kSwitch, nearest->id);
    last->second = nearest->id;
  }
}

Result<void> Run::add(const ShownFrame& shown) {
  const std::uint32_t frame = end();
  const auto times = log_->times_s(frame, frame + 1);
  const double time_s = times.empty() ? 0 : times.front();
  auto packed = spool_->put(frame_message(shown, name_, frame, time_s, log_->origin_m()));
  if (!packed) return tl::unexpected(packed.error());
  auto step = spool_->put(io::mcap::tracks_json(shown.step));
  if (!step) return tl::unexpected(step.error());
  const auto truth = frame > first_ ? log_->truth_at(frame - 1) : std::vector<TruthObject>{};
  const std::unique_lock lock(guard_);
  if (!places_.empty()) find_switches(truth);
  places_.push_back({*packed, *step});
  follow(frame, shown.step.tracks);
  last_tracks_ = shown.step.tracks;
  return {};
}

std::uint32_t Run::end() const {
  const std::shared_lock lock(guard_);
  return first_ + static_cast<std::uint32_t>(places_.size());
}

Result<std::string> Run::message(std::uint32_t frame) const {
  Places places;
  {
    const std::shared_lock lock(guard_);
    if (frame < first_ || frame - first_ >= places_.size()) {
      return fail(Error::Code::kNotFound, "no frame {}", frame);
    }
    places = places_[frame - first_];
  }
  auto bytes = spool_->get(places.shown);
  if (bytes) append_truth(*bytes, log_->truth_at(frame), log_->origin_m());
  return bytes;
}

Result<StepResult> Run::step(std::uint32_t frame) const {
  Places places;
  {
    const std::shared_lock lock(guard_);
    if (frame < first_ || frame - first_ >= places_.size()) {
      return fail(Error::Code::kNotFound, "no frame {}", frame);
    }
    places = places_[frame - first_];
  }
  const auto bytes = spool_->get(places.step);
  if (!bytes) return tl::unexpected(bytes.error());
  return io::mcap::tracks_from_json(std::as_bytes(std::span(*bytes)));
}

std::vector<Event> Run::events(std::uint32_t from) const {
  const std::shared_lock lock(guard_);
  if (from >= events_.size()) return {};
  return {events_.begin() + from, events_.end()};
}

std::uint32_t Run::event_count() const {
  const std::shared_lock lock(guard_);
  return static_cast<std::uint32_t>(events_.size());
}

std::uint32_t Run::confirmed_count() const {
  const std::shared_lock lock(guard_);
  return confirmed_;
}

std::optional<std::pair<std::uint32_t, std::uint32_t>> Run::life(std::int64_t track) const {
  const std::shared_lock lock(guard_);
  const auto found = lives_.find(track);
  if (found == lives_.end()) return std::nullopt;
  return std::pair{found->second.first, found->second.last};
}

Result<std::vector<HistorySample>> Run::history(std::int64_t track) const {
  const auto lived = life(track);
  if (!lived) return fail(Error::Code::kNotFound, "no track {}", track);
  std::uint32_t stride = 1;
  while ((lived->second - lived->first) / stride >= kLongestHistory) stride *= 2;
  std::vector<HistorySample> samples;
  for (std::uint64_t frame = lived->first; frame <= lived->second; frame += stride) {
    const auto at = static_cast<std::uint32_t>(frame);
    auto step_here = step(at);
    if (!step_here) return tl::unexpected(step_here.error());
    const auto found = std::ranges::find(step_here->tracks, track, &Track::id);
    if (found == step_here->tracks.end()) continue;
    const auto times = log_->times_s(at, at + 1);
    samples.push_back({at, times.empty() ? 0 : times.front(), std::move(*found)});
  }
  return samples;
}

}  // namespace scanfuse::serve
