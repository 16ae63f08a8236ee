#include "scanfuse/serve/scan_log.hpp"

#include <cstring>
#include <mutex>
#include <utility>

#include "scanfuse/serve/wire.hpp"

namespace scanfuse::serve {
namespace {

static_assert(std::is_trivially_copyable_v<Return>);

void put_text(WireWriter& out, const std::string& text) {
  out.u32(text.size());
  for (const char c : text) out.put(c);
}

std::string get_text(WireReader& in) { return std::string(in.take(in.get<std::uint32_t>())); }

void put_pose(WireWriter& out, const Pose3& pose) {
  for (const double value : pose.rotation.coeffs()) out.put(value);
  for (const double value : pose.translation_m) out.put(value);
}

Pose3 get_pose(WireReader& in) {
  Pose3 pose;
  for (double& value : pose.rotation.coeffs()) value = in.get<double>();
  for (double& value : pose.translation_m) value = in.get<double>();
  return pose;
}

void put_beams(WireWriter& out, const std::optional<BeamPattern>& beams) {
  const BeamPattern b = beams.value_or(BeamPattern{});
  out.u32(beams ? 1 : 0).put(b.first_azimuth_rad).put(b.step_rad).put(b.columns).put(b.layers);
  out.put(b.min_range_m).put(b.max_range_m);
}

std::optional<BeamPattern> get_beams(WireReader& in) {
  const bool present = in.get<std::uint32_t>() == 1;
  BeamPattern b;
  b.first_azimuth_rad = in.get<double>();
  b.step_rad = in.get<double>();
  b.columns = in.get<int>();
  b.layers = in.get<int>();
  b.min_range_m = in.get<double>();
  b.max_range_m = in.get<double>();
  return present ? std::optional(b) : std::nullopt;
}

bool is_finite(const Pose3& pose) {
  return pose.translation_m.norm() < 1e7 && pose.rotation.coeffs().allFinite();
}

TruthObject moved(const TruthObject& object, const Pose2& world_from_ego) {
  TruthObject out = object;
  out.position_m = world_from_ego * object.position_m;
  if (out.heading_rad) out.heading_rad = wrap_pi(*out.heading_rad + world_from_ego.heading_rad);
  return out;
}

}  // namespace

std::string pack(const pipeline::PosedScan& posed) {
  const Scan& scan = posed.scan;
  WireWriter out(512 + sizeof(Return) * scan.returns.size());
  out.put(to_nanos(scan.stamp)).put(scan.frame);
  put_text(out, scan.sensor);
  put_text(out, scan.frame_id);
  put_beams(out, scan.beams);
  put_pose(out, posed.world_from_ego);
  put_pose(out, posed.ego_from_sensor);
  out.put(posed.twist.speed_m_per_s).put(posed.twist.lateral_m_per_s);
  out.put(posed.twist.yaw_rate_rad_per_s);
  out.put<std::uint8_t>(posed.mount_is_known ? 1 : 0);
  out.u32(scan.returns.size());
  std::string bytes = out.take();
  const std::size_t head = bytes.size();
  bytes.resize(head + sizeof(Return) * scan.returns.size());
  if (!scan.returns.empty()) {
    std::memcpy(bytes.data() + head, scan.returns.data(), bytes.size() - head);
  }
  return bytes;
}

Result<pipeline::PosedScan> unpack_scan(std::string_view bytes) {
  WireReader in(bytes);
  pipeline::PosedScan posed;
  Scan& scan = posed.scan;
  scan.stamp = time_from_nanos(in.get<std::int64_t>());
  scan.frame = in.get<std::int64_t>();
  scan.sensor = get_text(in);
  scan.frame_id = get_text(in);
  scan.beams = get_beams(in);
  posed.world_from_ego = get_pose(in);
  posed.ego_from_sensor = get_pose(in);
  posed.twist.speed_m_per_s = in.get<double>();
  posed.twist.lateral_m_per_s = in.get<double>();
  posed.twist.yaw_rate_rad_per_s = in.get<double>();
  posed.mount_is_known = in.get<std::uint8_t>() != 0;
  const std::size_t count = in.get<std::uint32_t>();
  const auto raw = in.take(count * sizeof(Return));
  if (!in.ok()) return fail(Error::Code::kMalformed, "a scan that was put aside is cut off");
  scan.returns.resize(count);
  if (count > 0) std::memcpy(scan.returns.data(), raw.data(), raw.size());
  return posed;
}

std::uint32_t ScanLog::number_of_sensor(const pipeline::PosedScan& posed) {
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    if (sensors_[i].name == posed.scan.sensor) return static_cast<std::uint32_t>(i);
  }
  sensors_.push_back({posed.scan.sensor, posed.ego_from_sensor});
  return static_cast<std::uint32_t>(sensors_.size() - 1);
}

