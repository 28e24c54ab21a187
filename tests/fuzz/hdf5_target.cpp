#include "engine/base/hdf5.h"
#include "engine/read/given_table.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {
namespace {

bool feed(std::string_view input) {
  return reads<InputError>([&] {
    const NamedText file{"run.h5", std::string(input)};
    const auto table = read_given_hdf5(file);
    promise(!table->columns().empty(), "a table without columns");
    for (int column = 0; column < std::ssize(table->columns()); ++column) {
      const std::vector<double> values = table->values(column);
      promise(!values.empty(), "a column of nothing");
      promise_finite(values, "a number of a column");
      promise(!table->place(column, values.size() - 1).empty(), "a number without a place");
    }
  });
}

std::vector<std::string> seeds() {
  const std::vector<double> times{0, 0.5, 1}, x{1, 2, 3};
  hdf5::Writer plain, own;
  plain.numbers("t", {3}, times.data(), "s");
  plain.numbers("a/tip.x", {3}, x.data(), "mm");
  plain.integers("whole", {1, 2, 3});
  own.numbers("time", {3}, times.data(), "s");
  own.numbers("probes/tip.x", {3}, x.data(), "m");
  own.text("title", "not a column");
  return {plain.bytes(), own.bytes()};
}

}  // namespace

const Target hdf5_target{"hdf5", feed, seeds};

}  // namespace plumb::fuzz
