#include "scanfuse/evaluate/hota.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "scanfuse/core/assignment.hpp"
#include "scanfuse/evaluate/clear.hpp"

namespace scanfuse::evaluate {
namespace {

constexpr double kHotaRounding = std::numeric_limits<double>::epsilon();

/// In how many frames each id stands, and how well each pair of ids aligns over all frames.
struct GlobalAlignment {
  Eigen::VectorXd truth_count;
  Eigen::VectorXd track_count;
  Eigen::MatrixXd score;  ///< truth ids x track ids, Jaccard index of the soft overlap

  [[nodiscard]] double jaccard(int truth, int track, double overlap) const {
    return overlap / std::max(1.0, truth_count[truth] + track_count[track] - overlap);
  }
};

/// Each pair's similarity, as a share of all that the two could have been paired with.
Eigen::MatrixXd soft_overlap(const Eigen::MatrixXd& similar) {
  Eigen::MatrixXd share = similar;
  if (share.size() == 0) return share;
  const Eigen::VectorXd rows = similar.rowwise().sum();
  const Eigen::RowVectorXd columns = similar.colwise().sum();
  for (int i = 0; i < share.rows(); ++i) {
    for (int j = 0; j < share.cols(); ++j) {
      const double whole = rows[i] + columns[j] - similar(i, j);
      share(i, j) = whole > kHotaRounding ? similar(i, j) / whole : 0;
    }
  }
  return share;
}

GlobalAlignment global_alignment(const Sequence& sequence, const EvaluateOptions& options) {
  const auto truths = static_cast<long>(sequence.truth_ids.size());
  const auto tracks = static_cast<long>(sequence.track_ids.size());
  GlobalAlignment all{Eigen::VectorXd::Zero(truths), Eigen::VectorXd::Zero(tracks),
                      Eigen::MatrixXd::Zero(truths, tracks)};
  for (const auto& frame : sequence.frames) {
    for (const int i : frame.truth_index) all.truth_count[i] += 1;
    for (const int j : frame.track_index) all.track_count[j] += 1;
    const Eigen::MatrixXd share = soft_overlap(similarity(frame, options));
    for (int i = 0; i < share.rows(); ++i) {
      for (int j = 0; j < share.cols(); ++j) {
        all.score(frame.truth_index[i], frame.track_index[j]) += share(i, j);
      }
    }
  }
  for (int i = 0; i < truths; ++i) {
    for (int j = 0; j < tracks; ++j) {
      all.score(i, j) /= all.truth_count[i] + all.track_count[j] - all.score(i, j);
    }
  }
  return all;
}

/// What one threshold has matched so far.
struct AlphaCount {
  double matches = 0;
  double similarity_sum = 0;
  std::map<std::pair<int, int>, double> together;  ///< frames by (truth id, track id)
};

void count_frame(const ScoredFrame& frame, const GlobalAlignment& all,
                 const EvaluateOptions& options, std::array<HotaAtAlpha, 19>& alphas,
                 std::array<AlphaCount, 19>& counts) {
  const Eigen::MatrixXd similar = similarity(frame, options);
  Eigen::MatrixXd cost = similar;
  for (int i = 0; i < cost.rows(); ++i) {
    for (int j = 0; j < cost.cols(); ++j) {
      cost(i, j) *= -all.score(frame.truth_index[i], frame.track_index[j]);
    }
  }
  const auto columns = solve_assignment(cost);
  for (int i = 0; i < cost.rows(); ++i) {
    if (columns[i] < 0) continue;
    const double s = similar(i, columns[i]);
    for (std::size_t a = 0; a < alphas.size(); ++a) {
      if (s < alphas[a].alpha - kHotaRounding) break;
      counts[a].matches += 1;
      counts[a].similarity_sum += s;
      counts[a].together[{frame.truth_index[i], frame.track_index[columns[i]]}] += 1;
    }
  }
}

void finish_alpha(HotaAtAlpha& at, const AlphaCount& count, const GlobalAlignment& all) {
  const double both = all.truth_count.sum() + all.track_count.sum();
  double association = 0;
  for (const auto& [ids, frames] : count.together) {
    association += frames * all.jaccard(ids.first, ids.second, frames);
  }
  at.det_a = count.matches / std::max(1.0, both - count.matches);
  at.ass_a = association / std::max(1.0, count.matches);
  at.hota = std::sqrt(at.det_a * at.ass_a);
  if (count.matches > 0) at.loc_a = count.similarity_sum / count.matches;
}

}  // namespace

HotaMetrics hota_metrics(const Sequence& sequence, const EvaluateOptions& options) {
  HotaMetrics metrics;
  if (sequence.truth_ids.empty() && sequence.track_ids.empty()) return metrics;
  const auto all = global_alignment(sequence, options);
  std::array<AlphaCount, 19> counts;
  for (std::size_t a = 0; a < counts.size(); ++a) {
    metrics.by_alpha[a].alpha = 0.05 * static_cast<double>(a + 1);
  }
  for (const auto& frame : sequence.frames) {
    count_frame(frame, all, options, metrics.by_alpha, counts);
  }
  const auto mean = [&](double HotaAtAlpha::* member) {
    double sum = 0;
    for (const auto& at : metrics.by_alpha) sum += at.*member;
    return sum / static_cast<double>(metrics.by_alpha.size());
  };
  for (std::size_t a = 0; a < counts.size(); ++a) finish_alpha(metrics.by_alpha[a], counts[a], all);
  metrics.hota = mean(&HotaAtAlpha::hota);
  metrics.det_a = mean(&HotaAtAlpha::det_a);
  metrics.ass_a = mean(&HotaAtAlpha::ass_a);
  if (counts[0].matches > 0) metrics.loc_a = mean(&HotaAtAlpha::loc_a);
  return metrics;
}

}  // namespace scanfuse::evaluate
