#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "io/temporary_folder.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/io/pcap/payload_reader.hpp"

namespace scanfuse::io::pcap {
namespace {

using ::testing::ElementsAre;

/// Numbers in either byte order.
struct Out {
  bool big = false;
  std::string bytes = {};
  template <class T>
  Out& add(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      const std::size_t shift = 8 * (big ? sizeof(T) - 1 - i : i);
      bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> shift);
    }
    return *this;
  }
  Out& text(const std::string& more) {
    bytes += more;
    return *this;
  }
};

std::string ipv4(int protocol, const std::string& body, std::uint16_t fragment = 0,
                 std::uint16_t id = 7) {
  Out ip{true};
  ip.add(std::uint8_t{0x45}).add(std::uint8_t{0});
  ip.add(static_cast<std::uint16_t>(20 + body.size())).add(id).add(fragment);
  ip.add(std::uint8_t{64}).add(static_cast<std::uint8_t>(protocol)).add(std::uint16_t{0});
  ip.add(std::uint32_t{0xC0A80001}).add(std::uint32_t{0xC0A80064});
  return std::string(12, 'e') + std::string("\x08\x00", 2) + ip.bytes + body;
}

std::string udp(const std::string& body) {
  Out out{true};
  out.add(std::uint16_t{2368}).add(std::uint16_t{2368});
  out.add(static_cast<std::uint16_t>(8 + body.size())).add(std::uint16_t{0});
  return out.bytes + body;
}

std::string tcp(std::uint32_t sequence, const std::string& body, bool syn = false) {
  Out out{true};
  out.add(std::uint16_t{2112}).add(std::uint16_t{40000}).add(sequence).add(std::uint32_t{0});
  out.add(std::uint8_t{0x50}).add(static_cast<std::uint8_t>(syn ? 2 : 16));
  out.add(std::uint16_t{1000}).add(std::uint32_t{0});
  return ipv4(6, out.bytes + body);
}

std::string classic(const std::vector<std::string>& packets, bool big = false, bool nanos = false) {
  Out out{big};
  out.add(std::uint32_t{nanos ? 0xA1B23C4D : 0xA1B2C3D4}).add(std::uint16_t{2});
  out.add(std::uint16_t{4}).add(std::uint64_t{0}).add(std::uint32_t{65535}).add(std::uint32_t{1});
  std::uint32_t at = 100;
  for (const auto& packet : packets) {
    const auto size = static_cast<std::uint32_t>(packet.size());
    out.add(at++).add(std::uint32_t{250}).add(size).add(size).text(packet);
  }
  return out.bytes;
}

std::string next_generation(const std::vector<std::string>& packets, bool big = false) {
  Out out{big};
  out.add(std::uint32_t{0x0A0D0D0A}).add(std::uint32_t{28}).add(std::uint32_t{0x1A2B3C4D});
  out.add(std::uint32_t{1}).add(std::uint64_t{~0ULL}).add(std::uint32_t{28});
  // An interface whose ticks are nanoseconds.
  out.add(std::uint32_t{1}).add(std::uint32_t{32}).add(std::uint16_t{1}).add(std::uint16_t{0});
  out.add(std::uint32_t{65535}).add(std::uint16_t{9}).add(std::uint16_t{1}).text("\x09");
  out.text(std::string(3, '\0')).add(std::uint32_t{0}).add(std::uint32_t{32});
  std::uint64_t at = 100'000'250'000;
  for (const auto& packet : packets) {
    const std::size_t padded = (packet.size() + 3) / 4 * 4;
    const auto size = static_cast<std::uint32_t>(32 + padded);
    out.add(std::uint32_t{6}).add(size).add(std::uint32_t{0});
    out.add(static_cast<std::uint32_t>(at >> 32)).add(static_cast<std::uint32_t>(at));
    out.add(static_cast<std::uint32_t>(packet.size()));
    out.add(static_cast<std::uint32_t>(packet.size())).text(packet);
    out.text(std::string(padded - packet.size(), '\0')).add(size);
    at += 1'000'000'000;
  }
  return out.bytes;
}

struct Said {
  std::vector<std::string> texts;
  std::vector<Time> times;
  Diagnostics diagnostics;
};

Said listen(const std::string& file) {
  Said said;
  auto packets = PacketReader::open("test.pcap", open_memory("test.pcap", file));
  EXPECT_TRUE(packets) << packets.error().message;
  if (!packets) return said;
  PayloadReader payloads(std::move(*packets));
  while (auto payload = payloads.next()) {
    said.texts.emplace_back(reinterpret_cast<const char*>(payload->bytes.data()),
                            payload->bytes.size());
    said.times.push_back(payload->time);
  }
  said.diagnostics = payloads.diagnostics();
  return said;
}

