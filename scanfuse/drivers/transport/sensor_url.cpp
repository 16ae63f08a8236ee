#include "scanfuse/drivers/transport/sensor_url.hpp"

#include <array>
#include <charconv>
#include <vector>

#include "scanfuse/core/options.hpp"

namespace scanfuse::drivers {
namespace {

constexpr std::string_view kForm =
    "write e.g. sick://192.168.0.1:2112?name=front, vlp16://:2368 or rplidar:///dev/ttyUSB0";

tl::unexpected<Error> wrong(std::string_view text, std::string_view why) {
  return fail(Error::Code::kMalformed, "sensor '{}': {}; {}", text, why, kForm);
}

/// "a=b&c=d"
Result<void> read_query(std::string_view text, std::string_view query, SensorUrl& url) {
  static const std::vector<std::string> known{"name", "mount", "baud", "metadata"};
  while (!query.empty()) {
    const std::string_view pair = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(pair.size() + 1, query.size()));
    const auto equals = pair.find('=');
    if (equals == pair.npos) return wrong(text, "what follows the ? is key=value&key=value");
    const std::string key(pair.substr(0, equals));
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      return wrong(
          text, fmt::format("unknown key '{}'; did you mean '{}'?", key, nearest_name(key, known)));
    }
    url.query[key] = pair.substr(equals + 1);
  }
  return {};
}

/// "host:port", "host", ":port", "[::1]:port" or nothing.
Result<void> read_authority(std::string_view text, std::string_view authority, SensorUrl& url) {
  const auto bracket = authority.rfind(']');
  const auto colon = authority.rfind(':');
  const bool has_port = colon != authority.npos && (bracket == authority.npos || colon > bracket);
  std::string_view host = authority.substr(0, has_port ? colon : authority.size());
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  url.host = host;
  url.port = url.device->port;
  if (!has_port) return {};
  const std::string_view port = authority.substr(colon + 1);
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), url.port);
  if (error != std::errc{} || end != port.data() + port.size() || url.port < 0 ||
      url.port > 65535) {
    return wrong(text, fmt::format("'{}' is no port of 0 to 65535", port));
  }
  return {};
}

}  // namespace

std::string SensorUrl::name() const {
  const auto named = query.find("name");
  return named != query.end() && !named->second.empty() ? named->second
                                                        : std::string(device->scheme);
}

Result<SensorUrl> parse_sensor_url(std::string_view text) {
  const auto scheme_end = text.find("://");
  if (scheme_end == text.npos) return wrong(text, "no scheme such as sick:// in front");
  const auto device = find_device(text.substr(0, scheme_end));
  if (!device) return tl::unexpected(device.error());
  SensorUrl url;
  url.device = *device;
  std::string_view rest = text.substr(scheme_end + 3);
  if (const auto mark = rest.find('?'); mark != rest.npos) {
    if (auto done = read_query(text, rest.substr(mark + 1), url); !done) {
      return tl::unexpected(done.error());
    }
    rest = rest.substr(0, mark);
  }
  if (url.device->link == Link::kSerial) {
    if (!rest.starts_with('/')) return wrong(text, "a serial device needs a path");
    url.path = rest;
    return url;
  }
  if (rest.find('/') != rest.npos) return wrong(text, "a network device has no path");
  if (auto done = read_authority(text, rest, url); !done) return tl::unexpected(done.error());
  if (url.host.empty()) url.host = url.device->link == Link::kTcp ? "127.0.0.1" : "0.0.0.0";
  return url;
}

Result<SensorUrl> parse_serve_address(std::string_view text) {
  const auto colon = text.find(':');
  const auto device = find_device(text.substr(0, colon));
  if (!device) return tl::unexpected(device.error());
  const std::string_view rest = colon == text.npos ? "" : text.substr(colon + 1);
  SensorUrl url;
  url.device = *device;
  if (url.device->link == Link::kSerial) {
    url.path = rest;
    return url;
  }
  const bool only_port =
      !rest.empty() && rest.find_first_not_of("0123456789") == std::string_view::npos;
  const std::string authority = only_port ? ":" + std::string(rest) : std::string(rest);
  if (auto done = read_authority(text, authority, url); !done) return tl::unexpected(done.error());
  if (url.host.empty()) url.host = "127.0.0.1";
  return url;
}

}  // namespace scanfuse::drivers
