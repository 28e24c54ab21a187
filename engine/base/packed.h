#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plumb {

/// Puts numbers and texts one after another, as `Unpacked` takes them apart.
class Packed {
 public:
  Packed& add(std::uint64_t number) { return add_raw(&number, sizeof number); }
  Packed& add(std::string_view text) { return add(text.size()).add_raw(text.data(), text.size()); }
  Packed& add(const std::vector<std::string>& texts) {
    add(texts.size());
    for (const std::string& text : texts) add(text);
    return *this;
  }
  template <class Number>
  Packed& add(const std::vector<Number>& numbers) {
    static_assert(sizeof(Number) == 8);
    return add(numbers.size()).add_raw(numbers.data(), sizeof(Number) * numbers.size());
  }
  std::string take() { return std::move(bytes_); }

 private:
  Packed& add_raw(const void* from, std::size_t count) {
    if (count > 0) bytes_.append(static_cast<const char*>(from), count);
    return *this;
  }
  std::string bytes_;
};

/// Takes apart what was packed, in the same order. Trusts nothing: whatever packed it may have been taken
/// over. Throws std::runtime_error where there is less than what is asked for.
class Unpacked {
 public:
  explicit Unpacked(const std::string& bytes) : rest_(bytes) {}

  std::uint64_t number() {
    std::uint64_t result = 0;
    std::memcpy(&result, take(1, sizeof result).data(), sizeof result);
    return result;
  }
  std::string text() { return std::string(take(number(), 1)); }
  std::vector<std::string> texts() {
    std::vector<std::string> result;
    for (std::uint64_t count = number(); count > 0; --count) result.push_back(text());
    return result;
  }
  template <class Number>
  std::vector<Number> numbers() {
    static_assert(sizeof(Number) == 8);
    const std::string_view raw = take(number(), sizeof(Number));
    std::vector<Number> result(raw.size() / sizeof(Number));
    if (!raw.empty()) std::memcpy(result.data(), raw.data(), raw.size());
    return result;
  }

 private:
  std::string_view take(std::uint64_t count, std::size_t size) {
    if (count > rest_.size() / size) throw std::runtime_error("it is damaged or hostile (half an answer)");
    const std::string_view taken = rest_.substr(0, count * size);
    rest_.remove_prefix(taken.size());
    return taken;
  }
  std::string_view rest_;
};

}  // namespace plumb
