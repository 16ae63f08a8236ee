#include "scanfuse/io/result_writer.hpp"

#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/csv/track_rows.hpp"
#include "scanfuse/io/mcap/result_writer.hpp"

namespace scanfuse::io {
namespace {

/// Rows of tracks in text; scans and truth have no place there.
class TrackTextWriter final : public ResultWriter {
 public:
  TrackTextWriter(AtomicFile file, std::string (*rows)(const StepResult&))
      : file_(std::move(file)), rows_(rows) {}
  Result<void> write(const StepResult& step, const Scan&) override {
    return file_.write(rows_(step));
  }
  Result<void> write(const TruthFrame&) override { return {}; }
  Result<void> finish() override { return file_.commit(); }

 private:
  AtomicFile file_;
  std::string (*rows_)(const StepResult&);
};

}  // namespace

Result<std::unique_ptr<ResultWriter>> open_result_writer(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".mcap") return open_mcap_result_writer(path);
  if (extension != ".csv" && extension != ".jsonl") {
    return fail(Error::Code::kUnsupported,
                "{}: results are written as .mcap, .csv or .jsonl, not as '{}'", path.string(),
                extension);
  }
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (extension == ".jsonl") {
    return std::make_unique<TrackTextWriter>(std::move(*file), &track_json_rows);
  }
  if (auto wrote = file->write(track_header()); !wrote) return tl::unexpected(wrote.error());
  return std::make_unique<TrackTextWriter>(std::move(*file), &track_csv_rows);
}

}  // namespace scanfuse::io
