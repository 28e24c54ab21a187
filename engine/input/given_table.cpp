#include "engine/input/given_table.h"

namespace plumb {

int GivenTable::find(const std::string& name) const {
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const Column& column = columns_[k];
    if (column.name == name || (!column.unit.empty() && column.name + " [" + column.unit + "]" == name))
      return static_cast<int>(k);
  }
  return -1;
}

std::unique_ptr<GivenTable> read_given_table(const NamedText& file) {
  constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";
  return file.text.starts_with(hdf5_signature) ? read_given_hdf5(file) : read_given_csv(file);
}

}  // namespace plumb
