#include "engine/read/given_table.h"

namespace plumb {

int GivenTable::find(const std::string& name) const {
  if (by_name_.empty())
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const Column& column = columns_[k];
      by_name_.emplace(column.name, static_cast<int>(k));
      if (!column.unit.empty()) by_name_.emplace(column.name + " [" + column.unit + "]", static_cast<int>(k));
    }
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? -1 : found->second;
}

std::unique_ptr<GivenTable> read_given_table(const NamedText& file) {
  constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";
  return file.text.starts_with(hdf5_signature) ? read_given_hdf5(file) : read_given_csv(file);
}

}  // namespace plumb
