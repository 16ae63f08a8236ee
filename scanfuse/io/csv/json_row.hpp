#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scanfuse::io {

/// Takes one flat JSON object apart: the texts of its members named `names`, numbers as they stand
/// in the text (so that nanoseconds survive), null and absent ones empty. False where the line is
/// no JSON object. Members that are objects or arrays are passed over.
[[nodiscard]] bool split_json(std::string_view line, const std::vector<std::string>& names,
                              std::vector<std::string>& texts);

}  // namespace scanfuse::io
