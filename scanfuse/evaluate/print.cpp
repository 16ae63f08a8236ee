#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "scanfuse/evaluate/evaluate.hpp"

namespace scanfuse::evaluate {
namespace {

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}
std::string number(std::int64_t value) { return fmt::format("{}", value); }
std::string number(const std::optional<double>& value) { return value ? number(*value) : "null"; }

/// Collects `"key":value` pairs of one JSON object. Keys need no escaping: they are all ours.
class JsonObject {
 public:
  JsonObject& raw(std::string_view key, std::string_view value) {
    text_ += fmt::format("{}\"{}\":{}", text_.empty() ? "" : ",", key, value);
    return *this;
  }
  template <class T>
  JsonObject& add(std::string_view key, const T& value) {
    return raw(key, number(value));
  }
  [[nodiscard]] std::string str() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

std::string clear_json(const ClearMetrics& m) {
  return JsonObject()
      .add("MOTA", m.mota)
      .add("MOTP_m", m.motp_m)
      .add("TP", m.true_positives)
      .add("FP", m.false_positives)
      .add("FN", m.false_negatives)
      .add("IDSW", m.identity_switches)
      .add("Frag", m.fragmentations)
      .add("MT", std::int64_t{m.mostly_tracked})
      .add("PT", std::int64_t{m.partly_tracked})
      .add("ML", std::int64_t{m.mostly_lost})
      .str();
}

std::string rmse_json(const RmseMetrics& m) {
  return JsonObject()
      .add("position_m", m.position_m)
      .add("velocity_m_per_s", m.velocity_m_per_s)
      .add("heading_rad", m.heading_rad)
      .add("heading_mod_pi_rad", m.heading_mod_pi_rad)
      .add("length_m", m.length_m)
      .add("width_m", m.width_m)
      .str();
}

std::string classes_json(const Evaluation& e) {
  JsonObject classes;
  for (const auto& [name, m] : e.detection) {
    classes.raw(to_string(name),
                JsonObject().add("precision", m.precision).add("recall", m.recall).str());
  }
  return classes.str();
}

std::string by_range_json(const Evaluation& e) {
  JsonObject classes;
  for (const auto& [name, rings] : e.detection_by_range) {
    std::string list;
    for (const RangeMetrics& ring : rings) {
      list += list.empty() ? "" : ",";
      list += JsonObject()
                  .add("from_m", ring.from_m)
                  .add("to_m", ring.to_m)
                  .add("objects", ring.objects)
                  .add("tracks", ring.tracks)
                  .add("precision", ring.precision)
                  .add("recall", ring.recall)
                  .str();
    }
    classes.raw(to_string(name), "[" + list + "]");
  }
  return classes.str();
}

std::string confusion_json(const Evaluation& e) {
  JsonObject rows;
  for (const auto& [is, said] : e.confusion) {
    JsonObject row;
    for (const auto& [name, count] : said) row.add(to_string(name), count);
    rows.raw(to_string(is), row.str());
  }
  return rows.str();
}

std::string shown(const std::optional<double>& value, std::string_view unit = "") {
  if (!value) return "-";
  return fmt::format("{:.3f}{}{}", *value, unit.empty() ? "" : " ", unit);
}
std::string shown(std::int64_t value) { return fmt::format("{}", value); }

class TextTable {
 public:
  void head(std::string_view title) { text_ += fmt::format("\n{}\n", title); }
  void row(std::string_view name, std::string_view value) {
    text_ += fmt::format("  {:<34}{:>16}\n", name, value);
  }
  [[nodiscard]] const std::string& str() const { return text_; }

