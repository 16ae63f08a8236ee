#include "scanfuse/io/csv/json_row.hpp"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace scanfuse::io {
namespace {

/// Receives the parser's events and keeps the wanted members of the outermost object.
class JsonRowHandler {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  JsonRowHandler(const std::vector<std::string>& names, std::vector<std::string>& texts)
      : names_(names), texts_(texts) {}

  bool null() { return take(""); }
  bool boolean(bool value) { return take(value ? "1" : "0"); }
  bool number_integer(number_integer_t value) { return take(std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) { return take(std::to_string(value)); }
  bool number_float(number_float_t, const string_t& text) { return take(text); }
  bool string(string_t& value) { return take(value); }
  bool binary(binary_t&) { return false; }
  bool start_object(std::size_t) { return ++depth_ < 64; }
  bool end_object() { return depth_-- > 0; }
  bool start_array(std::size_t size) { return depth_ > 0 && start_object(size); }
  bool end_array() { return depth_-- > 0; }
  bool key(string_t& name) {
    if (depth_ != 1) return true;
    const auto found = std::find(names_.begin(), names_.end(), name);
    place_ = found == names_.end() ? -1 : found - names_.begin();
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) {
    return false;
  }

 private:
  bool take(std::string text) {
    if (depth_ == 0) return false;
    if (depth_ == 1 && place_ >= 0) texts_[static_cast<std::size_t>(place_)] = std::move(text);
    return true;
  }

  const std::vector<std::string>& names_;
  std::vector<std::string>& texts_;
  std::ptrdiff_t place_ = -1;
  int depth_ = 0;
};

}  // namespace

bool split_json(std::string_view line, const std::vector<std::string>& names,
                std::vector<std::string>& texts) {
  texts.assign(names.size(), "");
  JsonRowHandler handler(names, texts);
  return nlohmann::json::sax_parse(line, &handler);
}

}  // namespace scanfuse::io
