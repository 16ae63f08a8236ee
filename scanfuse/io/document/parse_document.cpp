#include <toml++/toml.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scanfuse/io/document/document.hpp"

namespace scanfuse::io {
namespace {

constexpr int kDeepestDocument = 32;

DocumentNode from_toml(const toml::node& node, int depth);

DocumentNode::Array array_from_toml(const toml::array& array, int depth) {
  DocumentNode::Array items;
  items.reserve(array.size());
  for (const toml::node& item : array) items.push_back(from_toml(item, depth + 1));
  return items;
}

DocumentNode::Table table_from_toml(const toml::table& table, int depth) {
  DocumentNode::Table members;
  members.reserve(table.size());
  for (const auto& [key, item] : table) {
    members.push_back({std::string(key.str()), from_toml(item, depth + 1)});
  }
  return members;
}

DocumentNode from_toml(const toml::node& node, int depth) {
  DocumentNode made;
  made.line = static_cast<std::int32_t>(node.source().begin.line);
  made.column = static_cast<std::int32_t>(node.source().begin.column);
  if (depth > kDeepestDocument) return made;
  if (const toml::table* table = node.as_table()) {
    made.value = table_from_toml(*table, depth);
  } else if (const toml::array* array = node.as_array()) {
    made.value = array_from_toml(*array, depth);
  } else if (const auto* text = node.as_string()) {
    made.value = text->get();
  } else if (const auto* flag = node.as_boolean()) {
    made.value = flag->get();
  } else if (node.is_number()) {
    const double value = node.value<double>().value_or(std::nan(""));
    if (std::isfinite(value)) made.value = value;
  }
  return made;
}

/// Builds the tree from the parser's events, so that no second tree stands beside it.
class DocumentHandler {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  bool null() { return put({}); }
  bool boolean(bool value) { return put({value}); }
  bool number_integer(number_integer_t value) { return put({static_cast<double>(value)}); }
  bool number_unsigned(number_unsigned_t value) { return put({static_cast<double>(value)}); }
  bool number_float(number_float_t value, const string_t&) {
    return std::isfinite(value) ? put({value}) : put({});
  }
  bool string(string_t& value) { return put({std::move(value)}); }
  bool binary(binary_t&) { return false; }
  bool start_object(std::size_t) { return open({DocumentNode::Table{}}); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open({DocumentNode::Array{}}); }
  bool end_array() { return close(); }
  bool key(string_t& name) {
    keys_.back() = std::move(name);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception&) {
    broken_at_ = position;
    return false;
  }

  DocumentNode root;
  [[nodiscard]] std::size_t broken_at() const { return broken_at_; }

 private:
  bool put(DocumentNode node) {
    if (open_.empty()) {
      root = std::move(node);
    } else if (auto* array = std::get_if<DocumentNode::Array>(&open_.back().value)) {
      array->push_back(std::move(node));
    } else {
      std::get<DocumentNode::Table>(open_.back().value)
          .push_back({std::move(keys_.back()), std::move(node)});
    }
    return true;
  }
  bool open(DocumentNode node) {
    open_.push_back(std::move(node));
    keys_.emplace_back();
    return open_.size() <= kDeepestDocument;
  }
  bool close() {
    DocumentNode whole = std::move(open_.back());
    open_.pop_back();
    keys_.pop_back();
    return put(std::move(whole));
  }

  std::vector<DocumentNode> open_;
  std::vector<std::string> keys_;  ///< the member to come, of each that is open
  std::size_t broken_at_ = 0;
};

}  // namespace

Result<DocumentNode> parse_toml_document(std::string_view text, const std::string& name) {
  try {
    return from_toml(toml::parse(text, std::string_view(name)), 0);
  } catch (const toml::parse_error& error) {
    const auto begin = error.source().begin;
    return fail(Error::Code::kMalformed, "{}:{}:{}: {}", name, begin.line, begin.column,
                error.description());
  }
}

Result<DocumentNode> parse_json_document(std::string_view text, const std::string& name) {
  DocumentHandler handler;
  if (nlohmann::json::sax_parse(text, &handler)) return std::move(handler.root);
  return fail(Error::Code::kMalformed, "{}: byte {}: this is no JSON, or it is cut off", name,
              handler.broken_at());
}

}  // namespace scanfuse::io
