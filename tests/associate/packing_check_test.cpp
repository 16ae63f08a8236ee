#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "associate/packing_instances.hpp"
#include "scanfuse/associate/packing.hpp"

// Certificates are damaged; the checker must notice.
namespace scanfuse::associate {
namespace {

using instances::solved;
using Kind = ProofStep::Kind;

/// Triangles joined to each other: proved by prices, splits and branches.
Packing hard_packing(std::uint64_t seed) {
  RandomStream random(seed);
  return instances::triangles(8, random);
}

/// The first step of a kind that meets a condition.
ProofStep& step_of(
    PackingSolution& solution, Kind kind,
    const std::function<bool(const ProofStep&)>& is_right = [](auto&) { return true; }) {
  for (auto& step : solution.proof) {
    if (step.kind == kind && is_right(step)) return step;
  }
  ADD_FAILURE() << "no such step in the proof";
  return solution.proof[0];
}

class Damage : public testing::Test {
 protected:
  void expect_noticed(const std::function<void(PackingSolution&)>& damage,
                      const std::string& words) {
    const Packing packing = hard_packing(3);
    auto solution = solved(packing);
    damage(solution);
    const auto checked = check_bound(packing, solution);
    ASSERT_FALSE(checked);
    EXPECT_THAT(checked.error().message, testing::HasSubstr(words));
  }
};

TEST_F(Damage, ToThePackingIsNoticed) {
  expect_noticed([](auto& s) { s.chosen.pop_back(); }, "chosen columns weigh");
  expect_noticed([](auto& s) { s.chosen.push_back(s.chosen.back() + 1); }, "used twice");
  expect_noticed([](auto& s) { s.chosen.push_back(1000); }, "out of range");
  expect_noticed([](auto& s) { std::swap(s.chosen[0], s.chosen[1]); }, "order");
  expect_noticed([](auto& s) { s.primal += 1e-3; }, "chosen columns weigh");
}

TEST_F(Damage, ToTheComponentsIsNoticed) {
  expect_noticed([](auto& s) { s.components[0].columns.pop_back(); }, "is in no component");
  expect_noticed([](auto& s) { s.components[0].columns.push_back(0); }, "in two components");
  expect_noticed([](auto& s) { s.components[0].primal += 1e-3; }, "chosen columns weigh");
  expect_noticed([](auto& s) { s.components[0].proof = -1; }, "has no proof");
  expect_noticed([](auto& s) { s.components.pop_back(); }, "is in no component");
}

TEST_F(Damage, ToTheBoundIsNoticed) {
  expect_noticed(
      [](auto& s) {
        s.components[0].dual -= 1e-3;
        s.dual -= 1e-3;
      },
      "proved is");
  expect_noticed([](auto& s) { s.dual += 1e-3; }, "sum up to");
  expect_noticed(
      [](auto& s) {
        s.components[0].dual += 1e-3;
        s.dual += 1e-3;
      },
      "has a gap and says that it has none");
}

TEST_F(Damage, ToPricesIsNoticed) {
  const auto leaf = [](const ProofStep& step) { return step.children.empty(); };
  expect_noticed(
      [&](auto& s) {
        for (auto& price : step_of(s, Kind::kPrices, leaf).prices) price *= 0.999;
      },
      "short of its weight");
  expect_noticed([&](auto& s) { step_of(s, Kind::kPrices, leaf).prices[0] = -1; }, "the price of");
  expect_noticed(
      [&](auto& s) {
        step_of(s, Kind::kPrices, leaf).prices[0] = std::numeric_limits<double>::quiet_NaN();
      },
      "the price of");
  expect_noticed([&](auto& s) { step_of(s, Kind::kPrices, leaf).prices.pop_back(); }, "prices");
}

TEST_F(Damage, ToColumnsSetAsideIsNoticed) {
  const auto inner = [](const ProofStep& step) {
    return step.children.size() == 1 && step.children[0] >= 0;
  };
  expect_noticed([&](auto& s) { step_of(s, Kind::kPrices, inner).children[0] = -1; },
                 "set aside without reason");
  expect_noticed(
      [&](auto& s) {
        const auto drops_some = [&](const ProofStep& step) {
          return inner(step) && s.proof[static_cast<std::size_t>(step.children[0])].columns.size() <
                                    step.columns.size();
        };
        step_of(s, Kind::kPrices, drops_some).threshold -= 5;
      },
      "set aside without reason");
  expect_noticed(
      [](auto& s) {
        const auto root = static_cast<std::size_t>(s.components[0].proof);
        ASSERT_FALSE(s.proof[root].children.empty());
        s.proof[root].threshold += 5;
      },
      "proved is");
}

TEST_F(Damage, ToBranchesIsNoticed) {
  expect_noticed([](auto& s) { step_of(s, Kind::kBranch).children[1] = -1; }, "is forgotten");
  expect_noticed([](auto& s) { step_of(s, Kind::kBranch).children[0] = 100000; }, "before it");
  expect_noticed([](auto& s) { step_of(s, Kind::kBranch).branch_column = -1; }, "needs a column");
  expect_noticed([](auto& s) { step_of(s, Kind::kBranch).children.pop_back(); }, "two children");
}

TEST_F(Damage, ToSplitsIsNoticed) {
  expect_noticed([](auto& s) { step_of(s, Kind::kSplit).children.pop_back(); }, "is in no part");
  expect_noticed([](auto& s) { step_of(s, Kind::kSplit).children[0] = -1; }, "a part is missing");
}

// Steps that claim the same column twice, in parts that share its rows, would count too little.
TEST_F(Damage, PartsThatShareRowsAreNoticed) {
  expect_noticed(
      [](auto& s) {
        auto& split = step_of(s, Kind::kSplit);
        const auto first = static_cast<std::size_t>(split.children[0]);
        const auto second = static_cast<std::size_t>(split.children[1]);
        auto& columns = s.proof[first].columns;
        const auto& others = s.proof[second].columns;
        columns.insert(columns.end(), others.begin(), others.end());
      },
      "");
}

// Whatever number of a proof is changed: either the checker refuses it or the bound still holds.
TEST(CheckBound, NoDamagedProofLowersTheBoundUnnoticed) {
  int noticed = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Packing packing = hard_packing(seed % 10);
    const auto honest = solved(packing);
    auto solution = honest;
    RandomStream random(seed, 9);
    auto& step = solution.proof[random.below(solution.proof.size())];
    switch (random.below(5)) {
      case 0:
        if (!step.prices.empty()) step.prices[random.below(step.prices.size())] *= 0.9;
        break;
      case 1:
        if (!step.columns.empty()) {
          step.columns.erase(step.columns.begin() +
                             static_cast<std::ptrdiff_t>(random.below(step.columns.size())));
        }
        break;
      case 2:
        step.threshold -= 0.1;
        break;
      case 3:
        if (!step.children.empty()) {
          step.children[0] = static_cast<std::int32_t>(random.below(solution.proof.size()));
        }
        break;
      default:
        step.branch_column = static_cast<std::int32_t>(random.below(packing.columns()));
    }
    for (auto& component : solution.components) {
      const double lower = 0.01;
      component.dual -= lower;
      solution.dual -= lower;
      component.proved = false;
    }
    solution.proved = false;
    noticed += check_bound(packing, solution) ? 0 : 1;
  }
  EXPECT_EQ(noticed, 400);
}

}  // namespace
}  // namespace scanfuse::associate
