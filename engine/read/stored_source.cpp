#include "engine/read/stored_source.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace plumb {
namespace {

constexpr const char* given_names_path = "case/given_names";

std::string given_path(std::size_t k) {
  return fmt::format("case/given_files/{}", k);
}

}  // namespace

void write_source(const CaseSource& source, hdf5::Writer& file) {
  file.text("case/name", source.file.name);
  file.text("case/text", source.file.text);
  file.texts("case/overrides", source.overrides);
  std::vector<std::string> names, texts;
  for (const NamedText& reference : source.references) {
    names.push_back(reference.name);
    texts.push_back(reference.text);
  }
  file.texts("case/reference_names", names);
  file.texts("case/reference_texts", texts);
  if (source.given_runs.empty()) return;
  names.clear();
  for (std::size_t k = 0; k < source.given_runs.size(); ++k) {
    names.push_back(source.given_runs[k].name);
    file.bytes(given_path(k), source.given_runs[k].text);
  }
  file.texts(given_names_path, names);
}

CaseSource read_source(const hdf5::Reader& file) {
  CaseSource source{{file.text("case/name"), file.text("case/text")}, file.texts("case/overrides"), {}, {}};
  const auto names = file.texts("case/reference_names"), texts = file.texts("case/reference_texts");
  if (names.size() != texts.size()) throw std::runtime_error("its references do not have one name each");
  for (std::size_t k = 0; k < names.size(); ++k) source.references.push_back({names[k], texts[k]});
  // Runs of older versions have none.
  if (!file.has(given_names_path)) return source;
  for (const std::string& name : file.texts(given_names_path))
    source.given_runs.push_back({name, file.bytes(given_path(source.given_runs.size()))});
  return source;
}

}  // namespace plumb
