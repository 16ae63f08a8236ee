#include "scanfuse/serve/http_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <random>

namespace scanfuse::serve {
namespace {

constexpr std::string_view kCookieName = "scanfuse_token=";

/// Takes as long for a wrong token as for the right one.
bool same_secret(std::string_view given, std::string_view wanted) {
  if (given.size() != wanted.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    difference |= static_cast<unsigned>(static_cast<unsigned char>(given[i]) ^
                                        static_cast<unsigned char>(wanted[i]));
  }
  return difference == 0;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// Calls `visit` with every part between separators, without blanks around it.
template <class Visit>
void for_each_part(std::string_view text, char separator, Visit&& visit) {
  while (!text.empty()) {
    const auto end = std::min(text.find(separator), text.size());
    visit(trimmed(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::string_view token_of_cookie(std::string_view cookie) {
  std::string_view found;
  for_each_part(cookie, ';', [&](std::string_view part) {
    if (part.starts_with(kCookieName)) found = part.substr(kCookieName.size());
  });
  return found;
}

bool brings_token(const AccessRules& rules, const RequestHead& head) {
  constexpr std::string_view kBearer = "Bearer ";
  const auto bearer = head.authorization.starts_with(kBearer)
                          ? head.authorization.substr(kBearer.size())
                          : std::string_view{};
  return brings_token_in_query(rules, head) ||
         same_secret(token_of_cookie(head.cookie), rules.token) || same_secret(bearer, rules.token);
}

std::string_view host_name(std::string_view host) {
  if (host.starts_with('[')) return host.substr(0, std::min(host.find(']') + 1, host.size()));
  return host.substr(0, host.find(':'));
}

bool is_loopback_host(std::string_view host) {
  const auto name = host_name(host);
  return name == "localhost" || name == "127.0.0.1" || name == "[::1]";
}

bool is_own_origin(std::string_view origin, std::string_view host) {
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (origin.starts_with(scheme) && !host.empty() && origin.substr(scheme.size()) == host) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::string_view path_of(std::string_view target) {
  if (!target.starts_with('/')) return {};
  return target.substr(0, target.find_first_of("?#"));
}

std::string_view token_of_query(std::string_view target) {
  const auto question = target.find('?');
  if (question == target.npos) return {};
  std::string_view found;
  for_each_part(target.substr(question + 1), '&', [&](std::string_view part) {
    if (part.starts_with("token=")) found = part.substr(6);
  });
  return found;
}

bool brings_token_in_query(const AccessRules& rules, const RequestHead& head) {
  return !rules.token.empty() && same_secret(token_of_query(head.target), rules.token);
}

Refusal check_request(const AccessRules& rules, const RequestHead& head) {
  if (head.method != "GET" && head.method != "HEAD") return {405, "only GET and HEAD"};
  if (rules.loopback && !is_loopback_host(head.host)) {
    return {403,
            "this server answers to localhost only; to reach it from elsewhere, start it with "
            "--listen"};
  }
  if (!rules.token.empty() && !brings_token(rules, head)) {
    return {401, "a token is needed: open the address that `scanfuse view` printed"};
  }
  return {};
}

Refusal check_websocket(const AccessRules& rules, const RequestHead& head) {
  if (const Refusal refusal = check_request(rules, head); refusal.status != 0) return refusal;
  if (head.origin.empty() || is_own_origin(head.origin, head.host)) return {};
  const auto& allowed = rules.allowed_origins;
  if (std::find(allowed.begin(), allowed.end(), head.origin) != allowed.end()) return {};
  return {403, "pages of this origin may not connect; start scanfuse with --allow-origin"};
}

bool is_loopback_address(std::string_view address) {
  return address == "::1" || address == "localhost" || address.starts_with("127.");
}

std::string random_token() {
  std::random_device source;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", static_cast<std::uint32_t>(source()));
  return token;
}

bool is_foxglove(std::string_view protocol) {
  return std::ranges::find(kFoxgloveProtocols, protocol) != std::end(kFoxgloveProtocols);
}

std::string_view choose_protocol(std::string_view offered) {
  std::string_view chosen;
  for_each_part(offered, ',', [&](std::string_view part) {
    if (!chosen.empty()) return;
    if (part == kViewerProtocol || is_foxglove(part)) chosen = part;
  });
  return chosen;
}

}  // namespace scanfuse::serve