 private:
  std::string text_;
};

void clear_rows(TextTable& table, const ClearMetrics& m) {
  table.head("CLEAR-MOT");
  table.row("MOTA", shown(m.mota));
  table.row("MOTP", shown(m.motp_m, "m"));
  table.row("matches", shown(m.true_positives));
  table.row("false positives", shown(m.false_positives));
  table.row("misses", shown(m.false_negatives));
  table.row("identity switches", shown(m.identity_switches));
  table.row("fragmentations", shown(m.fragmentations));
  table.row("mostly tracked / partly / lost",
            fmt::format("{} / {} / {}", m.mostly_tracked, m.partly_tracked, m.mostly_lost));
}

void error_rows(TextTable& table, const Evaluation& e) {
  table.head("Errors (RMS)");
  table.row("position", shown(e.rmse.position_m, "m"));
  table.row("velocity", shown(e.rmse.velocity_m_per_s, "m/s"));
  table.row("heading", shown(e.rmse.heading_rad, "rad"));
  table.row("heading, front and rear alike", shown(e.rmse.heading_mod_pi_rad, "rad"));
  table.row("length", shown(e.rmse.length_m, "m"));
  table.row("width", shown(e.rmse.width_m, "m"));
  table.row("share of headings reversed", shown(e.rmse.heading_reversed_share));
  table.row("overlap of boxes (BEV IoU), mean", shown(e.bev_iou));
  table.row("ghosts per frame", shown(e.ghosts_per_frame));
  table.row("of them moving", shown(e.ghost_movers_per_frame));
  table.row("time to confirm, median", shown(e.time_to_confirm_s, "s"));
  table.head("Consistency");
  table.row("NEES, mean (4 is right)", shown(e.consistency.anees));
  table.row("NEES, median (3.36 is right)", shown(e.consistency.nees_median));
  table.row("NEES inside the 95 % band", shown(e.consistency.nees_inside_95));
  table.row("NIS, mean (2 is right)", shown(e.consistency.anis));
}

}  // namespace

std::string to_json(const Evaluation& e) {
  return JsonObject()
      .add("frames", e.frames)
      .raw("clear", clear_json(e.clear))
      .raw("identity", JsonObject()
                           .add("IDF1", e.identity.idf1)
                           .add("IDP", e.identity.idp)
                           .add("IDR", e.identity.idr)
                           .str())
      .raw("hota", JsonObject()
                       .add("HOTA", e.hota.hota)
                       .add("DetA", e.hota.det_a)
                       .add("AssA", e.hota.ass_a)
                       .add("LocA", e.hota.loc_a)
                       .str())
      .raw("gospa", JsonObject()
                        .add("gospa_m", e.sets.gospa_m)
                        .add("localisation", e.sets.localisation)
                        .add("missed", e.sets.missed)
                        .add("false", e.sets.false_tracks)
                        .str())
      .add("ospa_m", e.sets.ospa_m)
      .add("ospa2_m", e.sets.ospa2_m)
      .raw("rmse", rmse_json(e.rmse))
      .add("heading_reversed_share", e.rmse.heading_reversed_share)
      .add("ghosts_per_frame", e.ghosts_per_frame)
      .add("ghost_movers_per_frame", e.ghost_movers_per_frame)
      .add("time_to_confirm_s", e.time_to_confirm_s)
      .add("bev_iou", e.bev_iou)
      .raw("average", JsonObject()
                          .add("AMOTA", e.average.amota)
                          .add("sAMOTA", e.average.samota)
                          .add("AMOTP_m", e.average.amotp_m)
                          .str())
      .raw("detection", classes_json(e))
      .raw("detection_by_range", by_range_json(e))
      .raw("confusion", confusion_json(e))
      .raw("consistency", JsonObject()
                              .add("anees", e.consistency.anees)
                              .add("nees_median", e.consistency.nees_median)
                              .add("anis", e.consistency.anis)
                              .add("nees_inside_95", e.consistency.nees_inside_95)
                              .str())
      .str();
}

std::string to_text(const Evaluation& e) {
  TextTable table;
  table.row("frames", shown(e.frames));
  clear_rows(table, e.clear);
  table.head("Identity and HOTA");
  table.row("IDF1 / IDP / IDR", fmt::format("{} / {} / {}", shown(e.identity.idf1),
                                            shown(e.identity.idp), shown(e.identity.idr)));
  table.row("HOTA", shown(e.hota.hota));
  table.row("DetA / AssA / LocA", fmt::format("{} / {} / {}", shown(e.hota.det_a),
                                              shown(e.hota.ass_a), shown(e.hota.loc_a)));
  table.row("AMOTA / sAMOTA",
            fmt::format("{} / {}", shown(e.average.amota), shown(e.average.samota)));
  table.head("Sets, mean over frames");
  table.row("GOSPA", shown(e.sets.gospa_m, "m"));
  table.row("localisation / missed / false",
            fmt::format("{} / {} / {}", shown(e.sets.localisation), shown(e.sets.missed),
                        shown(e.sets.false_tracks)));
  table.row("OSPA", shown(e.sets.ospa_m, "m"));
  table.row("OSPA(2)", shown(e.sets.ospa2_m, "m"));
  error_rows(table, e);
  table.head("Detection (precision / recall)");
  for (const auto& [name, m] : e.detection) {
    table.row(to_string(name), fmt::format("{} / {}", shown(m.precision), shown(m.recall)));
  }
  return table.str();
}

}  // namespace scanfuse::evaluate
