#include <gtest/gtest.h>

#include "track/scene.hpp"

namespace scanfuse::track {
namespace {

using testing::IdentityCounter;
using testing::SetPiece;

double changes_per_run(const SetPiece& piece, const TrackerOptions& options, int runs) {
  int changes = 0;
  const bool walkers = piece.movers.front().object_class == ObjectClass::kPedestrian;
  for (int run = 0; run < runs; ++run) {
    Tracker tracker(options);
    IdentityCounter counter(walkers ? 1.0 : 2.0);
    for (const auto& frame : testing::play(piece.movers, {}, 100 + run)) {
      counter.add(frame.truth, tracker.step(frame.stamp, frame.detections));
    }
    changes += counter.changes();
  }
  return double(changes) / runs;
}

TEST(SetPieces, TheDefaultChangesIdentityNoMoreOftenThanTheOptimalPrototype) {
  for (const SetPiece& piece : testing::set_pieces()) {
    const double ours = changes_per_run(piece, {}, 100);
    const double literal = changes_per_run(piece, literal_options(), 100);
    std::printf("%-28s default %.2f  literal %.2f\n", piece.name, ours, literal);
    EXPECT_LE(ours, piece.allowed + 0.05) << piece.name;
  }
}

}  // namespace
}  // namespace scanfuse::track
