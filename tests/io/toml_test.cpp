#include "scanfuse/io/toml.hpp"

#include <gmock/gmock.h>

#include "scanfuse/core/random.hpp"

namespace scanfuse::io {
namespace {

using ::testing::HasSubstr;

std::string fault_of_toml(std::string_view text) {
  const auto parsed = parse_toml(text, "c.toml");
  return parsed ? "none" : parsed.error().message;
}

TEST(Toml, EntriesComeInTheFilesOrderWithTheirPlace) {
  const auto parsed = parse_toml(
      "top = true\n[segment]\nradius_m = 0.5\nmethod = \"pag\"\n\n[track.gate]\nframes = -3\n",
      "c.toml");
  ASSERT_TRUE(parsed) << parsed.error().message;
  ASSERT_EQ(parsed->size(), 4u);
  EXPECT_EQ((*parsed)[0].section, "");
  EXPECT_EQ((*parsed)[0].value, "true");
  EXPECT_EQ((*parsed)[1].section, "segment");
  EXPECT_EQ((*parsed)[1].key, "radius_m");
  EXPECT_EQ((*parsed)[1].value, "0.5");
  EXPECT_EQ((*parsed)[1].line, 3);
  EXPECT_EQ((*parsed)[2].value, "pag");
  EXPECT_EQ((*parsed)[3].section, "track.gate");
  EXPECT_EQ((*parsed)[3].value, "-3");
}

TEST(Toml, FaultsNameLineAndColumn) {
  EXPECT_THAT(fault_of_toml("a = 1\na = 2\n"), HasSubstr("c.toml:2:"));
  EXPECT_THAT(fault_of_toml("[s]\nb = [1, 2]\n"), HasSubstr("c.toml:2:5: b needs one value"));
  EXPECT_THAT(fault_of_toml("d = 2020-01-01\n"), HasSubstr("c.toml:1:"));
  EXPECT_THAT(fault_of_toml("d = nan\n"), HasSubstr("not a finite number"));
  EXPECT_THAT(fault_of_toml("d = inf\n"), HasSubstr("not a finite number"));
  EXPECT_THAT(fault_of_toml("[s\n"), HasSubstr("c.toml:1:"));
  EXPECT_THAT(fault_of_toml("[[s]]\na = 1\n"), HasSubstr("c.toml:1:"));
  EXPECT_FALSE(read_toml("/no/such/file.toml"));
}

TEST(Toml, WhatIsWrittenReadsBack) {
  const std::vector<OptionView> options = {
      {"segment", "radius_m", "0.5", "0.4", "0.01 .. 10", "two points closer are neighbours",
       false},
      {"segment", "method", "a \"b\" \\ c", "pag", "", "which", true},
      {"track", "confirm", "false", "true", "true | false", "whether", false}};
  const std::string text = write_toml(options);
  EXPECT_THAT(text, HasSubstr("# two points closer are neighbours"));
  const auto parsed = parse_toml(text, "c.toml");
  ASSERT_TRUE(parsed) << parsed.error().message << text;
  ASSERT_EQ(parsed->size(), options.size());
  for (std::size_t k = 0; k < options.size(); ++k) {
    EXPECT_EQ((*parsed)[k].section, options[k].section);
    EXPECT_EQ((*parsed)[k].key, options[k].name);
    EXPECT_EQ((*parsed)[k].value, options[k].value);
  }
}

TEST(Toml, AnyBytesGiveEntriesOrAnError) {
  const std::string whole = "top = true\n[segment]\nradius_m = 0.5\nmethod = \"pag\"\n";
  RandomStream random(1);
  for (int round = 0; round < 2000; ++round) {
    std::string flipped = whole.substr(0, random.below(whole.size() + 1));
    if (!flipped.empty()) {
      flipped[random.below(flipped.size())] ^= static_cast<char>(1 << random.below(8));
    }
    (void)parse_toml(flipped, "c.toml");
  }
  EXPECT_NE(fault_of_toml(std::string(5000, '[')), "none");
}

}  // namespace
}  // namespace scanfuse::io
