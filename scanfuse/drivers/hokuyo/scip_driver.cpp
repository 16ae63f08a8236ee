#include <algorithm>
#include <cmath>
#include <optional>

#include "scanfuse/drivers/driver_base.hpp"
#include "scanfuse/drivers/hokuyo/scip.hpp"
#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::drivers::hokuyo {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kClockPeriod{1 << 24};
constexpr std::string_view kStop = "QT\n";

Bytes bytes_of(std::string_view text) {
  const ByteView bytes = view_of(text);
  return {bytes.begin(), bytes.end()};
}

class ScipDriver final : public DriverBase {
 public:
  using DriverBase::DriverBase;

  Bytes hello() override { return bytes_of(std::string(kStop) + "PP\n"); }
  Bytes farewell() override { return bytes_of(kStop); }

  void take(ByteView bytes, Time received, Output& out) override {
    stream_.feed(bytes, &cut_scip, [&](ByteView answer) { open(answer, received, out); }, odd());
  }
  void lost() override { stream_.clear(odd()); }

 private:
  void open(ByteView bytes, Time received, Output& out) {
    const auto answer = parse_answer(bytes);
    if (!answer) return odd().damage("answer not understood", answer.error().message);
    if (answer->command == "PP") {
      parameters_ = parse_parameters(*answer);
      return ask("ME", out);
    }
    if (is_scan(*answer)) {
      const auto scan = parse_scan(*answer);
      if (!scan) return odd().damage("scan not understood", scan.error().message);
      return give(*scan, received, out);
    }
    // A sensor without strengths says that it does not know ME.
    if (answer->command.starts_with("ME") && answer->status != "00") ask("MD", out);
  }

  void ask(std::string_view command, Output& out) const {
    append(out.reply, view_of(fmt::format("BM\n{}{:04}{:04}01000\n", command,
                                          parameters_->first_step, parameters_->last_step)));
  }

  void give(const ScipScan& scip, Time received, Output& out) {
    if (!parameters_) {
      odd().note("parameters of the sensor not heard: those of a UTM-30LX are assumed", sensor());
      parameters_ = ScipParameters{};
    }
    const ScipParameters& p = *parameters_;
    const double step_rad = 2 * kPi / p.steps_per_turn;
    const double step_s = 60.0 / std::max(1, p.turns_per_minute) / p.steps_per_turn;
    const Duration began = counter_.unwrap(milliseconds(scip.time_ms));
    const double took_s = std::min((scip.last_step - scip.first_step) * step_s, 1.0);
    const Time at = stamp(began, began + duration_from_seconds(took_s), received);
    Scan scan = new_scan(at);
    for (std::size_t i = 0; i < scip.ranges_mm.size(); ++i) {
      const auto range_mm = static_cast<int>(scip.ranges_mm[i]);
      // Below the least range stand codes of what went wrong.
      if (range_mm < std::max(1, p.min_range_mm) || range_mm > p.max_range_mm) continue;
      const int turned = static_cast<int>(i) * scip.cluster;
      const int step = scip.first_step + turned - p.front_step;
      Return r = return_at(range_mm * 1e-3, step * step_rad, 0);
      if (i < scip.strengths.size()) r.intensity = static_cast<float>(scip.strengths[i]);
      r.time_offset_s = static_cast<float>(std::min(turned * step_s, 1.0));
      r.beam = static_cast<std::int32_t>(i);
      scan.returns.push_back(r);
    }
    scan.beams = BeamPattern{(scip.first_step - p.front_step) * step_rad,
                             step_rad * scip.cluster,
                             static_cast<int>(scip.ranges_mm.size()),
                             1,
                             p.min_range_mm * 1e-3,
                             p.max_range_mm * 1e-3};
    out.scans.push_back(std::move(scan));
  }

  StreamCutter stream_;
  Unwrapper counter_{kClockPeriod};
  std::optional<ScipParameters> parameters_;
};

class ScipSimulator final : public DeviceSimulator {
 public:
  Bytes answer(ByteView request) override {
    append(heard_, request);
    Bytes answers;
    while (true) {
      const std::size_t end = until(heard_, std::byte{'\n'});
      if (end == heard_.size()) break;
      const std::string command(text_of(ByteView(heard_).first(end)));
      heard_.erase(heard_.begin(), heard_.begin() + static_cast<std::ptrdiff_t>(end + 1));
      append(answers, reply(command));
    }
    if (heard_.size() > 1024) heard_.clear();
    return answers;
  }
  bool is_streaming() const override { return !command_.empty(); }

  std::vector<Telegram> encode(const Scan& scan) override {
    if (command_.empty()) return {};
    ScipScan scip;
    scip.has_strengths = command_[1] == 'E';
    scip.first_step = parameters_.first_step;
    scip.last_step = parameters_.last_step;
    const auto steps = static_cast<std::size_t>(scip.last_step - scip.first_step + 1);
    scip.ranges_mm.assign(steps, 1);  // a code: nothing there
    scip.strengths.assign(steps, 0);
    for (const Return& r : scan.returns) add(r, scip);
    scip.time_ms = static_cast<std::uint32_t>(ticks_of<milliseconds>(scan.stamp) & 0xFFFFFF);
    const double took_s =
        static_cast<double>(steps) * 60 / parameters_.turns_per_minute / parameters_.steps_per_turn;
    return {{encode_answer(answer_of(scip, command_)), took_s}};
  }

 private:
  Bytes reply(const std::string& command) {
    if (command == "PP") return encode_answer(answer_of(parameters_));
    if (command.starts_with("MD") || command.starts_with("ME")) command_ = command;
    if (command == "QT" || command == "RS") command_.clear();
    return encode_answer({command, "00", {}});
  }

  void add(const Return& r, ScipScan& scip) const {
    const double step_rad = 2 * kPi / parameters_.steps_per_turn;
    const auto step = std::lround(std::atan2(r.y_m, r.x_m) / step_rad) + parameters_.front_step;
    const auto range_mm = std::lround(std::hypot(r.x_m, r.y_m) * 1e3);
    if (step < scip.first_step || step > scip.last_step || r.echo > 0) return;
    if (range_mm < parameters_.min_range_mm || range_mm > parameters_.max_range_mm) return;
    const auto i = static_cast<std::size_t>(step - scip.first_step);
    scip.ranges_mm[i] = static_cast<std::uint32_t>(range_mm);
    scip.strengths[i] =
        static_cast<std::uint32_t>(std::clamp(std::lround(r.intensity), 0L, 262143L));
  }

  ScipParameters parameters_;
  std::string command_;
  Bytes heard_;
};

}  // namespace

std::unique_ptr<Driver> make_scip_driver(const DriverOptions& options) {
  return std::make_unique<ScipDriver>(options);
}

std::unique_ptr<DeviceSimulator> make_scip_simulator() { return std::make_unique<ScipSimulator>(); }

}  // namespace scanfuse::drivers::hokuyo
