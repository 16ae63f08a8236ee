#include "class_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace scanfuse::app {
namespace {

using ByClass = std::map<ObjectClass, evaluate::ClassEvaluation>;

std::string cell(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::optional<double> in_degrees(const std::optional<double>& angle_rad) {
  return angle_rad ? std::optional(degrees(*angle_rad)) : std::nullopt;
}

std::vector<std::string> class_row(ObjectClass kind, const evaluate::ClassEvaluation& one) {
  const auto& score = one.score;
  const auto& clear = score.clear;
  return {std::string(to_string(kind)),
          std::to_string(clear.true_positives + clear.false_negatives),
          cell(one.precision, 3),
          cell(one.recall, 3),
          cell(clear.mota, 3),
          cell(score.hota.hota, 3),
          cell(score.identity.idf1, 3),
          std::to_string(clear.identity_switches),
          cell(score.rmse.position_m, 2),
          cell(score.rmse.velocity_m_per_s, 2),
          cell(in_degrees(score.rmse.heading_mod_pi_rad), 1),
          cell(score.rmse.heading_reversed_share, 3)};
}

const std::vector<evaluate::RangeMetrics>& rings_of(ObjectClass kind,
                                                    const evaluate::ClassEvaluation& one) {
  static const std::vector<evaluate::RangeMetrics> kNone;
  const auto found = one.score.detection_by_range.find(kind);
  return found == one.score.detection_by_range.end() ? kNone : found->second;
}

report::ReportTable range_table(const ByClass& by_class) {
  report::ReportTable table;
  table.title = "Precision and recall by range";
  table.columns = {"from the ego"};
  std::size_t rings = 0;
  for (const auto& [kind, one] : by_class) {
    table.columns.push_back(fmt::format("{} precision", to_string(kind)));
    table.columns.push_back("recall");
    table.columns.push_back("objects");
    rings = std::max(rings, rings_of(kind, one).size());
  }
  for (std::size_t k = 0; k < rings; ++k) {
    std::vector<std::string> row(1);
    for (const auto& [kind, one] : by_class) {
      const auto& all = rings_of(kind, one);
      if (k < all.size()) row[0] = fmt::format("{:.0f} to {:.0f} m", all[k].from_m, all[k].to_m);
      const bool here = k < all.size();
      row.push_back(here ? cell(all[k].precision, 3) : "-");
      row.push_back(here ? cell(all[k].recall, 3) : "-");
      row.push_back(here ? std::to_string(all[k].objects) : "-");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Chart range_chart(ObjectClass kind, const evaluate::ClassEvaluation& one) {
  report::Chart chart{fmt::format("{}: against range", to_string(kind)), "range [m]", "share", {}};
  chart.width_px = 420;
  chart.height_px = 220;
  report::Series precision{"precision", {}}, recall{"recall", {}};
  precision.style = report::Series::Style::kDashed;
  for (const auto& ring : rings_of(kind, one)) {
    const double middle = (ring.from_m + ring.to_m) / 2;
    if (ring.precision) precision.points.emplace_back(middle, *ring.precision);
    if (ring.recall) recall.points.emplace_back(middle, *ring.recall);
  }
  chart.series = {std::move(recall), std::move(precision)};
  return chart;
}

}  // namespace

void add_class_figures(const ByClass& by_class, report::TrackReportHeader& header) {
  if (by_class.empty()) return;
  report::ReportTable table;
  table.title = "Each class against truth";
  table.columns = {"class", "objects",  "precision",    "recall",      "MOTA",          "HOTA",
                   "IDF1",  "switches", "position [m]", "speed [m/s]", "heading [deg]", "reversed"};
  table.note =
      "Objects of the class in all scans against confirmed tracks that say so in that scan: a "
      "track "
      "on an object of another class is false. Errors are root mean squares, heading with front "
      "and "
      "rear alike; reversed: share off by more than 90 degrees.";
  for (const auto& [kind, one] : by_class) {
    table.rows.push_back(class_row(kind, one));
    if (!rings_of(kind, one).empty()) header.charts.push_back(range_chart(kind, one));
  }
  header.tables.push_back(std::move(table));
  header.tables.push_back(range_table(by_class));
}

}  // namespace scanfuse::app
