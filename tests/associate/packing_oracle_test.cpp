#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "associate/packing_instances.hpp"
#include "associate/packing_scenes.hpp"
#include "associate/triangulated_scenes.hpp"
#include "scanfuse/associate/packing.hpp"

#ifdef SCANFUSE_HAVE_CBC
#include <coin/Cbc_C_Interface.h>
#endif

// The whole problem given to a general integer programming solver, which knows nothing of ours.
namespace scanfuse::associate {
namespace {

#ifdef SCANFUSE_HAVE_CBC

/// The optimum by CBC. Weights are scaled to at most 1: its tolerances are absolute.
double by_cbc(const Packing& packing) {
  double scale = 0;
  for (const double w : packing.weights) scale = std::max(scale, w);
  if (scale == 0) return 0;
  std::vector<CoinBigIndex> starts;
  std::vector<double> ones(packing.members.size(), 1.0), low(packing.columns(), 0.0),
      high(packing.columns(), 1.0), gains, row_low(packing.rows(), -1e30),
      row_high(packing.rows(), 1.0);
  starts.reserve(packing.starts.size());
  gains.reserve(packing.columns());
  for (const auto start : packing.starts) starts.push_back(static_cast<CoinBigIndex>(start));
  for (const double w : packing.weights) gains.push_back(w / scale);
  Cbc_Model* model = Cbc_newModel();
  Cbc_loadProblem(model, static_cast<int>(packing.columns()), static_cast<int>(packing.rows()),
                  starts.data(), packing.members.data(), ones.data(), low.data(), high.data(),
                  gains.data(), row_low.data(), row_high.data());
  Cbc_setObjSense(model, -1);
  for (int j = 0; j < static_cast<int>(packing.columns()); ++j) Cbc_setInteger(model, j);
  Cbc_setParameter(model, "log", "0");
  Cbc_setParameter(model, "ratioGap", "0");
  Cbc_setParameter(model, "allowableGap", "1e-9");
  Cbc_setParameter(model, "increment", "1e-9");
  Cbc_setParameter(model, "integerTolerance", "1e-9");
  Cbc_solve(model);
  double value = 0;  // of the columns, summed here: not what the solver says of itself
  const double* solution = Cbc_getColSolution(model);
  EXPECT_TRUE(Cbc_isProvenOptimal(model));
  for (std::size_t j = 0; j < packing.columns(); ++j) {
    if (solution[j] > 0.5) value += packing.weights[j];
  }
  Cbc_deleteModel(model);
  return value;
}

#else

double by_cbc(const Packing&) { return 0; }

#endif

class PackingOracle : public testing::Test {
 protected:
  void SetUp() override {
#ifndef SCANFUSE_HAVE_CBC
    GTEST_SKIP() << "CBC is not installed";
#endif
  }

  using Draw = std::function<Packing(int trial, RandomStream& random)>;

  /// Draws instances and compares optima.
  static void compare(int trials, std::uint64_t stream, const Draw& draw) {
    int branched = 0;
    for (int trial = 0; trial < trials; ++trial) {
      RandomStream random(static_cast<std::uint64_t>(trial), stream);
      const Packing packing = draw(trial, random);
      const auto solution = PriceAndBranch{}(packing);
      ASSERT_TRUE(solution) << solution.error().message;
      const auto checked = check_bound(packing, *solution);
      ASSERT_TRUE(checked) << "trial " << trial << ": " << checked.error().message;
      EXPECT_TRUE(solution->proved) << "trial " << trial;
      const double optimum = by_cbc(packing);
      EXPECT_NEAR(solution->primal, optimum, 1e-6 * std::max(optimum, 1e-300)) << "trial " << trial;
      branched += solution->diagnostics.branches > 0 ? 1 : 0;
    }
    RecordProperty("branched", branched);
    std::printf("%d of %d had to be branched on\n", branched, trials);
  }

  static instances::Weights weights(int trial) {
    return instances::kAllWeights[static_cast<std::size_t>(trial) %
                                  std::size(instances::kAllWeights)];
  }
};

TEST_F(PackingOracle, SparseColumnsOfTwoToSixSetsHaveTheSameOptimum) {
  compare(560, 1, [](int trial, RandomStream& random) {
    const int sets = 2 + trial % 5;
    const int per_set = 2 + static_cast<int>(random.below(9));
    return instances::random_columns(sets, per_set, 10 + static_cast<int>(random.below(120)),
                                     weights(trial / 5), random);
  });
}

TEST_F(PackingOracle, DenseCubesOfTwoToSixSetsHaveTheSameOptimum) {
  compare(525, 2, [](int trial, RandomStream& random) {
    const int sets = 2 + trial % 5;
    const int most[] = {9, 6, 4, 3, 2};
    const int per_set =
        2 + static_cast<int>(random.below(static_cast<std::uint64_t>(most[trial % 5] - 1)));
    return instances::cube(sets, per_set, weights(trial / 5), random);
  });
}

TEST_F(PackingOracle, TrianglesHaveTheSameOptimum) {
  compare(500, 3, [](int trial, RandomStream& random) {
    return instances::triangles(1 + trial % 12, random);
  });
}

TEST_F(PackingOracle, SmallScenesHaveTheSameOptimum) {
  compare(500, 4, [](int trial, RandomStream& random) {
    auto scene = scenes::box(6 + trial % 10, 2 + trial % 5, random);
    scene.noise_rad = random.uniform(2e-3, 1e-2);
    scene.false_alarms = static_cast<double>(random.below(4));
    return scenes::packing_of(scene, random);
  });
}

TEST_F(PackingOracle, LinesAndGridsOfTwentyHaveTheSameOptimum) {
  compare(24, 5, [](int trial, RandomStream& random) {
    const double spacing = trial % 4 < 2 ? 1 : 0.5;
    const auto scene =
        trial % 2 == 0 ? scenes::line(20, spacing, random) : scenes::grid(20, spacing, random);
    return scenes::packing_of(scene, random);
  });
}

TEST_F(PackingOracle, TriangulatedScenesHaveTheSameOptimum) {
  compare(60, 6, [](int trial, RandomStream& random) {
    const int sensors = 2 + trial % 5;
    return scenes::triangulated(
        scenes::crowd(6 + trial % 10, sensors, random.uniform(2e-3, 1e-2), trial % 4),
        static_cast<std::uint64_t>(trial));
  });
}

}  // namespace
}  // namespace scanfuse::associate
