#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/core/result.hpp"

namespace scanfuse::io {

/// One `key = value` of a configuration file, the value as `--set section.key=value` would take it.
struct TomlEntry {
  std::string section;  ///< "segment"; "track.gate" for nested tables; empty above the first table
  std::string key;
  std::string value;
  std::int64_t line = 0;
  std::int64_t column = 0;
};

/// Reads a TOML file of tables that hold booleans, numbers and text; entries in the file's order.
/// Errors name line and column: bad syntax, a key given twice, arrays, dates, and numbers that are
/// not finite.
[[nodiscard]] Result<std::vector<TomlEntry>> read_toml(const std::filesystem::path& path);
[[nodiscard]] Result<std::vector<TomlEntry>> parse_toml(std::string_view text,
                                                        const std::string& name);

/// The options as TOML, one table a section in the order given, each option under a comment with
/// its doc, range and default. Reads back with read_toml.
[[nodiscard]] std::string write_toml(const std::vector<OptionView>& options);

}  // namespace scanfuse::io
