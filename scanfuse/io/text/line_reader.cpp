#include "scanfuse/io/text/line_reader.hpp"

#include <cstring>

#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kLineBuffer = std::size_t{2} << 20;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

}  // namespace

LineReader::LineReader(std::string name, std::unique_ptr<ByteSource> source)
    : name_(std::move(name)), source_(std::move(source)) {}

Result<LineReader> LineReader::open(const std::filesystem::path& path) {
  auto source = open_bytes(path);
  if (!source) return tl::unexpected(source.error());
  return LineReader(path.string(), std::move(*source));
}

std::string LineReader::where() const { return fmt::format("{}:{}", name_, line_); }

bool LineReader::refill(Diagnostics& diagnostics) {
  if (ended_) return false;
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (buffer_.size() == end_) buffer_.resize(buffer_.empty() ? std::size_t{1} << 16 : kLineBuffer);
  const auto got = source_->read(std::span(buffer_.data() + end_, buffer_.size() - end_));
  if (!got) {
    broken_ = got.error();
    diagnostics.damage("file breaks off", got.error().message);
  }
  ended_ = !got || *got == 0;
  if (!ended_) end_ += *got;
  return !ended_;
}

std::string_view LineReader::finish(std::string_view line) {
  ++line_;
  if (line_ == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
  if (line.ends_with('\r')) line.remove_suffix(1);
  last_ = line;
  return line;
}

std::string_view LineReader::peek_content(Diagnostics& diagnostics) {
  while (const auto line = next(diagnostics)) {
    const std::string_view text = trimmed(*line);
    if (text.empty() || text.front() == '#') continue;
    put_back();
    return *line;
  }
  return {};
}

std::optional<std::string_view> LineReader::next(Diagnostics& diagnostics) {
  if (again_) {
    again_ = false;
    return last_;
  }
  bool too_long = false;
  std::size_t searched = 0;
  for (;;) {
    const char* from = buffer_.data() + begin_ + searched;
    const std::size_t left = end_ - begin_ - searched;
    const auto* stop =
        left == 0 ? nullptr : static_cast<const char*>(std::memchr(from, '\n', left));
    if (stop != nullptr) {
      const std::string_view line(buffer_.data() + begin_,
                                  static_cast<std::size_t>(stop - buffer_.data()) - begin_);
      begin_ += line.size() + 1;
      const std::string_view text = finish(line);
      if (!too_long && line.size() <= kLongestLine) return text;
      diagnostics.damage("line too long", where());
      too_long = false;
      searched = 0;
      continue;
    }
    searched += left;
    if (searched > kLongestLine) {
      too_long = true;
      begin_ = end_;
      searched = 0;
    }
    if (refill(diagnostics)) continue;
    if (begin_ == end_ && !too_long) return std::nullopt;
    const std::string_view rest(buffer_.data() + begin_, end_ - begin_);
    begin_ = end_;
    const std::string_view text = finish(rest);
    if (!too_long) return text;
    diagnostics.damage("line too long", where());
    return std::nullopt;
  }
}

}  // namespace scanfuse::io
