#include "scanfuse/calibrate/prepare.hpp"

#include <algorithm>
#include <optional>

#include "scanfuse/core/parallel.hpp"

namespace scanfuse::calibrate {
namespace {

Result<void> check_camera(const Camera& camera) {
  const double numbers[] = {camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px, camera.k1,
                            camera.k2,    camera.p1,    camera.p2,    camera.k3};
  const bool finite = std::all_of(std::begin(numbers), std::end(numbers),
                                  [](double x) { return std::isfinite(x); });
  if (finite && camera.fx_px > 0 && camera.fy_px > 0) return {};
  return fail(Error::Code::kOutOfRange,
              "the camera's focal lengths must be above 0 and its numbers finite");
}

/// A position's stripes and V, whatever the order of the boards.
struct Seen {
  std::array<StripeLine, 2> stripes;
  VLines v;
};

Result<Seen> see(const TurntableFeatures& features, const std::array<BoardPose, 2>& boards,
                 const TurntablePosition& position) {
  if (!std::isfinite(position.turntable_rad)) {
    return fail(Error::Code::kMalformed, "its turntable angle is not a number");
  }
  auto stripes = stripe_lines(features.camera, position);
  if (!stripes) return tl::unexpected(stripes.error());
  auto v = v_lines(features.camera, features.boards, boards, *stripes);
  if (!v) return tl::unexpected(v.error());
  return Seen{std::move(*stripes), *v};
}

Result<Sample> sample_of(const TurntableFeatures& features, const std::array<BoardPose, 2>& boards,
                         std::size_t index, const Seen& seen, BoardOrder order, bool literal) {
  const TurntablePosition& position = features.positions[index];
  auto returns = find_board_returns(seen.v, position.scan, order);
  if (!returns) return tl::unexpected(returns.error());
  Sample sample{index, position.turntable_rad, seen.stripes, std::move(*returns), {}, {}};
  const auto locate = literal ? pose_liu2023 : pose_exact;
  auto pose = locate(features.camera, features.boards, boards, sample.stripes, sample.returns);
  if (!pose) return tl::unexpected(pose.error());
  sample.pose = *pose;
  for (std::size_t b = 0; b < 2; ++b) {
    const auto line = fit_returns(sample.returns.on_board[b]);
    if (!line) {
      return fail(Error::Code::kMalformed, "the returns of board {} make no line", b + 1);
    }
    sample.lines[b] = *line;
  }
  return sample;
}

struct Attempt {
  std::vector<Sample> samples;
  std::vector<std::string> reasons;
  std::optional<MotionFit> motion;
  Error why;  ///< where there is no motion
};

Attempt attempt(const TurntableFeatures& features, const std::array<BoardPose, 2>& boards,
                const std::vector<Result<Seen>>& seen, BoardOrder order, bool literal) {
  Attempt out;
  const std::size_t count = seen.size();
  std::vector<std::optional<Result<Sample>>> found(count);
  parallel_for(count, 0, [&](std::size_t i) {
    if (seen[i]) found[i] = sample_of(features, boards, i, *seen[i], order, literal);
  });
  for (std::size_t i = 0; i < count; ++i) {
    out.reasons.push_back(!seen[i]     ? seen[i].error().message
                          : !*found[i] ? found[i]->error().message
                                       : "");
    if (out.reasons.back().empty()) out.samples.push_back(std::move(**found[i]));
  }
  if (out.samples.size() < 3) {
    std::string first = "no positions were given";
    for (std::size_t i = 0; i < count; ++i) {
      if (out.reasons[i].empty()) continue;
      first = fmt::format("{}: {}", features.positions[i].name, out.reasons[i]);
      break;
    }
    out.why = {Error::Code::kOutOfRange,
               fmt::format("{} of {} positions are usable and 3 are needed; {}", out.samples.size(),
                           count, first)};
    return out;
  }
  auto motion = rig_closed_form(poses_of(out.samples));
  if (motion) {
    out.motion = std::move(*motion);
  } else {
    out.why = motion.error();
  }
  return out;
}

/// How much better the motion fits one order than the other: above 1 the first is better.
double preference(const Attempt& first, const Attempt& second) {
  if (!first.motion || !second.motion) return first.motion ? 1e9 : second.motion ? 1e-9 : 1;
  const auto misfit = [](const MotionFit& fit) {
    return (fit.rotation_median_rad + 1e-9) * (fit.centre_median_m + 1e-9);
  };
  return misfit(*second.motion) / misfit(*first.motion);
}

Result<void> check_turns(const MotionFit& motion, const TurntableOptions& options) {
  const double arc = motion.rig.last_turntable_rad - motion.rig.first_turntable_rad;
  const double unsure = 6 * motion.rotation_median_rad / arc;
  const double off = std::abs(motion.turn_ratio - 1);
  const bool free = options.angle_scale != Systematic::kOff;
  if (off < (free ? 0.5 : 0.2) + unsure) return {};
  return fail(Error::Code::kOutOfRange,
              "the lidar turned {:.4g} times as far as the turntable's angles say; are they in "
              "degrees, and is there a gear? Is the order of the boards in the scan right?",
              motion.turn_ratio);
}

}  // namespace

std::vector<TurnedPose> poses_of(const std::vector<Sample>& samples) {
  std::vector<TurnedPose> poses;
  for (const auto& sample : samples) {
    poses.push_back({sample.turntable_rad, sample.pose.camera_from_lidar});
  }
  return poses;
}

Result<Prepared> prepare(const TurntableFeatures& features, const TurntableOptions& options) {
  const bool literal = options.method == TurntableMethod::kLiu2023;
  if (auto fine = check_camera(features.camera); !fine) return tl::unexpected(fine.error());
  const auto boards = board_poses(features, literal ? PoseMethod::kLiu2023 : PoseMethod::kExact);
  if (!boards) return tl::unexpected(boards.error());
  std::vector<std::optional<Result<Seen>>> slots(features.positions.size());
  parallel_for(slots.size(), 0,
               [&](std::size_t i) { slots[i] = see(features, *boards, features.positions[i]); });
  std::vector<Result<Seen>> seen;
  for (auto& slot : slots) seen.push_back(std::move(*slot));

  const auto run = [&](BoardOrder order) {
    return attempt(features, *boards, seen, order, literal);
  };
  const bool open = options.first_board == FirstBoard::kAutomatic;
  Attempt best = run(options.first_board == FirstBoard::kDescending ? BoardOrder::kDescending
                                                                    : BoardOrder::kAscending);
  Prepared out;
  out.ascending = options.first_board != FirstBoard::kDescending;
  if (open) {
    Attempt other = run(BoardOrder::kDescending);
    const double better = preference(best, other);
    out.decided = better > 1.5 || better < 1 / 1.5;
    if (better < 1 / 1.5) {
      best = std::move(other);
      out.ascending = false;
    }
  }
  if (!best.motion) return tl::unexpected(best.why);
  if (auto fine = check_turns(*best.motion, options); !fine) return tl::unexpected(fine.error());
  out.boards = *boards;
  out.samples = std::move(best.samples);
  out.reasons = std::move(best.reasons);
  out.motion = std::move(*best.motion);
  return out;
}

}  // namespace scanfuse::calibrate
