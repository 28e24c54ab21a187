#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/engine/small_case.h"

namespace plumb {
namespace reference_faults_test {

/// One replacement in the reference of the small case, and the whole error that it must give.
struct Fault {
  std::string from;
  std::string to;
  std::string expected;
};

void expect_refused(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    CaseSource source = small_case();
    source.references[0].text = with(source.references[0].text, fault.from, fault.to);
    const std::string message = refusal(source);
    EXPECT_TRUE(matches(message, fault.expected))
        << "with:     " << fault.to << "\nrefused:  " << message << "\nexpected: " << fault.expected;
  }
}

TEST(ReferenceFaults, AReferenceThatLacksSomethingIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"title = \"A small table\"\n", "", "small_reference.toml:1:1: title: missing; required: a title"},
      {"kind = \"published\"\n", "",
       "small_reference.toml:1:1: kind: missing; required: \"published\" or \"computed\""},
      {"source = \"A book\"\n", "",
       "small_reference.toml:1:1: source: missing; required: the publication or program that the numbers are "
       "from"},
      {"obtained = \"by hand\"\n", "",
       "small_reference.toml:1:1: obtained: missing; required: how the numbers came from the source"},
      {"time_unit = \"s\"\n", "",
       "small_reference.toml:6:11: columns = [\"t\", \"mid_y\", \"force\"]: stand over the time, whose "
       "time_unit = \"s\" is missing"},
      {"columns = [\"t\", \"mid_y\", \"force\"]\n", "",
       "small_reference.toml:1:1: columns: missing; required: the list of the columns' names, \"t\" first"},
      {"rows = [\n  [0.0, 0.0, 1],\n  [0.5, -0.1, 2.5],\n  [1.0, -0.2, 3.5],\n]\n", "",
       "small_reference.toml:1:1: rows: missing; required: the list of rows, each a list of numbers"},
      {"name = \"mid_y\"\n", "", "small_reference.toml:13:1: series.0.name: missing; required: a name"},
      {"figure = \"Fig. 1\"\n", "",
       "small_reference.toml:13:1: series.0.figure: missing; required: where the series stands in the "
       "source, \"Fig. 3\""},
      {"unit = \"m\"\n", "",
       "small_reference.toml:13:1: series.0.unit: missing; required: the unit of the values, \"m\""},
      {"uncertainty = 1e-3\n", "",
       "small_reference.toml:13:1: series.0.uncertainty: missing; required: a number greater than 0 "
       "(half-width, in the unit of the series)"},
      {"uncertainty_basis = \"thickness of the line\"\n", "",
       "small_reference.toml:13:1: series.0.uncertainty_basis: missing; required: what the uncertainty rests "
       "on"},
      {"\"A book\"", "\"\"",
       "small_reference.toml:3:10: source = \"\": must not be empty: the publication or program that the "
       "numbers are from"},
      {"\"A book\"", "\"  \"",
       "small_reference.toml:3:10: source = \"  \": must not be empty: the publication or program that the "
       "numbers are from"},
      {"\"by hand\"", "\"\"",
       "small_reference.toml:4:12: obtained = \"\": must not be empty: how the numbers came from the source"},
      {"\"Fig. 1\"", "\"\"",
       "small_reference.toml:16:10: series.0.figure = \"\": must not be empty: where the series stands in "
       "the source, \"Fig. 3\""},
      {"unit = \"m\"", "unit = \"\"",
       "small_reference.toml:17:8: series.0.unit = \"\": must not be empty: the unit of the values, \"m\""},
      {"uncertainty = 1e-3", "uncertainty = 0",
       "small_reference.toml:18:15: series.0.uncertainty = 0: must be a number greater than 0 (half-width, "
       "in the unit of the series)"},
      {"uncertainty = 1e-3", "uncertainty = -1",
       "small_reference.toml:18:15: series.0.uncertainty = -1: must be a number greater than 0 (half-width, "
       "in the unit of the series)"},
      {"uncertainty = 1e-3", "uncertainty = inf",
       "small_reference.toml:18:15: series.0.uncertainty = inf: must be finite: a number greater than 0 "
       "(half-width, in the unit of the series)"},
      {"uncertainty = 1e-3", "uncertainty = \"1e-3\"",
       "small_reference.toml:18:15: series.0.uncertainty = \"1e-3\": must be a number greater than 0 "
       "(half-width, in the unit of the series), found a string"},
      {"\"thickness of the line\"", "\"\"",
       "small_reference.toml:19:21: series.0.uncertainty_basis = \"\": must not be empty: what the "
       "uncertainty rests on"},
  });
}

