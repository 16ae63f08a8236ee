#include "scanfuse/drivers/sick/cola.hpp"

namespace scanfuse::drivers::sick {
namespace {

constexpr std::byte kStx{2};
constexpr std::byte kEtx{3};
constexpr std::size_t kHead = 8;  // four STX and the length
constexpr std::size_t kLongest = std::size_t{1} << 16;

std::byte checksum(ByteView content) {
  std::byte sum{0};
  for (const std::byte b : content) sum ^= b;
  return sum;
}

std::size_t starts(ByteView bytes) {
  std::size_t count = 0;
  while (count < bytes.size() && count < 4 && bytes[count] == kStx) ++count;
  return count;
}

/// Every content starts with "s" and what kind of telegram it is.
bool is_content(ByteView content) { return content.empty() || content[0] == std::byte{'s'}; }

Cut cut_binary(ByteView bytes) {
  if (bytes.size() < kHead) return {};
  const auto length = BigReader(bytes.subspan(4)).read<std::uint32_t>();
  if (length == 0 || length > kLongest || !is_content(bytes.subspan(kHead))) return {1, 0};
  const std::size_t whole = kHead + length + 1;
  if (bytes.size() < whole) return {};
  if (checksum(bytes.subspan(kHead, length)) != bytes[whole - 1]) return {1, 0};
  return {0, whole};
}

Cut cut_text(ByteView bytes) {
  if (!is_content(bytes.subspan(1))) return {1, 0};
  const std::size_t end = until(bytes, kEtx);
  if (end < bytes.size()) return {0, end + 1};
  return bytes.size() > kLongest ? Cut{1, 0} : Cut{};
}

}  // namespace

Cut cut_cola(ByteView bytes) {
  const std::size_t count = starts(bytes);
  if (count == 0) return {until(bytes, kStx), 0};
  if (count == 4) return cut_binary(bytes);
  if (count == bytes.size()) return {};
  return count == 1 ? cut_text(bytes) : Cut{count - 1, 0};
}

ColaTelegram open_cola(ByteView telegram) {
  if (starts(telegram) == 4)
    return {Cola::kB, telegram.subspan(kHead, telegram.size() - kHead - 1)};
  return {Cola::kA, telegram.subspan(1, telegram.size() - 2)};
}

Bytes close_cola(Cola dialect, ByteView content) {
  Bytes telegram;
  if (dialect == Cola::kA) {
    telegram.push_back(kStx);
    append(telegram, content);
    telegram.push_back(kEtx);
    return telegram;
  }
  telegram.assign(4, kStx);
  BigWriter(telegram).write(static_cast<std::uint32_t>(content.size()));
  append(telegram, content);
  telegram.push_back(checksum(content));
  return telegram;
}

Bytes scan_request(Cola dialect, bool on) {
  Bytes content;
  append(content, view_of("sEN LMDscandata "));
  content.push_back(dialect == Cola::kA ? std::byte(on ? '1' : '0') : std::byte(on ? 1 : 0));
  return close_cola(dialect, content);
}

}  // namespace scanfuse::drivers::sick
