#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "scanfuse/drivers/ros2/ros2_bus.hpp"

namespace scanfuse::drivers {
namespace {

constexpr int kLastDomain = 232;  ///< ports of higher ones would pass 65535 [RTPS 9.6.1]

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace

Result<std::string> ros2_topic_name(const std::string& text) {
  std::string name = text.starts_with('/') ? text : "/" + text;
  char before = '\0';
  bool good = name.size() > 1 && name.size() <= 248 && name.back() != '/';
  for (const char c : name) {
    good = good && (is_letter(c) || c == '_' || c == '/' || is_digit(c));
    good = good && !(before == '/' && (c == '/' || is_digit(c))) && !(before == '_' && c == '_');
    before = c;
  }
  if (good) return name;
  return fail(Error::Code::kMalformed,
              "topic '{}': ROS 2 takes letters, digits, _ and / only, no part that begins with a "
              "digit, and nothing empty, as /front/scan",
              text);
}

std::string dds_type_name(const std::string& ros_type) {
  std::string name = ros_type;
  const auto last = name.rfind('/');
  if (last == std::string::npos) return name;
  name.insert(last + 1, "dds_/");
  replace_all(name, "/", "::");
  return name + "_";
}

std::string ros2_type_name(const std::string& dds_type) {
  std::string name = dds_type;
  const auto inner = name.find("::dds_::");
  if (inner == std::string::npos || !name.ends_with('_')) return name;
  name.pop_back();
  name.erase(inner, std::string_view("::dds_").size());
  replace_all(name, "::", "/");
  return name;
}

Result<int> ros2_domain() {
  const char* text = std::getenv("ROS_DOMAIN_ID");
  if (text == nullptr || *text == '\0') return 0;
  const std::string_view view(text);
  int domain = -1;
  const auto [end, error] = std::from_chars(view.data(), view.data() + view.size(), domain);
  if (error != std::errc{} || end != view.data() + view.size() || domain < 0 ||
      domain > kLastDomain) {
    return fail(Error::Code::kOutOfRange, "ROS_DOMAIN_ID '{}': is no number from 0 to {}", view,
                kLastDomain);
  }
  return domain;
}

}  // namespace scanfuse::drivers