TEST(ReferenceFaults, AReferenceWithABadTableIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"\"published\"", "\"publshed\"",
       "small_reference.toml:2:8: kind = \"publshed\": must be \"published\" or \"computed\"; did you mean "
       "\"published\"?"},
      {"time_unit = \"s\"", "time_unit = \"ms\"",
       "small_reference.toml:6:13: time_unit = \"ms\": must be \"s\""},
      {"source = \"A book\"", "sauce = \"A book\"",
       "small_reference.toml:3:1: sauce = \"A book\": unknown key; did you mean \"source\"?"},
      {"[0.5, -0.1, 2.5]", "[0.5, nan, 2.5]",
       "small_reference.toml:10:9: rows.1.1 = nan: must be finite: a number (m)"},
      {"[0.5, -0.1, 2.5]", "[0.5, -inf, 2.5]",
       "small_reference.toml:10:9: rows.1.1 = -inf: must be finite: a number (m)"},
      {"[0.5, -0.1, 2.5]", "[0.5, \"x\", 2.5]",
       "small_reference.toml:10:9: rows.1.1 = \"x\": must be a number (m), found a string"},
      {"[0.5, -0.1, 2.5]", "[0.5, -0.1]",
       "small_reference.toml:10:3: rows.1 = [0.5, -0.1]: must be a list of 3 numbers, one a column"},
      {"[0.5, -0.1, 2.5]", "[0.5, -0.1, 2.5, 3]",
       "small_reference.toml:10:3: rows.1 = [0.5, -0.1, 2.5, 3]: must be a list of 3 numbers, one a column"},
      {"[0.5, -0.1, 2.5]", "0.5",
       "small_reference.toml:10:3: rows.1 = 0.5: must be a list of 3 numbers, one a column"},
      {"[0.5, -0.1, 2.5]", "[0.0, -0.1, 2.5]",
       "small_reference.toml:10:4: rows.1.0 = 0.0: must be greater than the time before it, 0 (s)"},
      {"[0.5, -0.1, 2.5]", "[1.5, -0.1, 2.5]",
       "small_reference.toml:11:4: rows.2.0 = 1.0: must be greater than the time before it, 1.5 (s)"},
      {"[0.0, 0.0, 1]", "[-0.1, 0.0, 1]",
       "small_reference.toml:9:4: rows.0.0 = -0.1: must be a number of at least 0 (s)"},
      {"[\"t\", \"mid_y\", \"force\"]", "[\"time\", \"mid_y\", \"force\"]",
       "small_reference.toml:7:12: columns.0 = \"time\": the first column must be \"t\", the time, \"mode\", "
       "the number of a mode, or \"load\""},
      {"[\"t\", \"mid_y\", \"force\"]", "[\"t\", \"mid_x\", \"force\"]",
       "small_reference.toml:7:17: columns.1 = \"mid_x\": has no [[series]] of that name; did you mean "
       "\"mid_y\"?"},
      {"[\"t\", \"mid_y\", \"force\"]", "[\"t\", \"force\", \"force\"]",
       "small_reference.toml:7:26: columns.2 = \"force\": is the name of another column"},
      {"[\"t\", \"mid_y\", \"force\"]", "[\"t\", \"force\"]",
       "small_reference.toml:7:11: columns = [\"t\", \"force\"]: lacks the series \"mid_y\""},
      {"[\"t\", \"mid_y\", \"force\"]", "[]",
       "small_reference.toml:7:11: columns = []: lacks the series \"mid_y\""},
      {"[\"t\", \"mid_y\", \"force\"]", "[\"t\", 5, \"force\"]",
       "small_reference.toml:7:17: columns.1 = 5: must be a string, found a whole number"},
      {"rows = [\n  [0.0, 0.0, 1],\n  [0.5, -0.1, 2.5],\n  [1.0, -0.2, 3.5],\n]", "rows = []",
       "small_reference.toml:8:8: rows = []: must hold at least one row"},
      {"name = \"force\"", "name = \"mid_y\"",
       "small_reference.toml:21:8: series.1.name = \"mid_y\": is the name of another series"},
      {"name = \"force\"", "name = \"t\"",
       "small_reference.toml:21:8: series.1.name = \"t\": is the name of what series stand over, the time, a "
       "mode or a load"},
      {"name = \"force\"", "name = \"the force\"",
       "small_reference.toml:21:8: series.1.name = \"the force\": must be letters, digits, - and _, at most "
       "100, not starting with -"},
      {"[0.5, -0.1, 2.5]", "[0.5, -0.1, 2.5",
       "small_reference.toml:13:1: not valid TOML: Error while parsing array: expected comma or closing ']', "
       "saw '['"},
  });
}

