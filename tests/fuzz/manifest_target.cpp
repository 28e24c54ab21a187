#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "engine/base/manifest.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {
namespace {

namespace fs = std::filesystem;

/// A folder in memory with nothing but a manifest, removed with it.
class Folder {
 public:
  Folder() : path_(fmt::format("/dev/shm/plumb-fuzz-{}-folder", ::getpid())) {
    fs::create_directories(path_);
    open_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    promise(open_ >= 0, path_ + " cannot be opened");
  }
  ~Folder() {
    ::close(open_);
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  FoundManifest find(std::string_view text) const {
    const int file = ::openat(open_, manifest_name, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    const bool written = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    ::close(file);
    promise(written, path_ + " cannot be written");
    return find_manifest(open_);
  }
  int open() const { return open_; }

 private:
  std::string path_;
  int open_ = -1;
};

bool feed(std::string_view input) {
  static const Folder folder;
  const FoundManifest found = folder.find(input);
  promise(found.there, "a manifest that is there is not found");
  if (!found.fault.empty()) {
    promise_message(found.fault);
    promise(found.manifest.files.empty() && found.manifest.next.empty(), "a manifest at fault is used");
    return false;
  }
  for (const auto& [name, listed] : found.manifest.all()) {
    const fs::path path = name;
    promise(!name.empty() && path.is_relative() && path.lexically_normal() == path && *path.begin() != "..",
            "a name that leads out of the folder: " + name);
    promise(listed.sha256.size() == 64, "a hash of another length");
  }
  promise(files_that_are_ours(folder.open(), found.manifest).empty(), "a file that is not there is ours");
  const FoundManifest again = folder.find(encode_manifest(found.manifest));
  promise(again.fault.empty() && again.manifest.files == found.manifest.files &&
              again.manifest.next == found.manifest.next,
          "a manifest that is written and read again is another");
  return true;
}

std::vector<std::string> seeds() {
  const std::string a(64, 'a'), b(64, '0');
  return {encode_manifest({{{"index.html", {10, a}}, {"frames/0000.png", {0, b}}}}),
          encode_manifest({{{"run.h5", {1U << 20, b}}}, {{"run.h5", {7, a}}, {"x", {1, b}}}})};
}

}  // namespace

const Target manifest_target{"manifest", feed, seeds};

}  // namespace plumb::fuzz
