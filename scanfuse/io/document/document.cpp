#include "scanfuse/io/document/document.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scanfuse/core/options.hpp"
#include "scanfuse/io/text/byte_source.hpp"

namespace scanfuse::io {

Result<std::string> read_document_text(const std::filesystem::path& path, std::size_t limit,
                                       std::string_view what) {
  auto source = open_bytes(path);
  if (!source) return tl::unexpected(source.error());
  auto text = read_start(**source, limit + 1);
  if (!text) return text;
  if (text->size() <= limit) return text;
  return fail(Error::Code::kUnsupported, "{}: more than {} MiB is no {}", path.string(),
              limit >> 20, what);
}

Result<DocumentTable> DocumentTable::root(const DocumentNode& node, const std::string& file) {
  if (!std::holds_alternative<DocumentNode::Table>(node.value)) {
    return fail(Error::Code::kMalformed, "{}: holds no table of keys and values", file);
  }
  return DocumentTable(node, file, "");
}

const DocumentNode* DocumentTable::find(std::string_view key) const {
  const auto* table = std::get_if<DocumentNode::Table>(&node_->value);
  if (table == nullptr) return nullptr;
  for (const auto& [name, child] : *table) {
    if (name == key) return &child;
  }
  return nullptr;
}

std::string DocumentTable::place(std::string_view key) const {
  const DocumentNode* node = find(key);
  if (node == nullptr) node = node_;
  if (node->line > 0) return fmt::format("{}:{}:{}", *file_, node->line, node->column);
  return path_.empty() ? *file_ : fmt::format("{}: {}", *file_, path_);
}

tl::unexpected<Error> DocumentTable::wrong(std::string_view key, std::string_view what) const {
  return fail(Error::Code::kMalformed, "{}: {}", place(key), what);
}

Result<void> DocumentTable::only(const std::vector<std::string>& known) const {
  for (const auto& [name, child] : std::get<DocumentNode::Table>(node_->value)) {
    if (std::ranges::find(known, name) != known.end()) continue;
    return wrong(
        name, fmt::format("unknown key '{}'; did you mean '{}'?", name, nearest_name(name, known)));
  }
  return {};
}

Result<double> DocumentTable::number(std::string_view key, double low, double high) const {
  const DocumentNode* node = find(key);
  if (node == nullptr) return wrong(key, fmt::format("{} is missing", key));
  const double* value = node->number();
  if (value == nullptr || !(*value >= low && *value <= high)) {
    return wrong(key, fmt::format("{} needs a number from {} to {}", key, low, high));
  }
  return *value;
}

Result<double> DocumentTable::number_or(std::string_view key, double fallback, double low,
                                        double high) const {
  return has(key) ? number(key, low, high) : fallback;
}

Result<int> DocumentTable::whole(std::string_view key, int low, int high) const {
  const auto value = number(key, low, high);
  if (!value) return tl::unexpected(value.error());
  if (*value == std::floor(*value)) return static_cast<int>(*value);
  return wrong(key, fmt::format("{} needs a whole number", key));
}

Result<bool> DocumentTable::flag_or(std::string_view key, bool fallback) const {
  const DocumentNode* node = find(key);
  if (node == nullptr) return fallback;
  if (const bool* value = std::get_if<bool>(&node->value)) return *value;
  return wrong(key, fmt::format("{} needs true or false", key));
}

Result<std::string> DocumentTable::text_or(std::string_view key, std::string fallback) const {
  const DocumentNode* node = find(key);
  if (node == nullptr) return fallback;
  if (const auto* value = std::get_if<std::string>(&node->value)) return *value;
  return wrong(key, fmt::format("{} needs text in quotes", key));
}

Result<std::string> DocumentTable::choice_or(std::string_view key, std::string fallback,
                                             const std::vector<std::string>& known) const {
  auto value = text_or(key, std::move(fallback));
  if (!value || std::ranges::find(known, *value) != known.end()) return value;
  return wrong(key, fmt::format("{} = \"{}\" is none of: {}", key, *value, fmt::join(known, ", ")));
}

Result<std::vector<double>> DocumentTable::numbers(std::string_view key, std::size_t count,
                                                   bool gaps) const {
  const DocumentNode* node = find(key);
  if (node == nullptr) return wrong(key, fmt::format("{} is missing", key));
  const auto* array = node->array();
  std::vector<double> values;
  if (array != nullptr) {
    values.reserve(array->size());
    for (const DocumentNode& item : *array) {
      if (const double* value = item.number()) {
        values.push_back(*value);
      } else if (gaps && std::holds_alternative<std::monostate>(item.value)) {
        values.push_back(std::numeric_limits<double>::quiet_NaN());
      }
    }
  }
  if (array == nullptr || values.size() != array->size() || (count > 0 && values.size() != count)) {
    return wrong(key, count > 0 ? fmt::format("{} needs {} numbers", key, count)
                                : fmt::format("{} needs an array of numbers", key));
  }
  return values;
}

Result<std::vector<double>> DocumentTable::rows(std::string_view key, std::size_t rows,
                                                std::size_t columns) const {
  const DocumentNode* node = find(key);
  if (node == nullptr) return wrong(key, fmt::format("{} is missing", key));
  std::vector<double> values;
  const auto* array = node->array();
  for (std::size_t r = 0; array != nullptr && r < array->size(); ++r) {
    const auto* row = (*array)[r].array();
    if (row == nullptr || row->size() != columns) break;
    for (const DocumentNode& item : *row) {
      if (const double* value = item.number()) values.push_back(*value);
    }
  }
  const bool any = rows == 0 && array != nullptr && values.size() == array->size() * columns;
  if (any ||
      (rows > 0 && array != nullptr && array->size() == rows && values.size() == rows * columns)) {
    return values;
  }
  return wrong(key, rows > 0 ? fmt::format("{} needs {} rows of {} numbers", key, rows, columns)
                             : fmt::format("{} needs rows of {} numbers", key, columns));
}

Result<std::optional<DocumentTable>> DocumentTable::table(std::string_view key) const {
  const DocumentNode* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!std::holds_alternative<DocumentNode::Table>(node->value)) {
    return wrong(key, fmt::format("{} needs a table", key));
  }
  const std::string path = path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
  return DocumentTable(*node, *file_, path);
}

Result<std::vector<DocumentTable>> DocumentTable::tables(std::string_view key) const {
  std::vector<DocumentTable> found;
  const DocumentNode* node = find(key);
  if (node == nullptr) return found;
  const auto* array = node->array();
  if (array == nullptr) return wrong(key, fmt::format("{} needs an array of tables", key));
  for (std::size_t k = 0; k < array->size(); ++k) {
    if (!std::holds_alternative<DocumentNode::Table>((*array)[k].value)) {
      return wrong(key, fmt::format("{}[{}] is no table", key, k));
    }
    found.push_back(DocumentTable(
        (*array)[k], *file_,
        path_.empty() ? fmt::format("{}[{}]", key, k) : fmt::format("{}.{}[{}]", path_, key, k)));
  }
  return found;
}

}  // namespace scanfuse::io