TEST(ReferenceFaults, ABadCableOfAReferenceIsRefusedWithItsPlaceAndWhatIsAllowed) {
  const std::string last = "uncertainty_basis = \"last digit\"", table = last + "\n[cable]\n";
  expect_refused({
      {last, table + "length = -1",
       "small_reference.toml:27:10: cable.length = -1: must be a number greater than 0 (m)"},
      {last, table + "axial_stiffness = \"1\"",
       "small_reference.toml:27:19: cable.axial_stiffness = \"1\": must be a number greater than 0 (N), "
       "found a string"},
      {last, table + "lenght = 1",
       "small_reference.toml:27:1: cable.lenght = 1: unknown key; did you mean \"length\"?"},
  });
}

TEST(ReferenceFaults, BadExactFiguresAreRefusedWithTheirPlaceAndWhatIsAllowed) {
  const std::string last = "uncertainty_basis = \"last digit\"";
  const auto exact = [&](const std::string& rows, const std::string& uncertainty,
                         const std::string& more = "") {
    return last + "\n[exact]\nobtained = \"closed form\"\nuncertainty_basis = \"digits\"\nrows = " + rows +
           "\nuncertainty = " + uncertainty + "\n" + more;
  };
  const std::string rows = "[[0, 0, 1], [0.5, -0.1, 2.4], [1, -0.2, 3.4]]",
                    each = "{ mid_y = 1e-6, force = 1e-3 }";
  expect_refused({
      {last, last + "\n[exact]\n",
       "small_reference.toml:26:1: exact.obtained: missing; required: how the exact figures were found"},
      {last, exact("[[0, 0, 1], [0.5, -0.1, 2.4]]", each),
       "small_reference.toml:29:8: exact.rows = [[0, 0, 1], [0.5, -0.1, 2.4]]: must have the same first "
       "column "
       "as the rows of the file"},
      {last, exact("[[0, 0]]", each),
       "small_reference.toml:29:9: exact.rows.0 = [0, 0]: must be a list of 3 numbers, one a column"},
      {last, exact(rows, "1e-6"),
       "small_reference.toml:30:15: exact.uncertainty = 1e-6: must be a table of one a series, { tip_x = "
       "1e-6 }, "
       "as their units differ"},
      {last, exact(rows, "{ mid_y = 1e-6 }"),
       "small_reference.toml:30:15: exact.uncertainty.force: missing; required: a number greater than 0 "
       "(half-width, in the unit of the series)"},
      {last, exact(rows, "{ mid_y = 1e-6, farce = 1e-3 }"),
       "small_reference.toml:30:31: exact.uncertainty.farce = 1e-3: unknown key; did you mean \"force\"?"},
      {last, exact(rows, each, "row = 1"),
       "small_reference.toml:31:1: exact.row = 1: unknown key; did you mean \"rows\"?"},
  });
}

