#include "engine/base/beneath.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace plumb {
namespace {

constexpr int folder_flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

bool is_name_beneath(std::string_view name) {
  constexpr std::size_t longest = 4000;
  if (name.empty() || name.size() > longest || name.find('\0') != std::string_view::npos) return false;
  for (std::size_t from = 0; from <= name.size();) {
    const std::size_t end = std::min(name.find('/', from), name.size());
    const std::string_view part = name.substr(from, end - from);
    if (part.empty() || part == "." || part == "..") return false;
    from = end + 1;
  }
  return true;
}

Beneath find_beneath(int root, const std::string& name, bool make) {
  Descriptor folder(::openat(root, ".", folder_flags));
  std::size_t from = 0;
  for (std::size_t end; folder && (end = name.find('/', from)) != std::string::npos; from = end + 1) {
    const std::string part = name.substr(from, end - from);
    Descriptor below(::openat(folder.get(), part.c_str(), folder_flags));
    if (!below && errno == ENOENT && make) {
      if (::mkdirat(folder.get(), part.c_str(), 0777) != 0 && errno != EEXIST) return {};
      below = Descriptor(::openat(folder.get(), part.c_str(), folder_flags));
    }
    folder = std::move(below);
  }
  return {std::move(folder), name.substr(from)};
}

Descriptor open_folder(const std::string& path) {
  return Descriptor(::open(path.c_str(), folder_flags));
}

std::optional<std::vector<Entry>> entries_of(int folder) {
  Descriptor copy(::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  DIR* list = copy ? ::fdopendir(copy.get()) : nullptr;
  if (list == nullptr) return {};
  copy.release();  // closed with the list
  std::vector<Entry> entries;
  while (const dirent* entry = ::readdir(list)) {
    const std::string name = entry->d_name;
    struct stat status {};
    if (name == "." || name == ".." || ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
      continue;
    entries.push_back({name, S_ISDIR(status.st_mode), S_ISREG(status.st_mode)});
  }
  ::closedir(list);
  return entries;
}

int flush_to_disk(int descriptor) {
  while (::fsync(descriptor) != 0) {
    if (errno == EINTR) continue;
    return errno == EINVAL || errno == ENOTSUP || errno == ENOSYS ? 0 : errno;
  }
  return 0;
}

}  // namespace plumb
