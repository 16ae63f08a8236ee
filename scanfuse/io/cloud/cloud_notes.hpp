#pragma once

#include <string>
#include <string_view>

#include "scanfuse/types/cloud.hpp"

namespace scanfuse::io {

/// The comments of a cloud's header, each line begun with `lead` ("comment " or "# ").
[[nodiscard]] std::string cloud_notes(const Cloud& cloud, std::string_view lead);

/// Takes one comment (without its lead) into the cloud; others than ours are passed over. False
/// where one of ours cannot be understood.
[[nodiscard]] bool take_cloud_note(std::string_view comment, Cloud& cloud);

/// Brings points and profiles into agreement: points of profiles that are not there lose them.
void settle_profiles(Cloud& cloud);

}  // namespace scanfuse::io
