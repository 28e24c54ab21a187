#include "engine/base/checked_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <stdexcept>
#include <string_view>
#include <utility>

#include "engine/base/file_text.h"

namespace plumb {
namespace {

constexpr std::string_view mark = "plumb-crc32 ";
constexpr std::size_t sum_digits = 8;

std::string check_sum(std::string_view bytes) {
  return fmt::format("{:08x}", crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace

std::string with_check_sum(std::string bytes) {
  const std::string sum = check_sum(bytes);
  return bytes.append(mark).append(sum);
}

std::string without_check_sum(std::string bytes, const std::string& kind) {
  const std::size_t ending = mark.size() + sum_digits;
  if (bytes.size() < ending || bytes.compare(bytes.size() - ending, mark.size(), mark) != 0)
    throw std::runtime_error("it is no " + kind + ", or it was cut short");
  const std::string sum = bytes.substr(bytes.size() - sum_digits);
  bytes.resize(bytes.size() - ending);
  if (check_sum(bytes) != sum) throw std::runtime_error("it was damaged or changed after it was written");
  return bytes;
}

std::string read_checked(const std::string& path, const std::string& kind) {
  FileText file = read_file_text(path, InputKind::run_file);
  if (!file.failure.empty()) throw std::runtime_error(file.failure);
  return without_check_sum(std::move(file.text), kind);
}

}  // namespace plumb