TEST(Pcap, GivesDatagramsInEveryFormat) {
  const std::vector<std::string> packets{ipv4(17, udp("one")), ipv4(17, udp("three"))};
  for (const auto& file : {classic(packets), classic(packets, true), next_generation(packets),
                           next_generation(packets, true)}) {
    const Said said = listen(file);
    EXPECT_THAT(said.texts, ElementsAre("one", "three"));
    ASSERT_EQ(said.times.size(), 2U);
    EXPECT_EQ(to_nanos(said.times[0]), 100'000'250'000);
    EXPECT_EQ(to_nanos(said.times[1]), 101'000'250'000);
    EXPECT_TRUE(said.diagnostics.empty());
  }
  EXPECT_EQ(to_nanos(listen(classic(packets, false, true)).times[0]), 100'000'000'250);
}

TEST(Pcap, PutsStreamsInOrder) {
  const auto first = tcp(1000, "", true);
  const Said said = listen(classic({first, tcp(1001, "ab"), tcp(1006, "fg"), tcp(1003, "cde"),
                                    tcp(1001, "ab"), tcp(1005, "efgh")}));
  std::string all;
  for (const auto& text : said.texts) all += text;
  EXPECT_EQ(all, "abcdefgh");
}

TEST(Pcap, SaysWhereAConnectionStarts) {
  const auto file = classic(
      {tcp(10, "", true), tcp(11, "ab"), tcp(13, "cd"), tcp(900, "", true), tcp(901, "ef")});
  auto packets = PacketReader::open("test.pcap", open_memory("test.pcap", file));
  ASSERT_TRUE(packets);
  PayloadReader payloads(std::move(*packets));
  std::vector<bool> starts;
  while (const auto payload = payloads.next()) starts.push_back(payload->start);
  EXPECT_THAT(starts, ElementsAre(true, false, true));
}

TEST(Pcap, GoesOnBehindAGap) {
  std::vector<std::string> packets{tcp(1, "ab")};
  for (std::uint32_t i = 0; i < 70; ++i) packets.push_back(tcp(100 + i, "x"));
  const Said said = listen(classic(packets));
  std::string all;
  for (const auto& text : said.texts) all += text;
  EXPECT_EQ(all, "ab" + std::string(70, 'x'));
  EXPECT_EQ(said.diagnostics.count("gap in a captured stream"), 1);
}

TEST(Pcap, PutsFragmentsTogether) {
  const std::string whole = udp(std::string(3000, 'y'));
  const auto part = [&](std::size_t from, std::size_t count, bool more) {
    return ipv4(17, whole.substr(from, count),
                static_cast<std::uint16_t>((more ? 0x2000 : 0) | from / 8));
  };
  const Said said = listen(classic({part(1480, 1480, true), part(2960, 48, false),
                                    ipv4(17, udp("between")), part(0, 1480, true)}));
  EXPECT_THAT(said.texts, ElementsAre("between", std::string(3000, 'y')));
}

TEST(Pcap, ThatWasCutOffGivesWhatWasBefore) {
  const std::vector<std::string> packets{ipv4(17, udp("one")), ipv4(17, udp("two"))};
  for (const auto& file : {classic(packets), next_generation(packets)}) {
    const Said said = listen(file.substr(0, file.size() - 10));
    EXPECT_THAT(said.texts, ElementsAre("one"));
    EXPECT_TRUE(said.diagnostics.any_damage());
  }
}

TEST(Pcap, IsRefusedWhereItIsNone) {
  for (const std::string& file :
       {std::string(), std::string("PK\x03\x04"), std::string(100, 'x')}) {
    const auto packets = PacketReader::open("test.pcap", open_memory("test.pcap", file));
    ASSERT_FALSE(packets);
    EXPECT_THAT(packets.error().message, ::testing::HasSubstr("test.pcap"));
  }
}

TEST(Pcap, EndsOnAnyDamage) {
  const std::string good = next_generation({tcp(1, "abc"), ipv4(17, udp("one")), tcp(4, "def")});
  RandomStream random(4);
  for (int round = 0; round < 2000; ++round) {
    std::string file = good;
    for (int i = 0; i < 3; ++i)
      file[random.below(file.size())] = static_cast<char>(random.below(256));
    auto packets = PacketReader::open("test.pcap", open_memory("test.pcap", file));
    if (!packets) continue;
    PayloadReader payloads(std::move(*packets));
    for (int i = 0; i < 10; ++i) (void)payloads.next();
  }
}

}  // namespace
}  // namespace scanfuse::io::pcap
