#include "associate_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "command.hpp"
#include "scanfuse/evaluate/association_score.hpp"

namespace scanfuse::app {
namespace {

using report::Chart;
using report::ReportTable;
using report::Series;
using triangulate::AssociationOptions;
using triangulate::ScanAssociation;

constexpr std::size_t kShownScans = 3;
constexpr std::size_t kRows = 200;  ///< of a table
constexpr std::size_t kShownLines = 2000;

bool has_truth(const BearingScan& scan) {
  return std::ranges::any_of(scan.bearings, [](const Bearing& b) { return b.truth.has_value(); });
}

std::string yes(bool value) { return value ? "yes" : "no"; }

/// "The first 200 of 1000." where a table was cut.
std::string cut_note(std::size_t all) {
  return all > kRows ? fmt::format("The first {} of {}. ", kRows, all) : std::string();
}

report::PassiveView view_of(const BearingScan& scan, const PassiveScene& scene,
                            const ScanAssociation& found, const PassiveTruth& truth) {
  report::PassiveView view;
  view.fixes = found.fixes;
  const auto lines = triangulate::lines_of_sight(scan, scene);
  const std::size_t stride =
      std::max<std::size_t>(1, (lines.size() + kShownLines - 1) / kShownLines);
  for (std::size_t i = 0; i < lines.size(); i += stride) {
    view.lines.push_back({lines[i].origin_m, lines[i].direction, found.target_of_bearing[i]});
  }
  if (has_truth(scan)) {
    for (const Fix& fix : found.fixes) view.ghosts.push_back(!evaluate::origin_of(scan, fix));
  }
  if (const auto at = truth.find(scan.scan); at != truth.end()) view.truth_m = at->second;
  return view;
}

ReportTable fix_table(const BearingScan& scan, const PassiveScene& scene,
                      const ScanAssociation& found, const report::PassiveView& view) {
  ReportTable table{"Fixes",
                    {"target", "x [m]", "y [m]", "z [m]", "sigma x", "sigma y", "sigma z",
                     "exists with", "chi2 / dof", "bearings"},
                    {}};
  if (!view.ghosts.empty()) table.columns.emplace_back("ghost");
  for (std::size_t k = 0; k < std::min(kRows, found.fixes.size()); ++k) {
    const Fix& fix = found.fixes[k];
    const Eigen::Array3d sigma = fix.covariance_m2.diagonal().array().max(0).sqrt();
    table.rows.push_back(
        {fmt::format("{}", fix.target), fmt::format("{:.1f}", fix.position_m.x()),
         fmt::format("{:.1f}", fix.position_m.y()), fmt::format("{:.1f}", fix.position_m.z()),
         fmt::format("{:.3g}", sigma.x()), fmt::format("{:.3g}", sigma.y()),
         fmt::format("{:.3g}", sigma.z()), fmt::format("{:.3f}", fix.existence_probability),
         fmt::format("{:.2f} / {}", fix.chi2, fix.degrees_of_freedom),
         bearing_names(scan, scene, fix.bearings)});
    if (!view.ghosts.empty()) table.rows.back().push_back(view.ghosts[k] ? "ghost" : "");
  }
  table.note = cut_note(found.fixes.size()) + "Bearings: sensor and number of the measurement.";
  return table;
}

/// The components with the largest gap, then the largest ones.
ReportTable component_table(const associate::PackingSolution& solution) {
  std::vector<const associate::PackingComponent*> order;
  order.reserve(solution.components.size());
  for (const auto& component : solution.components) order.push_back(&component);
  std::ranges::stable_sort(order, [](const auto* a, const auto* b) {
    return std::pair(a->dual - a->primal, a->columns.size()) >
           std::pair(b->dual - b->primal, b->columns.size());
  });
  ReportTable table{"Solver: independent parts",
                    {"part", "bearings", "hypotheses", "primal", "dual", "gap", "proved"},
                    {}};
  constexpr std::size_t kParts = 12;
  for (std::size_t k = 0; k < std::min(kParts, order.size()); ++k) {
    const auto& c = *order[k];
    table.rows.push_back({fmt::format("{}", k + 1), fmt::format("{}", c.rows.size()),
                          fmt::format("{}", c.columns.size()), fmt::format("{:.4f}", c.primal),
                          fmt::format("{:.4f}", c.dual),
                          fmt::format("{:.2g}", std::max(0.0, c.dual - c.primal)), yes(c.proved)});
  }
  table.note = fmt::format(
      "Parts that share no bearing: {}; those with the largest gap, then the largest. Together: "
      "primal {:.4f}, dual {:.4f}; no association weighs more than the dual.",
      order.size(), solution.primal, solution.dual);
  return table;
}

Chart convergence_chart(const associate::PackingSolution& solution) {
  Series primal{"primal: found", {}, Series::Style::kLine};
  Series dual{"dual: no more is possible", {}, Series::Style::kDashed};
  const auto& rounds = solution.diagnostics.rounds;
  for (std::size_t k = 0; k < rounds.size(); ++k) {
    primal.points.emplace_back(static_cast<double>(k), rounds[k].primal);
    dual.points.emplace_back(static_cast<double>(k), rounds[k].dual);
  }
  return {"The solver's convergence, all parts", "round", "weight [nats]", {primal, dual}};
}

ReportTable ranking_table(const BearingScan& scan, const PassiveScene& scene,
                          const ScanAssociation& found, const associate::PackingRanking& ranking) {
  ReportTable table{"The best associations",
                    {"place", "weight", "behind the best", "targets", "not in the best"},
                    {}};
  const auto& packings = ranking.packings;
  for (std::size_t k = 0; k < std::min(kRows, packings.size()); ++k) {
    std::vector<std::int32_t> fresh;
    std::ranges::set_difference(packings[k].chosen, packings[0].chosen, std::back_inserter(fresh));
    std::string others;
    for (const auto column : fresh) {
      others += (others.empty() ? "" : "; ") +
                bearing_names(scan, scene, found.packing.column(static_cast<std::size_t>(column)));
    }
    table.rows.push_back({fmt::format("{}", k + 1), fmt::format("{:.4f}", packings[k].weight),
                          fmt::format("{:.4f}", packings[0].weight - packings[k].weight),
                          fmt::format("{}", packings[k].chosen.size()), others});
  }
  table.note = cut_note(packings.size()) +
               (ranking.exact ? "No association that is missing weighs more than the last."
                              : "Not exact: better ones may be missing.");
  return table;
}

/// What every cost makes of the same scan.
ReportTable cost_table(const BearingScan& scan, const PassiveScene& scene,
                       const AssociationOptions& options, int threads) {
  ReportTable table{"Costs on this scan",
                    {"cost", "targets", "primal", "dual", "proved", "hypotheses", "seconds"},
                    {}};
  const bool judged = has_truth(scan);
  if (judged) {
    table.columns.insert(table.columns.end(), {"exact", "of", "ghosts"});
  }
  AssociationOptions each = options;
  each.posterior = false;
  each.time_limit_s = std::min(options.time_limit_s, 10.0);
  for (const auto& [name, method] : choices(triangulate::CostMethod{})) {
    if (interrupted) break;
    each.cost = method;
    const auto start = std::chrono::steady_clock::now();
    const auto found = triangulate::associate_scan(scan, scene, each, threads);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!found) {
      table.rows.push_back({name, found.error().message});
      continue;
    }
    const auto& s = found->solution;
    table.rows.push_back({name, fmt::format("{}", found->fixes.size()),
                          fmt::format("{:.3f}", s.primal), fmt::format("{:.3f}", s.dual),
                          yes(s.proved), fmt::format("{}", found->packing.columns()),
                          fmt::format("{:.4f}", seconds)});
    if (!judged) continue;
    evaluate::AssociationScore score;
    score.add(scan, found->fixes, {});
    for (const auto n : {score.exact, score.targets, score.ghosts}) {
      table.rows.back().push_back(fmt::format("{}", n));
    }
  }
  table.note = "Weights of different costs cannot be compared with each other.";
  if (judged) {
    table.note +=
        " exact: fixes of all bearings of one target and no other; of: targets that two "
        "sensors or more saw.";
  }
  return table;
}

}  // namespace

