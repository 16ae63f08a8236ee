#pragma once

#include <fmt/format.h>

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace scanfuse {

/// What went wrong, in words a user can act on: "scan.pcd:9: FIELDS names 4 columns, SIZE 3".
struct Error {
  enum class Code { kNotFound, kMalformed, kUnsupported, kOutOfRange };
  Code code = Code::kMalformed;
  std::string message;
};

/// A value, or the reason why there is none. The library throws nothing of its own.
template <class T>
using Result = tl::expected<T, Error>;

/// Builds the failed side of a Result: `return fail(Error::Code::kNotFound, "{}: no such file",
/// path);`
template <class... Args>
[[nodiscard]] tl::unexpected<Error> fail(Error::Code code, fmt::format_string<Args...> text,
                                         Args&&... args) {
  return tl::unexpected(Error{code, fmt::format(text, std::forward<Args>(args)...)});
}

}  // namespace scanfuse
