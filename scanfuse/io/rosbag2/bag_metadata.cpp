#include "scanfuse/io/rosbag2/bag_metadata.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <system_error>
#include <tuple>

namespace scanfuse::io::rosbag2 {

namespace {

constexpr std::size_t kLongestMetadata = std::size_t{64} << 20;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string unquoted(std::string_view text) {
  const bool quoted =
      text.size() >= 2 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0];
  return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool is_bag_file(const std::filesystem::path& path) {
  const auto name = path.filename().string();
  return name.ends_with(".db3") || name.ends_with(".mcap") || name.ends_with(".db3.zstd") ||
         name.ends_with(".mcap.zstd");
}

/// Numbers within names count by value: part_2 comes before part_10.
std::tuple<std::string, std::size_t, std::string> name_order(const std::filesystem::path& path) {
  const auto name = path.filename().string();
  const auto stem = name.substr(0, name.find('.'));
  const auto last_other = stem.find_last_not_of("0123456789");
  const auto digits = last_other == std::string::npos ? stem : stem.substr(last_other + 1);
  return {stem.substr(0, stem.size() - digits.size()), digits.size(), name};
}

Result<std::vector<std::filesystem::path>> bag_files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  std::error_code trouble;
  std::filesystem::directory_iterator entries(folder, trouble);
  if (trouble) {
    return fail(Error::Code::kNotFound, "{}: {}", folder.string(), trouble.message());
  }
  for (; entries != std::filesystem::directory_iterator(); entries.increment(trouble)) {
    if (is_bag_file(entries->path())) paths.push_back(entries->path());
    if (trouble) break;
  }
  std::sort(paths.begin(), paths.end(),
            [](const auto& a, const auto& b) { return name_order(a) < name_order(b); });
  return paths;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  return text.size() <= kLongestMetadata ? text : std::string();
}

}  // namespace

BagMetadata parse_metadata(std::string_view yaml) {
  BagMetadata metadata;
  bool in_files = false;
  while (!yaml.empty()) {
    const auto line = trimmed(yaml.substr(0, yaml.find('\n')));
    yaml.remove_prefix(
        std::min(yaml.size(), yaml.find('\n') + 1 == 0 ? yaml.size() : yaml.find('\n') + 1));
    if (line.empty()) continue;
    if (in_files && line.starts_with("- ")) {
      metadata.files.push_back(unquoted(trimmed(line.substr(2))));
      continue;
    }
    const auto colon = line.find(':');
    if (colon == std::string_view::npos) continue;
    const auto key = line.substr(0, colon);
    const auto value = unquoted(trimmed(line.substr(colon + 1)));
    in_files = key == "relative_file_paths";
    if (key == "compression_format") metadata.compression_format = lower(value);
    if (key == "compression_mode") metadata.compression_mode = lower(value);
  }
  return metadata;
}

Result<BagFiles> list_bag_files(const std::filesystem::path& folder) {
  BagFiles files;
  std::error_code trouble;
  const auto metadata_path = folder / "metadata.yaml";
  if (std::filesystem::exists(metadata_path, trouble)) {
    const auto metadata = parse_metadata(read_text(metadata_path));
    files.messages_compressed = metadata.compression_mode == "message";
    for (const auto& name : metadata.files) {
      // Early versions wrote the folder's own name in front.
      const auto inside = folder / std::filesystem::path(name).filename();
      if (std::filesystem::is_regular_file(inside, trouble)) {
        files.paths.push_back(inside);
      } else {
        files.missing.push_back(name);
      }
    }
  }
  if (!files.paths.empty()) return files;
  auto found = bag_files_in(folder);
  if (!found) return tl::unexpected(found.error());
  files.paths = std::move(*found);
  if (files.paths.empty()) {
    return fail(Error::Code::kNotFound, "{}: no .db3 or .mcap file in this folder",
                folder.string());
  }
  files.missing.clear();  // renamed files: what is there counts
  return files;
}

}  // namespace scanfuse::io::rosbag2
