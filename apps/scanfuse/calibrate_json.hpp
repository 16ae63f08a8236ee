#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scanfuse/calibrate/turntable.hpp"
#include "scanfuse/pipeline/turntable_session.hpp"

namespace scanfuse::app {

/// What `calibrate turntable --json` prints.
[[nodiscard]] nlohmann::json calibration_json(const calibrate::TurntableCalibration& calibration,
                                              const pipeline::LoadedSession& session);

/// Why a position was left out, from reading it or from calibrating; empty where it was used.
[[nodiscard]] std::string reason_of(const calibrate::TurntableCalibration& calibration,
                                    const pipeline::LoadedSession& session, std::size_t position);

}  // namespace scanfuse::app