TEST(ReferenceFaults, BadSharedErrorsAreRefusedWithTheirPlaceAndWhatIsAllowed) {
  const std::string last = "uncertainty_basis = \"last digit\"", table = last + "\n[shares]\n";
  expect_refused({
      {last, table + "elements = 0",
       "small_reference.toml:27:12: shares.elements = 0: must be a whole number from 1 to 1000000"},
      {last, table + "elements = 4\nstrain = \"gren-geometric\"",
       "small_reference.toml:28:10: shares.strain = \"gren-geometric\": must be \"green-geometric\" or "
       "\"engineering-material\"; did you mean \"green-geometric\"?"},
      {last, table + "strain = \"green-geometric\"",
       "small_reference.toml:27:10: shares.strain = \"green-geometric\": is of a mesh, whose number of "
       "elements is "
       "missing"},
      {last, table + "quadrature = \"full\"",
       "small_reference.toml:27:14: shares.quadrature = \"full\": is of a mesh, whose number of elements is "
       "missing"},
      {last, table + "inputs = \"cable.density\"",
       "small_reference.toml:27:10: shares.inputs = \"cable.density\": must be a list of strings, found a "
       "string"},
      {last, table + "inputs = [\"density\"]",
       "small_reference.toml:27:10: shares.inputs = [\"density\"]: must name each input once, by its key in "
       "[[uncertainty.input]]: \"density\""},
      {last, table + "inputs = [\"cable.density\", \"cable.density\"]",
       "small_reference.toml:27:10: shares.inputs = [\"cable.density\", \"cable.density\"]: must name each "
       "input once, by "
       "its key in [[uncertainty.input]]: \"cable.density\""},
      {last, table + "mesh = 4",
       "small_reference.toml:27:1: shares.mesh = 4: unknown key; known: elements, strain, quadrature, "
       "inputs, model"},
  });
}

TEST(ReferenceFaults, ABadModelIsRefusedWithItsPlaceAndWhatIsAllowed) {
  const std::string last = "uncertainty_basis = \"last digit\"", table = last + "\n[model]\n";
  expect_refused({
      {last, table,
       "small_reference.toml:26:1: model.differences: missing; required: the list of what is different in "
       "the model "
       "behind the figures"},
      {last, table + "differences = []",
       "small_reference.toml:27:15: model.differences = []: must hold at least one text, and none that is "
       "empty"},
      {last, table + "differences = [\"shear\", \"\"]",
       "small_reference.toml:27:15: model.differences = [\"shear\", \"\"]: must hold at least one text, and "
       "none that is "
       "empty"},
      {last, table + "differences = [\"shear\"]\nerror = {}\nerror_basis = \"stated\"",
       "small_reference.toml:28:9: model.error: must have the error of one series or more, { tip = 5e-6 "
       "}"},
      {last, table + "differences = [\"shear\"]\nerror = { mid_y = -1 }\nerror_basis = \"stated\"",
       "small_reference.toml:28:19: model.error.mid_y = -1: must be a number greater than 0 (m)"},
      {last, table + "differences = [\"shear\"]\nerror = { mid_y = 1 }",
       "small_reference.toml:26:1: model.error_basis: missing; required: what the size of the model error "
       "rests "
       "on"},
      {last, table + "differences = [\"shear\"]\nerror_basis = \"stated\"",
       "small_reference.toml:28:15: model.error_basis = \"stated\": is asked for with error alone"},
  });
}

TEST(ReferenceFaults, AReferenceInAnotherUnitIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"unit = \"m\"", "unit = \"mm\"",
       "case.toml:42:21: reference.0.compare.mid_y = \"mid.y\": the unit must be that of the series, mm; "
       "that of the column is m"},
  });
}

}  // namespace reference_faults_test
}  // namespace plumb