std::string bearing_names(const BearingScan& scan, const PassiveScene& scene,
                          std::span<const std::int32_t> bearings) {
  std::string names;
  for (const auto place : bearings) {
    const Bearing& b = scan.bearings[static_cast<std::size_t>(place)];
    names += fmt::format("{}{}:{}", names.empty() ? "" : " ",
                         scene.sensors[static_cast<std::size_t>(b.sensor)].name, b.measurement);
  }
  return names;
}

AssociationReport::AssociationReport(const PassiveScene& scene, const AssociationOptions& options,
                                     PassiveTruth truth, std::size_t scans, int threads)
    : scene_(scene),
      options_(options),
      truth_(std::move(truth)),
      stride_(std::max<std::size_t>(1, (scans + kShownScans - 1) / kShownScans)),
      threads_(threads),
      scans_{"Scans",
             {"scan", "bearings", "targets", "as clutter", "hypotheses", "primal", "dual", "gap",
              "proved", "seconds"},
             {}} {}

void AssociationReport::add(const BearingScan& scan, const ScanAssociation& found, double seconds,
                            const associate::PackingRanking* ranking) {
  const std::size_t place = count_++;
  const auto& s = found.solution;
  if (place < kRows) {
    scans_.rows.push_back({fmt::format("{}", scan.scan), fmt::format("{}", scan.bearings.size()),
                           fmt::format("{}", found.fixes.size()),
                           fmt::format("{}", std::ranges::count(found.target_of_bearing, -1)),
                           fmt::format("{}", found.packing.columns()),
                           fmt::format("{:.4f}", s.primal), fmt::format("{:.4f}", found.dual),
                           fmt::format("{:.3g}", found.gap()), yes(found.proved),
                           fmt::format("{:.4f}", seconds)});
  }
  if (place % stride_ != 0) return;
  report::PassiveSection section;
  section.title = fmt::format("Scan {}: {} targets", scan.scan, found.fixes.size());
  section.view = view_of(scan, scene_, found, truth_);
  section.tables.push_back(fix_table(scan, scene_, found, section.view));
  if (ranking != nullptr && !ranking->packings.empty()) {
    section.tables.push_back(ranking_table(scan, scene_, found, *ranking));
  }
  section.tables.push_back(component_table(found.solution));
  section.tables.push_back(cost_table(scan, scene_, options_, threads_));
  if (s.diagnostics.rounds.size() > 1) section.charts.push_back(convergence_chart(s));
  sections_.push_back(std::move(section));
}

std::string AssociationReport::page(const std::string& bearings) const {
  ReportTable scans = scans_;
  scans.note = cut_note(count_);
  std::string_view cost;
  for (const auto& [name, method] : choices(triangulate::CostMethod{})) {
    if (method == options_.cost) cost = name;
  }
  const std::string note =
      fmt::format("Which bearings of {} sensors belong to one target. Cost: {}. Scans: {}{}.",
                  scene_.sensors.size(), cost, count_,
                  stride_ > 1 ? fmt::format(", one in {} shown in full", stride_) : "");
  return report::passive_page(bearings, note, scene_.sensors, {scans}, sections_);
}

}  // namespace scanfuse::app
