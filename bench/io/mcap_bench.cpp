#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>

#include "scanfuse/core/random.hpp"
#include "scanfuse/geometry/angles.hpp"
#include "scanfuse/io/mcap/message_source.hpp"
#include "scanfuse/io/mcap/topic_writer.hpp"
#include "scanfuse/io/recording.hpp"
#include "scanfuse/io/ros/encode.hpp"

namespace scanfuse::io {
namespace {

constexpr int kScans = 600;  // about 20 MB

/// 4 x 440 returns with noise in the last bits, as lidars give them: what compresses is the rest.
Scan noisy_scan(RandomStream& random) {
  Scan scan;
  for (int beam = 0; beam < 440; ++beam) {
    const double bearing = radians(0.25) * (beam - 220);
    for (int layer = 0; layer < 4; ++layer) {
      const double range = 20 + 5 * std::sin(0.05 * beam) + random.normal(0, 0.03);
      Return r;
      r.x_m = static_cast<float>(range * std::cos(bearing));
      r.y_m = static_cast<float>(range * std::sin(bearing));
      r.z_m = static_cast<float>(range * 0.014 * (layer - 1.5));
      r.time_offset_s = static_cast<float>(beam) * 5e-5F;
      r.beam = beam;
      r.layer = static_cast<std::int16_t>(layer);
      scan.returns.push_back(r);
    }
  }
  return scan;
}

/// A recording in the temporary folder, removed at the end.
class Recording {
 public:
  explicit Recording(mcap::Compression compression)
      : path_(std::filesystem::temp_directory_path() /
              ("scanfuse_bench_" + std::to_string(static_cast<int>(compression)) + ".mcap")) {
    mcap::WriterOptions options;
    options.compression = compression;
    auto writer = mcap::TopicWriter::create(path_, options);
    RandomStream random(1);
    for (int i = 0; writer && i < kScans; ++i) {
      Scan scan = noisy_scan(random);
      scan.stamp = time_from_seconds(0.08 * i);
      const auto message = ros::encode_cdr(scan);
      bytes_ += static_cast<std::int64_t>(message.bytes.size());
      if (!writer->write_cdr("/scan", scan.stamp, message)) return;
    }
    whole_ = writer && writer->finish();
  }
  ~Recording() { std::filesystem::remove(path_); }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::int64_t message_bytes() const { return bytes_; }
  [[nodiscard]] bool whole() const { return whole_; }

 private:
  std::filesystem::path path_;
  std::int64_t bytes_ = 0;
  bool whole_ = false;
};

void finish(benchmark::State& state, const Recording& recording, std::int64_t messages) {
  if (messages != state.iterations() * kScans) state.SkipWithError("messages are missing");
  state.SetBytesProcessed(state.iterations() * recording.message_bytes());
  state.counters["file_share"] = static_cast<double>(std::filesystem::file_size(recording.path())) /
                                 static_cast<double>(recording.message_bytes());
}

/// Bytes per second of messages, taken out of their chunks: nothing decoded.
void read_messages(benchmark::State& state, mcap::Compression compression) {
  const Recording recording(compression);
  std::int64_t messages = 0;
  for (auto _ : state) {
    auto source = open_mcap(recording.path());
    if (!source) return state.SkipWithError("cannot be opened");
    for (auto message = (*source)->next(); message && *message; message = (*source)->next()) {
      ++messages;
    }
  }
  finish(state, recording, messages);
}

/// The same, decoded to scans.
void read_scans(benchmark::State& state, mcap::Compression compression) {
  const Recording recording(compression);
  std::int64_t scans = 0;
  for (auto _ : state) {
    auto reader = open_recording(recording.path());
    if (!reader) return state.SkipWithError("cannot be opened");
    for (auto event = (*reader)->next(); event && *event; event = (*reader)->next()) ++scans;
  }
  finish(state, recording, scans);
}

#define SCANFUSE_MCAP_BENCH(how, name)                   \
  BENCHMARK_CAPTURE(how, none, mcap::Compression::kNone) \
      ->Name(name "/none/scans:600")                     \
      ->Unit(benchmark::kMillisecond);                   \
  BENCHMARK_CAPTURE(how, lz4, mcap::Compression::kLz4)   \
      ->Name(name "/lz4/scans:600")                      \
      ->Unit(benchmark::kMillisecond);                   \
  BENCHMARK_CAPTURE(how, zstd, mcap::Compression::kZstd) \
      ->Name(name "/zstd/scans:600")                     \
      ->Unit(benchmark::kMillisecond)
SCANFUSE_MCAP_BENCH(read_messages, "Mcap_Messages");
SCANFUSE_MCAP_BENCH(read_scans, "Mcap_Scans");

}  // namespace
}  // namespace scanfuse::io
