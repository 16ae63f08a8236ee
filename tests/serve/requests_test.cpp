#include "scanfuse/serve/requests.hpp"

#include <gtest/gtest.h>

#include <string>

namespace scanfuse::serve {
namespace {

template <class T>
T parsed(std::string_view text) {
  const auto request = parse_request(text);
  EXPECT_TRUE(request) << text << ": " << request.error().message;
  return request && std::holds_alternative<T>(*request) ? std::get<T>(*request) : T{};
}

TEST(Requests, AreReadWithTheirNumbers) {
  EXPECT_EQ(parsed<FrameRequest>(R"({"op":"frame","run":1,"frame":77})").frame, 77U);
  EXPECT_EQ(parsed<FrameRequest>(R"({"op":"frame","run":1,"frame":77})").run, RunName::kTrial);
  EXPECT_EQ(parsed<IndexRequest>(R"({"op":"index","from":4294967295})").from, 4294967295U);
  EXPECT_EQ(parsed<HistoryRequest>(R"({"op":"history","track":-3})").track, -3);
  const auto tune = parsed<TuneRequest>(R"({"op":"tune","from":5,"changes":["track.gate=9"]})");
  EXPECT_EQ(tune.changes, std::vector<std::string>{"track.gate=9"});
  const auto label = parsed<LabelRequest>(
      R"({"op":"label","action":"correct","frame":3,"object":2,"x_m":1.5,"y_m":-2,)"
      R"("heading_rad":0.1,"length_m":4,"width_m":2})");
  EXPECT_EQ(label.box.centre_m, Eigen::Vector2d(1.5, -2));
}

TEST(Requests, WhatIsWrongIsSaidInWords) {
  for (const std::string& text :
       {std::string(""),
        std::string("["),
        std::string("[]"),
        std::string("7"),
        std::string("null"),
        std::string(R"({"op":7})"),
        std::string(R"({"op":"fly"})"),
        std::string(R"({})"),
        std::string(R"({"op":"frame","frame":-1})"),
        std::string(R"({"op":"frame","frame":1.5})"),
        std::string(R"({"op":"frame","frame":4294967296})"),
        std::string(R"({"op":"frame","frame":"7"})"),
        std::string(R"({"op":"frame","run":2})"),
        std::string(R"({"op":"frame","frame":1e400})"),
        std::string(R"({"op":"trails","length":201})"),
        std::string(R"({"op":"tune","changes":"track.gate=9"})"),
        std::string(R"({"op":"tune","changes":[9]})"),
        std::string(R"({"op":"label","action":"eat"})"),
        std::string(R"({"op":"label","action":"class","class":"tank"})"),
        std::string(R"({"op":"label","action":"correct","object":1,"x_m":1,"y_m":1,)"
                    R"("heading_rad":0,"length_m":-4,"width_m":2})"),
        std::string(R"({"op":"label","action":"correct","object":1,"x_m":1e9})"),
        std::string(100000, '['),
        std::string("\xff\xfe\x00", 3)}) {
    const auto request = parse_request(text);
    ASSERT_FALSE(request) << text.substr(0, 80);
    EXPECT_FALSE(request.error().message.empty());
  }
}

}  // namespace
}  // namespace scanfuse::serve
