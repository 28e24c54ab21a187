#include "engine/base/manifest.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "engine/base/beneath.h"
#include "engine/base/sha256.h"

namespace plumb {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int version = 1;
constexpr const char* version_key = "plumb_manifest";
constexpr off_t longest_manifest = off_t{64} << 20;

/// Put together by hand, as a list of the JSON library ends the program where there is no memory to end it.
std::string list_text(const char* key, const ListedFiles& files) {
  std::string text;
  for (const auto& [name, file] : files)
    text += fmt::format("{}\n  {{\n   \"name\": {},\n   \"size\": {},\n   \"sha256\": \"{}\"\n  }}",
                        text.empty() ? "" : ",",
                        OrderedJson(name).dump(-1, ' ', false, OrderedJson::error_handler_t::replace),
                        file.size, file.sha256);
  return fmt::format(",\n \"{}\": [{}{}]", key, text, text.empty() ? "" : "\n ");
}

bool is_sum(const std::string& text) {
  constexpr std::size_t length = 64;
  return text.size() == length && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

ListedFiles list_of(const OrderedJson& list) {
  ListedFiles files;
  if (!list.is_array()) throw std::runtime_error("it has no list of files");
  for (const OrderedJson& entry : list) {
    if (!entry.is_object() || entry.size() != 3 || !entry.contains("name") || !entry["name"].is_string() ||
        !entry.contains("size") || !entry["size"].is_number_unsigned() || !entry.contains("sha256") ||
        !entry["sha256"].is_string() || !is_sum(entry["sha256"].get_ref<const std::string&>()))
      throw std::runtime_error("it lists something that is no file with its size and SHA-256");
    const std::string name = entry["name"];
    if (!is_name_beneath(name) || name == manifest_name)
      throw std::runtime_error("it lists a name that no file of an output folder has");
    if (!files.emplace(name, ListedFile{entry["size"], entry["sha256"]}).second)
      throw std::runtime_error("it lists a file twice");
  }
  return files;
}

/// After a file could not be opened: that there is no such file is told from not knowing.
std::pair<Descriptor, off_t> none_there() {
  if (errno != ENOENT && errno != ENOTDIR && errno != ELOOP && errno != EACCES && errno != ENXIO)
    throw std::system_error(errno, std::generic_category());
  return {};
}

/// Opens a regular file below a folder and finds its size; closed where there is none.
std::pair<Descriptor, off_t> open_regular(int folder, const std::string& name) {
  const Beneath place = find_beneath(folder, name);
  if (!place.folder) return none_there();
  // Whoever has put a pipe there is not waited for.
  Descriptor file(
      ::openat(place.folder.get(), place.name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!file) return none_there();
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) throw std::system_error(errno, std::generic_category());
  if (!S_ISREG(status.st_mode)) return {};
  return {std::move(file), status.st_size};
}

std::string text_of(int file, off_t size) {
  std::string text(static_cast<std::size_t>(size), '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::read(file, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw std::runtime_error("it cannot be read to its end");
    done += static_cast<std::size_t>(count);
  }
  return text;
}

Manifest manifest_of(const std::string& text) {
  const OrderedJson json = OrderedJson::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains(version_key)) throw std::runtime_error("it is none of Plumb");
  if (json[version_key] != version) throw std::runtime_error("it is of another version");
  if (!json.contains("files")) throw std::runtime_error("it has no list of files");
  Manifest manifest{list_of(json["files"])};
  if (json.contains("next")) manifest.next = list_of(json["next"]);
  return manifest;
}

}  // namespace

ListedFile listed_as(const std::string& bytes) {
  return {bytes.size(), sha256(bytes)};
}

ListedFiles Manifest::all() const {
  ListedFiles both = files;
  both.insert(next.begin(), next.end());
  return both;
}

bool is_name_listed_as_it_is(const std::string& name) {
  const std::string text = OrderedJson(name).dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  return OrderedJson::parse(text, nullptr, false) == name;
}

std::string encode_manifest(const Manifest& manifest) {
  return fmt::format("{{\n \"{}\": {}{}{}\n}}\n", version_key, version, list_text("files", manifest.files),
                     manifest.next.empty() ? "" : list_text("next", manifest.next));
}

FoundManifest find_manifest(int folder) {
  FoundManifest found;
  struct stat status {};
  if (::fstatat(folder, manifest_name, &status, AT_SYMLINK_NOFOLLOW) != 0) return found;
  found.there = true;
  try {
    const auto [file, size] = open_regular(folder, manifest_name);
    if (!file) throw std::runtime_error("it is no regular file, or cannot be read");
    if (size > longest_manifest) throw std::runtime_error("it is too long");
    found.text = text_of(file.get(), size);
    found.manifest = manifest_of(found.text);
  } catch (const std::system_error&) {
    throw;
  } catch (const std::runtime_error& error) {
    found.fault = error.what();
  }
  return found;
}

bool is_still(int folder, const std::string& name, const ListedFile& listed) {
  const auto [file, size] = open_regular(folder, name);
  return file && static_cast<std::uintmax_t>(size) == listed.size &&
         sha256_of(file.get(), listed.size) == listed.sha256;
}

std::optional<std::string> bytes_of(int folder, const std::string& name, const ListedFile& listed) {
  const auto [file, size] = open_regular(folder, name);
  if (!file || static_cast<std::uintmax_t>(size) != listed.size) return {};
  std::string bytes = text_of(file.get(), size);
  return sha256(bytes) == listed.sha256 ? std::optional(std::move(bytes)) : std::nullopt;
}

ListedFiles files_that_are_ours(int folder, const Manifest& manifest) {
  ListedFiles ours;
  for (const ListedFiles* list : {&manifest.files, &manifest.next})
    for (const auto& [name, file] : *list)
      if (!ours.contains(name) && is_still(folder, name, file)) ours.emplace(name, file);
  return ours;
}

}  // namespace plumb
