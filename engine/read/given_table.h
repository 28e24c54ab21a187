#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/case/case_source.h"

namespace plumb {

/// The columns of a file of an external run, each read only when it is asked for.
class GivenTable {
 public:
  struct Column {
    std::string name;   ///< without the unit
    std::string unit;   ///< that the file states; empty where it states none
    std::string place;  ///< as errors show it: "chrono.csv:1:7", "run.h5: probes/tip.x"
  };

  virtual ~GivenTable() = default;

  const std::string& name() const { return name_; }
  const std::vector<Column>& columns() const { return columns_; }
  /// The case of a run file of Plumb's own, as far as its motion depends on it; else nothing.
  const std::shared_ptr<const Case>& own_case() const { return own_case_; }
  /// How the run in it ended, where the file says so.
  const GivenEnding& ending() const { return ending_; }
  /// What the file is taken for, in words: "HDF5", "a table whose columns are separated by commas".
  const std::string& taken_for() const { return taken_for_; }
  /// Rows at which a run that was stopped goes on, perhaps from an earlier time.
  const std::vector<std::size_t>& restarts() const { return restarts_; }
  /// How the file was read, where that is not plain.
  const std::vector<std::string>& notes() const { return notes_; }

  /// The place of the column of that name, or of the name and unit "tip.x [mm]"; -1: there is none.
  int find(const std::string& name) const;
  /// Names that a column may have unless the case gives one: the probe's, and what else is usual.
  virtual std::vector<std::string> usual_names(const std::string& column) const { return {column}; }

  /// The numbers of a column, one or more and all finite. Throws InputError with the place of one that is not
  /// a number.
  virtual std::vector<double> values(int column) const = 0;
  /// Where a number stands.
  virtual std::string place(int column, std::size_t row) const = 0;

 protected:
  explicit GivenTable(std::string name) : name_(std::move(name)) {}

  std::string name_;
  std::vector<Column> columns_;
  GivenEnding ending_;
  std::shared_ptr<const Case> own_case_;
  std::string taken_for_;
  std::vector<std::size_t> restarts_;
  std::vector<std::string> notes_;

 private:
  mutable std::unordered_map<std::string, int> by_name_;  ///< made by the first `find`
};

/// Reads the table of a file by what it begins with: HDF5, or else CSV. `file.name` is shown in errors.
/// Throws InputError.
std::unique_ptr<GivenTable> read_given_table(const NamedText& file);

/// A table of text with a header, as table_text() finds it. Unless columns are separated by commas, decimals
/// may have commas; exponents may be Fortran's. A header that is repeated begins what a run that was stopped
/// goes on with.
std::unique_ptr<GivenTable> read_given_csv(const NamedText& file);

/// HDF5: each data set of one dimension is a column, named by its path, with the unit in its attribute
/// `unit`. Those of Plumb's own run files are found by the names of the probes, and how the run ended is
/// taken from them; one that was cut or changed is refused.
std::unique_ptr<GivenTable> read_given_hdf5(const NamedText& file);

}  // namespace plumb
