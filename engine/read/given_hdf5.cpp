#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "engine/base/checked_file.h"
#include "engine/base/errors.h"
#include "engine/base/hdf5.h"
#include "engine/base/message.h"
#include "engine/integrate/trajectory.h"
#include "engine/read/changed_case.h"
#include "engine/read/given_table.h"
#include "engine/read/stored_source.h"

namespace plumb {
namespace {

/// Of a column, more than a report can use, and no more than 80 MB.
constexpr hsize_t most_rows = 10'000'000;

class Hdf5Table final : public GivenTable {
 public:
  explicit Hdf5Table(const NamedText& file) : GivenTable(file.name) {
    try {
      reader_.emplace(file.text);
      taken_for_ = "HDF5";
      read_ending(file.text);
      for (const std::string& path : reader_->series())
        columns_.push_back({path, reader_->unit(path), at(path)});
    } catch (const Interrupted&) {
      throw;
    } catch (const std::runtime_error& error) {
      fail(name_ + ": cannot be used", reason(error));
    }
    if (columns_.empty()) fail(name_, "holds no data set of numbers of one dimension");
  }

  std::vector<std::string> usual_names(const std::string& column) const override {
    if (column == "t") return {"t", "time"};
    return {column, "probes/" + column};
  }

  std::vector<double> values(int column) const override {
    const std::string& path = columns_[static_cast<std::size_t>(column)].name;
    std::vector<double> values;
    try {
      values = reader_->series_values(path, most_rows);
    } catch (const Interrupted&) {
      throw;
    } catch (const std::runtime_error& error) {
      fail(at(path), reason(error));
    }
    if (values.empty()) fail(at(path), "has no rows");
    for (std::size_t row = 0; row < values.size(); ++row)
      if (!std::isfinite(values[row]))
        fail(place(column, row), fmt::format("{}: must be a finite number", values[row]));
    return values;
  }

  std::string place(int column, std::size_t row) const override {
    return fmt::format("{}[{}]", at(columns_[static_cast<std::size_t>(column)].name), row);
  }

 private:
  /// Of a run file of Plumb's: how the run ended, or that which it was made of.
  void read_ending(const std::string& bytes) {
    if (!reader_->has("format") || !reader_->has("format_version") || reader_->text("format") != "plumb-run")
      return;
    without_check_sum(bytes, "run file");
    taken_for_ = "a run file of Plumb's";
    for (const std::string group : {"", "given/"}) {
      if (!reader_->has(group + "outcome")) continue;
      ending_ = {reader_->text(group + "outcome"), one_line(reader_->text(group + "message"))};
      outcome_named(ending_.outcome);
    }
    if (reader_->has("outcome"))
      own_case_ = std::make_shared<const Case>(load_changed(read_source(*reader_), {}).spec);
    if (ending_.failed()) notes_.push_back("the run in it failed, " + ending_.in_words());
  }

  [[noreturn]] static void fail(const std::string& place, const std::string& what) {
    throw InputError(one_line(place + ": " + what));
  }

  std::string at(const std::string& path) const { return name_ + ": " + path; }

  std::optional<hdf5::Reader> reader_;
};

}  // namespace

std::unique_ptr<GivenTable> read_given_hdf5(const NamedText& file) {
  return std::make_unique<Hdf5Table>(file);
}

}  // namespace plumb