Result<std::uint32_t> ScanLog::add(const pipeline::PosedScan& posed) {
  auto place = spool_->put(pack(posed));
  if (!place) return tl::unexpected(place.error());
  const std::unique_lock lock(guard_);
  if (entries_.empty() && is_finite(posed.world_from_ego)) {
    origin_m_ = posed.world_from_ego.translation_m;
  }
  entries_.push_back({posed.scan.stamp, posed.scan.frame, number_of_sensor(posed),
                      posed.world_from_ego.planar(), *place});
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

void ScanLog::add(TruthFrame truth) {
  const std::unique_lock lock(guard_);
  const Time stamp = truth.stamp;
  truth_.insert_or_assign(stamp, std::move(truth));
}

Result<pipeline::PosedScan> ScanLog::get(std::uint32_t frame) const {
  io::Spool::Place place;
  {
    const std::shared_lock lock(guard_);
    if (frame >= entries_.size()) return fail(Error::Code::kNotFound, "no frame {}", frame);
    place = entries_[frame].place;
  }
  auto bytes = spool_->get(place);
  if (!bytes) return tl::unexpected(bytes.error());
  return unpack_scan(*bytes);
}

std::uint32_t ScanLog::size() const {
  const std::shared_lock lock(guard_);
  return static_cast<std::uint32_t>(entries_.size());
}

std::vector<double> ScanLog::times_s(std::uint32_t from, std::uint32_t to) const {
  const std::shared_lock lock(guard_);
  std::vector<double> times;
  for (std::size_t i = from; i < std::min<std::size_t>(to, entries_.size()); ++i) {
    times.push_back(to_seconds(entries_[i].stamp - entries_.front().stamp));
  }
  return times;
}

Time ScanLog::stamp(std::uint32_t frame) const {
  const std::shared_lock lock(guard_);
  return frame < entries_.size() ? entries_[frame].stamp : Time{};
}

std::int64_t ScanLog::number(std::uint32_t frame) const {
  const std::shared_lock lock(guard_);
  return frame < entries_.size() ? entries_[frame].number : 0;
}

const TruthFrame* ScanLog::truth_near(const Entry& entry, Duration reach) const {
  const auto after = truth_.lower_bound(entry.stamp);
  const TruthFrame* best = nullptr;
  if (after != truth_.end() && after->first - entry.stamp <= reach) {
    best = &after->second;
    reach = after->first - entry.stamp;
  }
  if (after != truth_.begin() && entry.stamp - std::prev(after)->first < reach) {
    best = &std::prev(after)->second;
  }
  return best;
}

std::vector<TruthObject> ScanLog::truth_at(std::uint32_t frame) const {
  const std::shared_lock lock(guard_);
  if (frame >= entries_.size() || truth_.empty()) return {};
  const std::uint32_t other = frame > 0 ? frame - 1 : std::min<std::uint32_t>(1, frame + 1);
  Duration gap = std::chrono::milliseconds(100);
  if (other < entries_.size() && other != frame) {
    gap = std::chrono::abs(entries_[frame].stamp - entries_[other].stamp);
  }
  const TruthFrame* found = truth_near(entries_[frame], gap / 2);
  if (found == nullptr) return {};
  if (found->coordinate_frame != "ego") return found->objects;
  std::vector<TruthObject> objects;
  for (const auto& object : found->objects) {
    objects.push_back(moved(object, entries_[frame].world_from_ego));
  }
  return objects;
}

std::vector<TruthFrame> ScanLog::truth() const {
  const std::shared_lock lock(guard_);
  std::vector<TruthFrame> frames;
  for (const auto& [stamp, frame] : truth_) frames.push_back(frame);
  return frames;
}

bool ScanLog::has_truth() const {
  const std::shared_lock lock(guard_);
  return !truth_.empty();
}

std::vector<SensorSeen> ScanLog::sensors() const {
  const std::shared_lock lock(guard_);
  return sensors_;
}

std::uint32_t ScanLog::sensor_of(std::uint32_t frame) const {
  const std::shared_lock lock(guard_);
  return frame < entries_.size() ? entries_[frame].sensor : 0;
}

Eigen::Vector3d ScanLog::origin_m() const {
  const std::shared_lock lock(guard_);
  return origin_m_;
}

}  // namespace scanfuse::serve
