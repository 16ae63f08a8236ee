#include "scanfuse/io/cloud/cloud_notes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "scanfuse/core/options.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kMostProfiles = 1'000'000;

std::string_view next_word(std::string_view& text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end);
  return word;
}

bool take_profile(std::string_view text, Cloud& cloud) {
  const auto index = parse_whole(next_word(text));
  double values[8];
  for (double& value : values) {
    const auto number = parse_number(next_word(text));
    if (!number || std::abs(*number) > kFarthestCoordinate_m) return false;
    value = *number;
  }
  // In order and one by one: a file cannot ask for more memory than it has lines.
  if (!index || static_cast<std::size_t>(*index) != cloud.profiles.size()) return false;
  const Eigen::Quaterniond rotation(values[4], values[5], values[6], values[7]);
  if (!(std::abs(rotation.norm() - 1) < 1e-3) || cloud.profiles.size() >= kMostProfiles) {
    return false;
  }
  cloud.profiles.push_back({values[0], {rotation.normalized(), {values[1], values[2], values[3]}}});
  return true;
}

}  // namespace

std::string cloud_notes(const Cloud& cloud, std::string_view lead) {
  std::string text =
      fmt::format("{}scanfuse frame {}\n", lead, scanfuse::detail::print(cloud.frame));
  for (std::size_t k = 0; k < cloud.profiles.size(); ++k) {
    const CloudProfile& profile = cloud.profiles[k];
    const auto& t = profile.cloud_from_lidar.translation_m;
    const auto& q = profile.cloud_from_lidar.rotation;
    text += fmt::format("{}scanfuse profile {} {} {} {} {} {} {} {} {}\n", lead, k,
                        print_number(profile.turntable_rad), print_number(t.x()),
                        print_number(t.y()), print_number(t.z()), print_number(q.w()),
                        print_number(q.x()), print_number(q.y()), print_number(q.z()));
  }
  return text;
}

bool take_cloud_note(std::string_view comment, Cloud& cloud) {
  if (next_word(comment) != "scanfuse") return true;
  const std::string_view what = next_word(comment);
  if (what == "profile") return take_profile(comment, cloud);
  if (what != "frame") return true;
  const auto frame = scanfuse::detail::parse<CloudFrame>(next_word(comment));
  if (frame) cloud.frame = *frame;
  return frame.has_value();
}

void settle_profiles(Cloud& cloud) {
  const int count = static_cast<int>(cloud.profiles.size());
  for (CloudPoint& point : cloud.points) {
    if (point.profile >= 0 && point.profile < count && point.beam >= 0) continue;
    point.profile = point.beam = -1;
  }
  std::ranges::stable_sort(cloud.points, [](const CloudPoint& a, const CloudPoint& b) {
    return std::tie(a.profile, a.beam) < std::tie(b.profile, b.beam);
  });
}

}  // namespace scanfuse::io
