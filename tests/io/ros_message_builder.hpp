#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace scanfuse::io::ros {

/// Serialises messages by hand for tests: ROS 1, or CDR in either byte order.
class MessageBuilder {
 public:
  enum class Form { kRos1, kCdrLittle, kCdrBig, kCdr2Little };
  explicit MessageBuilder(Form form) : form_(form) {
    if (form == Form::kCdrLittle) raw({0, 1, 0, 0});
    if (form == Form::kCdrBig) raw({0, 0, 0, 0});
    if (form == Form::kCdr2Little) raw({0, 7, 0, 0});
  }

  template <class T>
  MessageBuilder& put(T value) {
    const std::size_t widest = form_ == Form::kCdr2Little ? 4 : 8;
    const std::size_t step = form_ == Form::kRos1 ? 1 : std::min(sizeof(T), widest);
    while (bytes_.size() % step != (form_ == Form::kRos1 ? 0 : 4 % step)) bytes_.push_back({});
    std::byte image[sizeof(T)];
    std::memcpy(image, &value, sizeof(T));
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      bytes_.push_back(image[form_ == Form::kCdrBig ? sizeof(T) - 1 - i : i]);
    }
    return *this;
  }
  template <class T>
  MessageBuilder& put_all(const std::vector<T>& values) {
    for (const T value : values) put(value);
    return *this;
  }
  template <class T>
  MessageBuilder& sequence(const std::vector<T>& values) {
    put(static_cast<std::uint32_t>(values.size()));
    return put_all(values);
  }
  MessageBuilder& text(std::string_view value) {
    const bool closed = form_ != Form::kRos1;
    put(static_cast<std::uint32_t>(value.size() + (closed ? 1 : 0)));
    for (const char c : value) bytes_.push_back(static_cast<std::byte>(c));
    if (closed) bytes_.push_back({});
    return *this;
  }
  MessageBuilder& header(std::uint32_t seconds, std::uint32_t nanos, std::string_view frame_id) {
    if (form_ == Form::kRos1) put(std::uint32_t{77});
    return put(seconds).put(nanos).text(frame_id);
  }
  [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  void raw(std::initializer_list<int> values) {
    for (const int value : values) bytes_.push_back(static_cast<std::byte>(value));
  }
  Form form_;
  std::vector<std::byte> bytes_;
};

}  // namespace scanfuse::io::ros
