#include "scanfuse/serve/desk.hpp"

#include <algorithm>
#include <chrono>

#include "scanfuse/serve/replies.hpp"

namespace scanfuse::serve {
namespace {

constexpr std::size_t kMostWaiting = 64;  ///< requests of one client
constexpr auto kStatusEvery = std::chrono::milliseconds(250);
constexpr auto kLiveStatusEvery = std::chrono::milliseconds(40);  ///< it tells of new frames
constexpr std::uint32_t kStatusSlot = 1;

Result<pipeline::PerceptionOptions> tuned(const Workbench& bench, const TuneRequest& request) {
  auto options = bench.options().options;
  if (!request.preset.empty()) {
    auto named = pipeline::preset(request.preset);
    if (!named) return named;
    options = *named;
  }
  for (const auto& change : request.changes) {
    if (auto done = pipeline::set_config(options, change); !done) {
      return tl::unexpected(done.error());
    }
  }
  return options;
}

std::chrono::milliseconds pace_of(const Workbench& bench) {
  return bench.is_live() ? kLiveStatusEvery : kStatusEvery;
}

}  // namespace

/// Answers one request of one client.
struct Desk::Reply {
  Desk& desk;
  ClientId client;

  void text(std::string json, std::uint32_t slot = 0) const {
    desk.send_(client, {std::move(json), false, slot});
  }
  void binary(std::string bytes) const { desk.send_(client, {std::move(bytes), true, 0}); }
  void problem(std::string_view op, const Error& error) const {
    text(problem_json(op, error.message));
  }
  /// The run asked for; says so when there is none.
  [[nodiscard]] std::shared_ptr<const Run> run(RunName name, std::string_view op) const {
    auto found = desk.bench_.run(name);
    if (!found) text(problem_json(op, "no trial was started"));
    return found;
  }

  void operator()(const IndexRequest& request) const {
    const auto end = desk.bench_.run(RunName::kMain)->end();
    binary(index_message(request.run, request.from, desk.bench_.log().times_s(request.from, end)));
  }
  void operator()(const FrameRequest& request) const {
    const auto found = desk.bench_.run(request.run);
    auto message = found ? found->message(request.frame)
                         : Result<std::string>(fail(Error::Code::kNotFound, ""));
    if (message) {
      binary(std::move(*message));
    } else {
      text(missing_frame_json(request));
    }
  }
  void operator()(const EventsRequest& request) const {
    if (const auto found = run(request.run, "events")) {
      binary(events_message(request.run, request.from, found->events(request.from)));
    }
  }
  void operator()(const HistoryRequest& request) const {
    const auto found = run(request.run, "history");
    if (!found) return;
    const auto samples = found->history(request.track);
    if (!samples) return problem("history", samples.error());
    binary(history_message(request.run, request.track, *samples, desk.bench_.log().origin_m()));
  }
  void operator()(const TrailsRequest& request) const {
    const auto found = run(request.run, "trails");
    if (!found) return;
    std::vector<TrailStep> steps;
    const std::uint32_t from = request.frame - std::min(request.frame, request.length);
    for (std::uint32_t frame = from; frame < request.frame; ++frame) {
      if (auto step = found->step(frame)) steps.push_back({frame, std::move(step->tracks)});
    }
    binary(trails_message(request.run, steps, desk.bench_.log().origin_m()));
  }
  void operator()(const OptionsRequest& request) const {
    const auto& own = desk.bench_.options();
    if (request.preset.empty() || request.preset == own.preset) {
      return text(options_json(own.preset, own.options));
    }
    const auto named = pipeline::preset(request.preset);
    if (!named) return problem("options", named.error());
    text(options_json(request.preset, *named));
  }
  void operator()(const TuneRequest& request) const {
    const auto options = tuned(desk.bench_, request);
    if (!options) return problem("tune", options.error());
    desk.bench_.start_trial(request.from, *options);
    text(status_json(desk.bench_));
  }
  void operator()(const StopTuneRequest&) const {
    desk.bench_.stop_trial();
    text(status_json(desk.bench_));
  }
  void operator()(const MetricsRequest&) const {
    const auto comparison = desk.bench_.compare();
    if (!comparison) return problem("metrics", comparison.error());
    text(metrics_json(*comparison));
  }
  void operator()(const ExportRequest& request) const {
    const auto trial = desk.bench_.trial_options();
    const bool wants_trial = request.run == RunName::kTrial && trial;
    text(export_json(request.run, wants_trial ? *trial : desk.bench_.options().options));
  }
  void operator()(const LabelRequest& request) const {
    const auto& bench = desk.bench_;
    const auto done = desk.labels_.apply(request, *bench.run(RunName::kMain), bench.log());
    if (!done) problem("label", done.error());
    text(labels_json(desk.labels_, bench.log(), request));
  }
};

Desk::Desk(Workbench& bench, Labels& labels, std::function<void(ClientId, Message)> send)
    : bench_(bench), labels_(labels), send_(std::move(send)), thread_([this] { loop(); }) {}

Desk::~Desk() {
  {
    const std::lock_guard lock(guard_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Desk::open(ClientId client) {
  {
    const std::lock_guard lock(guard_);
    clients_[client] = false;
  }
  changed_.notify_all();
}

void Desk::receive(ClientId client, std::string text) {
  {
    const std::lock_guard lock(guard_);
    const auto mine = std::ranges::count(waiting_, client, &Waiting::client);
    if (static_cast<std::size_t>(mine) >= kMostWaiting) {
      // Newest wins: what waits longest would be shown too late.
      waiting_.erase(std::ranges::find(waiting_, client, &Waiting::client));
    }
    waiting_.push_back({client, std::move(text)});
  }
  changed_.notify_all();
}

void Desk::close(ClientId client) {
  const std::lock_guard lock(guard_);
  clients_.erase(client);
  std::erase_if(waiting_, [&](const Waiting& one) { return one.client == client; });
}

void Desk::loop() {
  const auto pace = pace_of(bench_);
  std::unique_lock lock(guard_);
  while (!stopping_) {
    changed_.wait_for(lock, pace, [&] { return stopping_ || !waiting_.empty(); });
    if (stopping_) break;
    std::optional<Waiting> next;
    if (!waiting_.empty()) {
      next = std::move(waiting_.front());
      waiting_.pop_front();
    }
    lock.unlock();
    tell_status();
    if (next) answer(next->client, next->text);
    lock.lock();
  }
}

/// To those who are new at once, to all others when it changed, but not too often.
void Desk::tell_status() {
  std::vector<ClientId> fresh, all;
  {
    const std::lock_guard lock(guard_);
    for (auto& [client, greeted] : clients_) {
      if (!greeted) fresh.push_back(client);
      greeted = true;
      all.push_back(client);
    }
  }
  for (const auto client : fresh) send_(client, {hello_json(bench_, labels_), false, 0});
  const auto now = std::chrono::steady_clock::now();
  if (fresh.empty() && now - last_told_ < pace_of(bench_)) return;
  if (all.empty()) return;
  last_told_ = now;
  std::string status = status_json(bench_);
  const bool is_new = status != last_status_;
  for (const auto client : is_new ? all : fresh) send_(client, {status, false, kStatusSlot});
  last_status_ = std::move(status);
}

void Desk::answer(ClientId client, const std::string& text) {
  const auto request = parse_request(text);
  const Reply reply{*this, client};
  if (!request) return reply.problem("request", request.error());
  std::visit(reply, *request);
}

}  // namespace scanfuse::serve
