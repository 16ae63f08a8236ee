#include "scanfuse/serve/assets.hpp"

// Set by bundle.S.in: where the packed files begin and end.
extern "C" {
extern const std::byte scanfuse_bundle_html[];
extern const std::byte scanfuse_bundle_html_end[];
extern const std::byte scanfuse_bundle_js[];
extern const std::byte scanfuse_bundle_js_end[];
extern const std::byte scanfuse_bundle_css[];
extern const std::byte scanfuse_bundle_css_end[];
}

namespace scanfuse::serve {
namespace {

std::span<const std::byte> between(const std::byte* begin, const std::byte* end) {
  return {begin, end};
}

}  // namespace

std::optional<Asset> find_asset(std::string_view path) {
  if (path == "/" || path == "/index.html") {
    return Asset{"text/html; charset=utf-8",
                 between(scanfuse_bundle_html, scanfuse_bundle_html_end)};
  }
  if (path == "/viewer.js") {
    return Asset{"text/javascript; charset=utf-8",
                 between(scanfuse_bundle_js, scanfuse_bundle_js_end)};
  }
  if (path == "/viewer.css") {
    return Asset{"text/css; charset=utf-8", between(scanfuse_bundle_css, scanfuse_bundle_css_end)};
  }
  return std::nullopt;
}

}  // namespace scanfuse::serve
