#include "scanfuse/io/spool.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace scanfuse::io {
namespace {

TEST(Spool, GivesBackWhatWasPutInAnyOrder) {
  auto spool = Spool::create();
  ASSERT_TRUE(spool) << spool.error().message;
  std::vector<Spool::Place> places;
  for (int i = 0; i < 50; ++i) {
    const auto place =
        spool->put(std::string(static_cast<std::size_t>(i * 37), static_cast<char>('a' + i % 26)));
    ASSERT_TRUE(place);
    places.push_back(*place);
  }
  for (int i = 49; i >= 0; --i) {
    const auto bytes = spool->get(places[static_cast<std::size_t>(i)]);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(*bytes,
              std::string(static_cast<std::size_t>(i * 37), static_cast<char>('a' + i % 26)));
  }
}

TEST(Spool, PacksWhatRepeats) {
  auto spool = Spool::create();
  ASSERT_TRUE(spool);
  ASSERT_TRUE(spool->put(std::string(1 << 20, 'x')));
  EXPECT_LT(spool->bytes(), 1000U);
}

TEST(Spool, APlaceThatWasNeverGivenIsAnError) {
  auto spool = Spool::create();
  ASSERT_TRUE(spool);
  EXPECT_FALSE(spool->get({100, 20, 40}));
  const auto place = spool->put(std::string("text"));
  ASSERT_TRUE(place);
  EXPECT_FALSE(spool->get({place->offset, place->stored, place->size + 1}));
}

TEST(Spool, SeveralThreadsMayUseIt) {
  auto spool = Spool::create();
  ASSERT_TRUE(spool);
  std::vector<std::thread> threads;
  for (char name : {'a', 'b', 'c'}) {
    threads.emplace_back([&spool, name] {
      for (int i = 0; i < 200; ++i) {
        const auto place = spool->put(std::string(500, name));
        EXPECT_EQ(*spool->get(*place), std::string(500, name));
      }
    });
  }
  for (auto& thread : threads) thread.join();
}

}  // namespace
}  // namespace scanfuse::io
