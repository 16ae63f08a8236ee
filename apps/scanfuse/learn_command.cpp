#include <nlohmann/json.hpp>

#include "learn_run.hpp"
#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/report/class_report.hpp"

namespace scanfuse::app {
namespace {

constexpr std::array kUsers{ObjectClass::kVehicle, ObjectClass::kPedestrian, ObjectClass::kCyclist};

nlohmann::json or_null(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

nlohmann::json confusion_json(const DetectionConfusion& confusion) {
  nlohmann::json all;
  for (int truth = 0; truth < classify::kLearnedClasses; ++truth) {
    auto& row = all[std::string(to_string(classify::learned_class(truth)))];
    for (int said = 0; said <= classify::kLearnedClasses; ++said) {
      const bool none = said == classify::kLearnedClasses;
      row[none ? "none" : std::string(to_string(classify::learned_class(said)))] =
          confusion[truth][said];
    }
  }
  return all;
}

nlohmann::json as_json(const LearnOutcome& outcome) {
  nlohmann::json tracks{{"clutter_per_scan", or_null(outcome.tracks.clutter_per_scan())},
                        {"expected_calibration_error",
                         or_null(outcome.tracks.reliability().expected_calibration_error())}};
  for (std::size_t truth = 0; truth < kObjectClasses; ++truth) {
    for (std::size_t said = 0; said < kObjectClasses; ++said) {
      tracks["confusion"][std::string(to_string(static_cast<ObjectClass>(truth)))]
            [std::string(to_string(static_cast<ObjectClass>(said)))] =
                outcome.tracks.confusion()[truth][said];
    }
  }
  const auto& reliability = outcome.tracks.reliability();
  tracks["reliability"] = {
      {"said", reliability.said}, {"right", reliability.right}, {"count", reliability.count}};
  for (const ObjectClass kind : kUsers) {
    const auto& counts = outcome.tracks.counts(kind);
    auto& by_range = tracks[std::string(to_string(kind))]["by_range"];
    by_range = {{"bin_m", evaluate::ClassScore::kBin_m},
                {"objects", counts.objects},
                {"found", counts.found},
                {"untracked", counts.untracked},
                {"tentative", counts.tentative},
                {"misnamed", counts.misnamed},
                {"said", counts.said},
                {"right", counts.right}};
    for (const double range : evaluate::ClassScore::kRanges_m) {
      tracks[std::string(to_string(kind))][fmt::format("{:.0f}_m", range)] = {
          {"precision", or_null(outcome.tracks.precision(kind, range))},
          {"recall", or_null(outcome.tracks.recall(kind, range))}};
    }
  }
  return {{"outlines",
           {{"fit", outcome.fit_outlines},
            {"calibration", outcome.calibration_outlines},
            {"test", outcome.test_outlines},
            {"expected_calibration_error", or_null(outcome.outlines.expected_calibration_error())},
            {"confusion_softmax", confusion_json(outcome.softmax)},
            {"confusion_intervals", confusion_json(outcome.intervals)}}},
          {"temperature", outcome.classes.recognizer.softmax.temperature},
          {"split", outcome.cut_by_time ? "time" : "recording"},
          {"tracks", tracks}};
}

void print_text(const LearnOutcome& outcome) {
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.3f}", *value) : std::string("-");
  };
  fmt::print("{} outlines to fit, {} to calibrate, {} to test{}\n", outcome.fit_outlines,
             outcome.calibration_outlines, outcome.test_outlines,
             outcome.cut_by_time ? " (few recordings: each cut in three by time)" : "");
  fmt::print("{:<12}", "tracks");
  for (const double range : evaluate::ClassScore::kRanges_m) {
    fmt::print(" to {:.0f} m: prec recall ", range);
  }
  fmt::print("\n");
  for (const ObjectClass kind : kUsers) {
    fmt::print("{:<12}", to_string(kind));
    for (const double range : evaluate::ClassScore::kRanges_m) {
      fmt::print("        {} {}   ", number(outcome.tracks.precision(kind, range)),
                 number(outcome.tracks.recall(kind, range)));
    }
    fmt::print("\n");
  }
  fmt::print(
      "clutter called a road user {} per scan; expected calibration error {} (tracks), {} "
      "(outlines)\n",
      number(outcome.tracks.clutter_per_scan()),
      number(outcome.tracks.reliability().expected_calibration_error()),
      number(outcome.outlines.expected_calibration_error()));
}

std::string row_name(int row) {
  return row == classify::kLearnedClasses ? "none"
                                          : std::string(to_string(classify::learned_class(row)));
}

report::ReportTable confusion_table(const std::string& title, const DetectionConfusion& confusion) {
  report::ReportTable table{title, {"truth \\ said"}, {}};
  for (int said = 0; said <= classify::kLearnedClasses; ++said) {
    table.columns.push_back(row_name(said));
  }
  for (int truth = 0; truth < classify::kLearnedClasses; ++truth) {
    auto& row = table.rows.emplace_back(std::vector{row_name(truth)});
    for (const auto count : confusion[truth]) row.push_back(fmt::format("{}", count));
  }
  return table;
}

report::ReportTable interval_table(const classify::Intervals& intervals) {
  const auto text = [](const classify::Interval& i) {
    return i.is_empty() ? std::string("-") : fmt::format("{:.3f} .. {:.3f}", i.low, i.high);
  };
  report::ReportTable table{
      "Reference intervals of [Guo], 2 % to 98 %",
      {"class", "l [m]", "its var r [m2]", "l1 [m]", "l2 [m]", "their var r [m2]"},
      {}};
  for (int c = 0; c < 3; ++c) {
    const auto& of = intervals[c];
    table.rows.push_back({row_name(c), text(of.l), text(of.var_r_of_one), text(of.l1), text(of.l2),
                          text(of.var_r_of_two)});
  }
  return table;
}

report::Chart reliability_chart(const evaluate::Reliability& reliability) {
  report::Series seen{"tracks", {}, report::Series::Style::kLine};
  for (int i = 0; i < evaluate::Reliability::kBins; ++i) {
    if (reliability.count[i] == 0) continue;
    seen.points.emplace_back(reliability.said[i] / reliability.count[i],
                             reliability.right[i] / reliability.count[i]);
  }
  return {fmt::format("Reliability; expected calibration error {:.3f}",
                      reliability.expected_calibration_error().value_or(0)),
          "probability said",
          "share right",
          {seen, {"ideal", {{0, 0}, {1, 1}}, report::Series::Style::kDashed}}};
}

/// Share of `part` in `whole`, range bin by range bin.
report::Chart range_chart(const evaluate::ClassScore& score, bool recall) {
  report::Chart chart{recall ? "Recall against range" : "Precision against range",
                      "range [m]",
                      recall ? "recall" : "precision",
                      {}};
  for (const ObjectClass kind : kUsers) {
    report::Series series{std::string(to_string(kind)), {}, report::Series::Style::kLine};
    const auto& counts = score.counts(kind);
    for (int i = 0; i < evaluate::ClassScore::kRangeBins; ++i) {
      const auto whole = static_cast<double>(recall ? counts.objects[i] : counts.said[i]);
      const auto part = static_cast<double>(recall ? counts.found[i] : counts.right[i]);
      if (whole > 0) {
        series.points.emplace_back((i + 0.5) * evaluate::ClassScore::kBin_m, part / whole);
      }
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

std::string report_page(const LearnOutcome& outcome) {
  return report::figures_page(
      "Learned classes",
      fmt::format("{} outlines to fit, {} to calibrate, {} to test{}", outcome.fit_outlines,
                  outcome.calibration_outlines, outcome.test_outlines,
                  outcome.cut_by_time ? "; few recordings: each cut in three by time" : ""),
      {interval_table(outcome.classes.recognizer.intervals),
       confusion_table("Outlines of the test by softmax", outcome.softmax),
       confusion_table("The same by the intervals", outcome.intervals)},
      {reliability_chart(outcome.tracks.reliability()), range_chart(outcome.tracks, false),
       range_chart(outcome.tracks, true)});
}

int learn_classes(const LearnRequest& request, const CommonOptions& common) {
  catch_interrupts();
  if (!request.truths.empty() && request.truths.size() != request.inputs.size()) {
    return report_error({Error::Code::kMalformed,
                         fmt::format("{} --truth for {} recordings; give one each, in their order",
                                     request.truths.size(), request.inputs.size())});
  }
  for (const auto& input : request.inputs) {
    for (const auto& output : {request.output, request.report}) {
      if (output.empty()) continue;
      if (auto fine = refuse_to_replace(input, output); !fine) return report_error(fine.error());
    }
  }
  auto file = io::AtomicFile::create(request.output);
  if (!file) return report_error(file.error());
  const auto outcome = run_learn(request, common);
  if (!outcome) return report_error(outcome.error());
  if (interrupted) return kInterrupted;
  if (auto done = file->write(write_classes(outcome->classes)); !done) {
    return report_error(done.error());
  }
  if (!request.report.empty()) {
    auto done = io::write_whole(request.report, report_page(*outcome));
    if (!done) return report_error(done.error());
  }
  if (auto done = file->commit(); !done) return report_error(done.error());
  if (request.json) {
    fmt::print("{}\n", as_json(*outcome).dump(2));
  } else {
    print_text(*outcome);
  }
  return report_diagnostics(outcome->diagnostics, common.quiet);
}

}  // namespace

void add_learn(Tool& tool) {
  auto* learn = tool.app->add_subcommand("learn", "Learn parameters from labelled recordings");
  learn->require_subcommand(1);
  auto* command = learn->add_subcommand(
      "classes", "Feature intervals and classifier of vehicles, pedestrians, cyclists, clutter");
  auto request = std::make_shared<LearnRequest>();
  command->add_option("LABELLED", request->inputs, "Recordings with truth inside, or with --truth")
      ->required();
  command->add_option("--truth", request->truths, "Truth tables (CSV), one a recording, in order")
      ->allow_extra_args(false);
  command->add_option("--ego", request->ego, "Ego motion (CSV) of the recordings");
  command->add_option("-o,--output", request->output, "Classes to write (TOML)")->required();
  command->add_option("--report", request->report, "HTML page to write");
  command->add_flag("--vary", request->vary,
                    "Leave out layers, columns and returns and add noise, another way in each "
                    "recording that is learned from: for sensors that are not among them");
  command->add_flag("--json", request->json, "One JSON object on stdout");
  command->footer(
      "Of five recordings two serve to fit, two to calibrate, one to test, in the order given;\n"
      "fewer than five are each cut in three by time.\nExample:\n"
      "  for s in 1 2 3 4 5; do scanfuse simulate road-users -o $s.mcap --seed $s; done\n"
      "  scanfuse learn classes 1.mcap 2.mcap 3.mcap 4.mcap 5.mcap -o classes.toml\n"
      "  scanfuse track run.mcap --preset road-users --set classify.classes_file=classes.toml "
      "-o tracks.mcap");
  command->callback([request, tool] { *tool.exit_code = learn_classes(*request, *tool.common); });
}

}  // namespace scanfuse::app
