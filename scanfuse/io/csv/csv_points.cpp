#include "scanfuse/io/csv/csv_points.hpp"

#include <algorithm>
#include <deque>

#include "scanfuse/io/csv/csv_table.hpp"
#include "scanfuse/io/text/stamp_watch.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kMostReturnsOfAFrame = 20'000'000;
constexpr std::string_view kOnlySensor = "/points";

enum PointColumn : std::size_t {
  kPointX,
  kPointY,
  kPointFrame,
  kPointTime,
  kPointZ,
  kPointLayer,
  kPointIntensity,
  kPointSensor
};

CsvColumns point_columns(bool with_frames, bool with_units) {
  CsvColumns columns{"points", {"x_m", "y_m"}, {}};
  if (!with_units) columns.required = {"x", "y"};
  auto& framing = with_frames ? columns.required : columns.optional;
  framing.insert(framing.end(), {"frame", "time_s"});
  columns.optional.insert(columns.optional.end(),
                          {with_units ? "z_m" : "z", "layer", "intensity", "sensor"});
  return columns;
}

struct PointRow {
  std::int64_t frame = 0;
  Time time;
  Return point;
  std::string_view sensor;
};

PointRow read_point(CsvTable& table, bool paper_axes) {
  PointRow row;
  row.frame = table.has(kPointFrame) ? table.whole(kPointFrame) : 0;
  row.time = table.has(kPointTime) ? table.time(kPointTime) : Time{};
  const auto x = static_cast<float>(table.metres(kPointX));
  const auto y = static_cast<float>(table.metres(kPointY));
  row.point.x_m = paper_axes ? y : x;
  row.point.y_m = paper_axes ? -x : y;
  row.point.z_m = static_cast<float>(table.metres(kPointZ));
  row.point.intensity = static_cast<float>(table.metres(kPointIntensity));
  const std::int64_t layer = table.whole(kPointLayer);
  if (layer < 0 || layer > INT16_MAX) table.reject(kPointLayer, "is no layer");
  row.point.layer = static_cast<std::int16_t>(layer);
  row.sensor = table.empty(kPointSensor) ? kOnlySensor : table.text(kPointSensor);
  return row;
}

class CsvPointsReader final : public RecordingReader {
 public:
  CsvPointsReader(CsvTable table, RecordingInfo info, OpenOptions options, Diagnostics diagnostics)
      : table_(std::move(table)),
        info_(std::move(info)),
        options_(std::move(options)),
        diagnostics_(std::move(diagnostics)) {}

  const RecordingInfo& info() const override { return info_; }
  const Diagnostics& diagnostics() const override { return diagnostics_; }

  /// Reads on until a frame is whole; false where the file has nothing more.
  bool fill() {
    while (ready_.empty()) {
      if (!table_.next_row(diagnostics_)) {
        close_frame();
        return !ready_.empty();
      }
      const PointRow row = read_point(table_, options_.paper_axes);
      if (table_.row_is_good(diagnostics_)) take(row);
    }
    return true;
  }

  Result<std::optional<Event>> next() override {
    if (!fill()) return std::nullopt;
    Event event{ready_.front().stamp, ready_.front().sensor, std::move(ready_.front())};
    ready_.pop_front();
    return event;
  }

  [[nodiscard]] tl::unexpected<Error> nothing_found() const {
    return table_.nothing_found("points");
  }

 private:
  struct OpenScan {
    Scan scan;
    Duration earliest{0};  ///< after the first row's time
  };

  void take(const PointRow& row) {
    if (!open_.empty() && row.frame != frame_) {
      if (row.frame < frame_) diagnostics_.note("frame out of order", table_.where());
      close_frame();
    }
    frame_ = row.frame;
    OpenScan& target = scan_of(row);
    if (target.scan.returns.size() >= kMostReturnsOfAFrame) {
      diagnostics_.damage("more than 20 million returns in a frame dropped", table_.where());
      return;
    }
    const Duration after = row.time - target.scan.stamp;
    target.earliest = std::min(target.earliest, after);
    target.scan.returns.push_back(row.point);
    target.scan.returns.back().time_offset_s = static_cast<float>(to_seconds(after));
  }

  OpenScan& scan_of(const PointRow& row) {
    for (OpenScan& open : open_) {
      if (open.scan.sensor == row.sensor) return open;
    }
    OpenScan fresh;
    fresh.scan.stamp = row.time;
    fresh.scan.frame = row.frame;
    fresh.scan.sensor = row.sensor;
    fresh.scan.frame_id = row.sensor == kOnlySensor ? "" : std::string(row.sensor);
    return open_.emplace_back(std::move(fresh));
  }

  void close_frame() {
    for (OpenScan& open : open_) {
      const auto shift = static_cast<float>(to_seconds(open.earliest));
      if (open.earliest < Duration{0}) {
        for (Return& r : open.scan.returns) r.time_offset_s -= shift;
      }
      open.scan.stamp += open.earliest;
    }
    std::stable_sort(open_.begin(), open_.end(), [](const OpenScan& a, const OpenScan& b) {
      return a.scan.stamp < b.scan.stamp;
    });
    for (OpenScan& open : open_) give(std::move(open.scan));
    open_.clear();
  }

  void give(Scan scan) {
    watch_.see(scan.sensor, scan.stamp, fmt::format("frame {}", scan.frame), diagnostics_);
    info_.start = std::min(info_.start.value_or(scan.stamp), scan.stamp);
    info_.end = std::max(info_.end.value_or(scan.stamp), scan.stamp);
    count(scan.sensor);
    const auto& wanted = options_.topics;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), scan.sensor) == wanted.end()) {
      return;
    }
    ready_.push_back(std::move(scan));
  }

  void count(const std::string& sensor) {
    for (TopicInfo& topic : info_.topics) {
      if (topic.name == sensor) {
        ++topic.messages;
        return;
      }
    }
    info_.topics.push_back({sensor, "csv points", "text", 1, false, true, true});
  }

  CsvTable table_;
  RecordingInfo info_;
  OpenOptions options_;
  Diagnostics diagnostics_;
  StampWatch watch_;
  std::int64_t frame_ = 0;
  std::vector<OpenScan> open_;
  std::deque<Scan> ready_;
};

/// What the header says: without any framing column the file is a plain list of points.
struct Framing {
  bool frames = true;
  bool units = true;
};

Framing framing_of(std::string_view header) {
  std::vector<std::string> scratch;
  std::vector<std::string_view> names;
  split_csv(header, scratch, names);
  const auto has = [&](std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return {has("frame") || has("time_s"), !(has("x") && has("y")) || has("x_m") || has("y_m")};
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> open_csv_points(LineReader lines,
                                                         const OpenOptions& options) {
  Diagnostics diagnostics;
  RecordingInfo info;
  info.path = lines.name();
  info.format = "csv points";
  info.compression = lines.packing();
  const Framing framing = framing_of(lines.peek_content(diagnostics));
  auto table =
      CsvTable::open(std::move(lines), point_columns(framing.frames, framing.units), diagnostics);
  if (!table) return tl::unexpected(table.error());
  if (!framing.frames) diagnostics.note("neither frame nor time_s: all rows make one scan at 0 s");
  auto reader = std::make_unique<CsvPointsReader>(std::move(*table), std::move(info), options,
                                                  std::move(diagnostics));
  if (!reader->fill() && reader->info().topics.empty()) return reader->nothing_found();
  return reader;
}

}  // namespace scanfuse::io
