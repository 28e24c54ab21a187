#include "engine/input/file_text.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "engine/errors.h"
#include "engine/input/place.h"

namespace plumb {

FileText read_file_text(const std::string& path) {
  constexpr std::size_t longest = 64 * 1024 * 1024;
  const auto failed = [] { return FileText{"", std::generic_category().message(errno)}; };
  // std::ifstream opens a folder and then reads nothing from it, without saying why.
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return failed();
  std::string text;
  std::array<char, 65536> part{};
  for (;;) {
    const std::size_t count = std::fread(part.data(), 1, part.size(), file.get());
    if (count == 0 && std::ferror(file.get()) != 0) return failed();
    if (count == 0) return {std::move(text), ""};
    if (text.size() + count > longest) return {"", "longer than 64 MiB"};
    text.append(part.data(), count);
  }
}

std::string read_whole_file(const std::string& path) {
  FileText file = read_file_text(path);
  if (!file.failure.empty())
    throw InputError(one_line(fmt::format("{}: cannot be read: {}", path, file.failure)));
  return std::move(file.text);
}

}  // namespace plumb
