#pragma once

#include <memory>

#include "scanfuse/serve/labels.hpp"
#include "scanfuse/serve/server.hpp"
#include "scanfuse/serve/workbench.hpp"

namespace scanfuse::serve {

/// The page and everything behind it: serves until it is destroyed.
class Viewer {
 public:
  /// `bench` and `labels` must outlive it.
  [[nodiscard]] static Result<Viewer> start(Workbench& bench, Labels& labels,
                                            const ServerOptions& options);
  Viewer(Viewer&&) noexcept;
  Viewer& operator=(Viewer&&) noexcept;
  ~Viewer();

  [[nodiscard]] int port() const;
  [[nodiscard]] ServerCounters counters() const;

 private:
  struct State;
  explicit Viewer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace scanfuse::serve
