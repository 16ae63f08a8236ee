#include "scanfuse/io/toml.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

#include "scanfuse/io/text/byte_source.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kLargestToml = std::size_t{1} << 20;
constexpr int kDeepestToml = 16;

/// Walks the parsed tables and keeps the first fault.
class TomlCollector {
 public:
  explicit TomlCollector(const std::string& name) : name_(name) {}

  Result<void> take_table(const toml::table& table, const std::string& section, int depth) {
    for (const auto& [key, node] : table) {
      const std::string key_text(key.str());
      if (const auto* inner = node.as_table()) {
        if (depth >= kDeepestToml) return wrong(node, "tables nested too deep");
        const std::string path =
            section.empty() ? key_text : fmt::format("{}.{}", section, key_text);
        if (auto taken = take_table(*inner, path, depth + 1); !taken) return taken;
      } else if (auto taken = take_value(section, key_text, key, node); !taken) {
        return taken;
      }
    }
    return {};
  }

  std::vector<TomlEntry> finish() {
    std::stable_sort(entries_.begin(), entries_.end(), [](const auto& a, const auto& b) {
      return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    });
    return std::move(entries_);
  }

 private:
  Result<void> take_value(const std::string& section, const std::string& key_text,
                          const toml::key& key, const toml::node& node) {
    std::string value;
    if (const auto* text = node.as_string()) {
      value = text->get();
    } else if (const auto* flag = node.as_boolean()) {
      value = flag->get() ? "true" : "false";
    } else if (const auto* whole = node.as_integer()) {
      value = std::to_string(whole->get());
    } else if (const auto* number = node.as_floating_point()) {
      if (!std::isfinite(number->get())) return wrong(node, key_text + " is not a finite number");
      value = print_number(number->get());
    } else {
      return wrong(node, key_text + " needs one value: a number, true, false or text");
    }
    const auto begin = key.source().begin;
    entries_.push_back({section, key_text, std::move(value), begin.line, begin.column});
    return {};
  }

  [[nodiscard]] tl::unexpected<Error> wrong(const toml::node& node, std::string_view what) const {
    const auto begin = node.source().begin;
    return fail(Error::Code::kMalformed, "{}:{}:{}: {}", name_, begin.line, begin.column, what);
  }

  const std::string& name_;
  std::vector<TomlEntry> entries_;
};

/// Text in double quotes with what TOML wants escaped.
std::string quoted_toml(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

}  // namespace

Result<std::vector<TomlEntry>> parse_toml(std::string_view text, const std::string& name) {
  try {
    const toml::table root = toml::parse(text, std::string_view(name));
    TomlCollector collector(name);
    if (auto taken = collector.take_table(root, "", 0); !taken)
      return tl::unexpected(taken.error());
    return collector.finish();
  } catch (const toml::parse_error& error) {
    const auto begin = error.source().begin;
    return fail(Error::Code::kMalformed, "{}:{}:{}: {}", name, begin.line, begin.column,
                error.description());
  }
}

Result<std::vector<TomlEntry>> read_toml(const std::filesystem::path& path) {
  auto source = open_bytes(path);
  if (!source) return tl::unexpected(source.error());
  const auto text = read_start(**source, kLargestToml + 1);
  if (!text) return tl::unexpected(text.error());
  if (text->size() > kLargestToml) {
    return fail(Error::Code::kUnsupported, "{}: more than 1 MiB is no configuration",
                path.string());
  }
  return parse_toml(*text, path.string());
}

std::string write_toml(const std::vector<OptionView>& options) {
  std::string text, section;
  for (const OptionView& option : options) {
    if (option.section != section) {
      text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", option.section);
      section = option.section;
    }
    text += fmt::format("# {}{}{}\n", option.doc, option.range.empty() ? "" : "; ", option.range);
    if (option.value != option.fallback) text += fmt::format("# default: {}\n", option.fallback);
    text += fmt::format("{} = {}\n", option.name,
                        option.quoted ? quoted_toml(option.value) : option.value);
  }
  return text;
}

}  // namespace scanfuse::io
