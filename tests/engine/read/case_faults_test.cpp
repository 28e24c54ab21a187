#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/engine/small_case.h"

namespace plumb {
namespace case_faults_test {

/// One replacement in the small case, and the whole error that it must give.
struct Fault {
  std::string from;
  std::string to;
  std::string expected;
};

void expect_refused(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    CaseSource source = small_case();
    source.file.text = with(source.file.text, fault.from, fault.to);
    const std::string message = refusal(source);
    EXPECT_TRUE(matches(message, fault.expected))
        << "with:     " << fault.to << "\nrefused:  " << message << "\nexpected: " << fault.expected;
  }
}

const std::string many_parts = [] {
  std::string key = "a";
  for (int i = 0; i < 200; ++i) key += ".a";
  return key + " = 1";
}();

TEST(CaseFaults, AFileThatIsNotTomlIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"title = \"Small\"", "title = \"Small",
       "case.toml:1:15: not valid TOML: Error while parsing string: unescaped control characters other than "
       "TAB (U+0009) are explicitly prohibited"},
      {"[cable]", "[cable",
       "case.toml:5:7: not valid TOML: Error while parsing table header: expected ']', saw '\\n'"},
      {"length = 2.0", "length = 2.0\nlength = 3.0",
       "case.toml:7:10: not valid TOML: Error while parsing key-value pair: cannot redefine existing "
       "floating-point 'length'"},
      {"length = 2.0", "length = 1e999",
       "case.toml:6:15: not valid TOML: Error while parsing floating-point: '1e999' could not be interpreted "
       "as a value"},
      {"length = 2.0", "length = 99999999999999999999",
       "case.toml:6:30: not valid TOML: Error while parsing decimal integer: '99999999999999999999' is not "
       "representable in 64 bits"},
      {"title = \"Small\"", many_parts,
       "case.toml:1:201: is more than 100 tables or lists deep, which is not allowed"},
  });
}

TEST(CaseFaults, AnUnknownKeyOrTableIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"length = 2.0", "lenght = 2.0",
       "case.toml:6:1: cable.lenght = 2.0: unknown key; did you mean \"length\"?"},
      {"length = 2.0", "length = 2.0\ncolour = \"red\"",
       "case.toml:7:1: cable.colour = \"red\": unknown key; known: length, area, density, youngs_modulus, "
       "second_moment, elements, model, strain, quadrature"},
      {"[cable]", "[cabel]", "case.toml:5:2: cabel: unknown table; did you mean \"cable\"?"},
      {"[parameters]", "[paramters]",
       "case.toml:2:2: paramters: unknown table; did you mean \"parameters\"?"},
      {"[[probe]]\nname = \"mid\"", "[[prob]]\nname = \"mid\"",
       "case.toml:31:3: prob: unknown table; did you mean \"probe\"?"},
      {"[scene.camera]", "[scene.camra]",
       "case.toml:65:8: scene.camra: unknown table; did you mean \"camera\"?"},
      {"eye = [0, 0, 5]", "ey = [0, 0, 5]",
       "case.toml:66:1: scene.camera.ey = [0, 0, 5]: unknown key; did you mean \"eye\"?"},
      {"first = \"pinned\"", "frist = \"pinned\"",
       "case.toml:19:1: supports.frist = \"pinned\": unknown key; did you mean \"first\"?"},
      {"gravity", "gravty",
       "case.toml:22:1: loads.gravty = [0, \"-g + 0.19\", 0]: unknown key; did you mean \"gravity\"?"},
      {"direction", "directon",
       "case.toml:15:1: start.directon = [3, 0, 4]: unknown key; did you mean \"direction\"?"},
      {"spectral_radius", "spectral_raduis",
       "case.toml:26:1: method.spectral_raduis = 0.9: unknown key; did you mean \"spectral_radius\"?"},
      {"output_interval", "output_intervall",
       "case.toml:30:1: time.output_intervall = 0.5: unknown key; did you mean \"output_interval\"?"},
      {"at = 0.5", "att = 0.5", "case.toml:33:1: probe.0.att = 0.5: unknown key; did you mean \"at\"?"},
      {"norm = \"rms\"", "nrom = \"rms\"",
       "case.toml:43:1: reference.0.nrom = \"rms\": unknown key; did you mean \"norm\"?"},
      {"equal_axes = false", "equal_axis = false",
       "case.toml:54:1: figure.0.equal_axis = false: unknown key; did you mean \"equal_axes\"?"},
      {"[scene]", "[study.mesh]\nelements = [1, 2]\n[scene]",
       "case.toml:60:8: study.mesh: unknown table; known: work_precision…"},
      {"[scene]", "[sweep]\nelements = [1, 2]\n[scene]",
       "case.toml:60:2: sweep: unknown table; known: parameters, title, cable, start, supports, loads, load, "
       "mass, damping, run, method, time, probe, reference, figure, scene, study, uncertainty, error_budget, "
       "sensitivity"},
  });
}

TEST(CaseFaults, AMissingKeyIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"title = \"Small\"\n", "", "case.toml:1:1: title: missing; required: a title"},
      {"length = 2.0\n", "", "case.toml:5:1: cable.length: missing; required: a number greater than 0 (m)"},
      {"area = \"1e-6 * f^2\"\n", "",
       "case.toml:5:1: cable.area: missing; required: a number greater than 0 (m²)"},
      {"density = 320\n", "",
       "case.toml:5:1: cable.density: missing; required: a number greater than 0 (kg/m³)"},
      {"youngs_modulus = 1.6e6\n", "",
       "case.toml:5:1: cable.youngs_modulus: missing; required: a number greater than 0 (Pa)"},
      {"elements = 4\n", "",
       "case.toml:5:1: cable.elements: missing; required: a whole number from 1 to 1000000"},
      {"name = \"generalized-alpha\"\n", "", "case.toml:23:1: method.name: missing; required: …"},
      {"end = 2.0\n", "", "case.toml:28:1: time.end: missing; required: a number greater than 0 (s)"},
      {"output_interval = 0.5\n", "",
       "case.toml:28:1: time.output_interval: missing; required: a number greater than 0 (s)"},
      {"name = \"mid\"\n", "", "case.toml:31:1: probe.0.name: missing; required: a name"},
      {"at = 0.5\n", "",
       "case.toml:31:1: probe.0.at: missing; required: a number from 0 to 1 (fraction of the length)"},
      {"file = \"small_reference.toml\"\n", "",
       "case.toml:39:1: reference.0.file: missing; required: the path of a reference file, relative to this "
       "one"},
      {"compare = { mid_y = \"mid.y\", force = \"pull\" }\n", "",
       "case.toml:39:1: reference.0.compare: missing; required: series and their columns, as in compare = { "
       "mid_y = \"mid.y\" }"},
      {"tolerance = 0.01\n", "",
       "case.toml:39:1: reference.0.tolerance: missing; required: a number greater than 0 (the unit of the "
       "series)"},
      {"name = \"height\"\n", "",
       "case.toml:46:1: figure.0.name: missing; required: a name, which the picture's file gets"},
      {"y = \"mid.y\"\n", "", "case.toml:46:1: figure.0.y: missing; required: a column of the probes"},
      {"eye = [0, 0, 5]\n", "",
       "case.toml:65:1: scene.camera.eye: missing; required: a list of 3 numbers (m)"},
      {"target = [0, 0, 0]\n", "",
       "case.toml:65:1: scene.camera.target: missing; required: a list of 3 numbers (m)"},
      {"[time]\nend = 2.0\noutput_interval = 0.5\n", "",
       "case.toml:1:1: time: missing; required: a table [time]"},
      {"[cable]\n", "[cable_]\n", "case.toml:5:2: cable_: unknown table; did you mean \"cable\"?"},
      {"[method]\nname = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "", "case.toml:1:1: method: missing; required: a table [method], or a [[run]] that was computed"},
  });
}

TEST(CaseFaults, AWrongTypeIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"title = \"Small\"", "title = 5", "case.toml:1:9: title = 5: must be a string, found a whole number"},
      {"length = 2.0", "length = true",
       "case.toml:6:10: cable.length = true: must be a number greater than 0 (m), found a boolean"},
      {"length = 2.0", "length = [2.0]",
       "case.toml:6:10: cable.length = [2.0]: must be a number greater than 0 (m), found a list"},
      {"length = 2.0", "length = 1979-05-27",
       "case.toml:6:10: cable.length = 1979-05-27: must be a number greater than 0 (m), found a date or "
       "time"},
      {"length = 2.0", "length = { m = 2 }",
       "case.toml:6:10: cable.length: must be a number greater than 0 (m), found a table"},
      {"strain = \"green-geometric\"", "strain = 1",
       "case.toml:12:10: cable.strain = 1: must be \"green-geometric\" or \"engineering-material\", found a "
       "whole number"},
      {"direction = [3, 0, 4]", "direction = 3",
       "case.toml:15:13: start.direction = 3: must be a list of 3 numbers, found a whole number"},
      {"direction = [3, 0, 4]", "direction = [3, 4]",
       "case.toml:15:13: start.direction = [3, 4]: must be a list of 3 numbers, found 2 of them"},
      {"direction = [3, 0, 4]", "direction = [3, true, 4]",
       "case.toml:15:17: start.direction.1 = true: must be a number, found a boolean"},
      {"equal_axes = false", "equal_axes = \"no\"",
       "case.toml:54:14: figure.0.equal_axes = \"no\": must be true or false, found a string"},
      {"[cable]\n", "cable = 3\n[cable_]\n", "case.toml:6:2: cable_: unknown table; did you mean \"cable\"?"},
      {"f = 5\n", "f = [5]\n",
       "case.toml:3:5: parameters.f = [5]: must be a number or an expression, found a list"},
      {"[parameters]\nf = 5\ng = \"2 * f\"\n", "parameters = 5\n",
       "case.toml:2:14: parameters = 5: must be a table [parameters], found a whole number"},
      {"reason = \"because\"", "reason = 5",
       "case.toml:45:10: reference.0.reason = 5: must be a string, found a whole number"},
      {"mid_y = \"mid.y\"", "mid_y = 5",
       "case.toml:42:21: reference.0.compare.mid_y = 5: must be a string, found a whole number"},
      {"compare = { mid_y = \"mid.y\", force = \"pull\" }", "compare = [\"mid.y\"]",
       "case.toml:42:11: reference.0.compare = [\"mid.y\"]: must be a table, found a list"},
      {"size = [640, 480]", "size = 640",
       "case.toml:61:8: scene.size = 640: must be a list of 2 numbers, found a whole number"},
  });
}

TEST(CaseFaults, ABadExpressionIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"\"1e-6 * f^2\"", "\"1e-6 * ff^2\"",
       "case.toml:7:16: cable.area = \"1e-6 * ff^2\": unknown parameter \"ff\"; did you mean \"f\"?"},
      {"\"1e-6 * f^2\"", "\"1e-6 * radius^2\"",
       "case.toml:7:16: cable.area = \"1e-6 * radius^2\": unknown parameter \"radius\"; known: f, g"},
      {"\"1e-6 * f^2\"", "\"1e-6 * (f^2\"",
       "case.toml:7:20: cable.area = \"1e-6 * (f^2\": not a valid expression: missing parenthesis"},
      {"\"1e-6 * f^2\"", "\"1e-6 * * f^2\"",
       "case.toml:7:16: cable.area = \"1e-6 * * f^2\": not a valid expression: unexpected operator \"*\""},
      {"\"1e-6 * f^2\"", "\"1,5\"",
       "case.toml:7:10: cable.area = \"1,5\": not a valid expression: gives 2 numbers instead of one (the "
       "decimal mark is a point)"},
      {"\"1e-6 * f^2\"", "\"\"",
       "case.toml:7:9: cable.area = \"\": not a valid expression: the expression is empty"},
      {"\"1e-6 * f^2\"", "\"1e999\"",
       "case.toml:7:9: cable.area = \"1e999\": not a valid expression: \"1e999\" is not a number"},
      {"\"1e-6 * f^2\"", "\"1e-6 · f^2\"",
       "case.toml:7:14: cable.area = \"1e-6 · f^2\": not a valid expression: an expression holds plain "
       "characters only"},
      {"\"1e-6 * f^2\"", "\"f = 3\"",
       "case.toml:7:11: cable.area = \"f = 3\": not a valid expression: unexpected operator \"=\""},
      {"\"1e-6 * f^2\"", "\"1 / (f - 5)\"",
       "case.toml:7:8: cable.area = \"1 / (f - 5)\" (= inf): must be finite: a number greater than 0 (m²)"},
      {"\"1e-6 * f^2\"", "\"sqrt(-f)\"",
       "case.toml:7:8: cable.area = \"sqrt(-f)\" (= nan): must be finite: a number greater than 0 (m²)"},
      {"\"1e-6 * f^2\"", "\"5 - f\"",
       "case.toml:7:8: cable.area = \"5 - f\" (= 0): must be a number greater than 0 (m²)"},
      {"\"1e-6 * f^2\"", "'1e-6 * ff'",
       "case.toml:7:16: cable.area = '1e-6 * ff': unknown parameter \"ff\"; did you mean \"f\"?"},
      {"\"1e-6 * f^2\"", "\"\"\"1e-6 * ff\"\"\"",
       "case.toml:7:18: cable.area = \"\"\"1e-6 * ff\"\"\": unknown parameter \"ff\"; did you mean \"f\"?"},
      {"\"1e-6 * f^2\"", "\"1e-6\\u0020* ff\"",
       "case.toml:7:8: cable.area = \"1e-6\\u0020* ff\": unknown parameter \"ff\"; did you mean \"f\"?"},
      {"elements = 4", "elements = \"f / 2\"",
       "case.toml:11:12: cable.elements = \"f / 2\" (= 2.5): must be a whole number from 1 to 1000000"},
      {"\"-g + 0.19\"", "\"-G + 0.19\"",
       "case.toml:22:17: loads.gravity.1 = \"-G + 0.19\": unknown parameter \"G\"; known: f, g"},
  });
}

TEST(CaseFaults, ABadParameterIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"g = \"2 * f\"", "g = \"2 * h\"",
       "case.toml:4:10: parameters.g = \"2 * h\": unknown parameter \"h\"; known: f, g"},
      {"g = \"2 * f\"", "g = \"2 * g\"",
       "case.toml:4:5: parameters.g = \"2 * g\": depends on itself: g -> g"},
      {"f = 5\ng = \"2 * f\"", "f = \"g / 2\"\ng = \"2 * f\"",
       "case.toml:3:5: parameters.f = \"g / 2\": depends on itself: f -> g -> f"},
      {"f = 5", "f = nan", "case.toml:3:5: parameters.f = nan: must be finite"},
      {"f = 5", "f = \"1/0\"", "case.toml:3:5: parameters.f = \"1/0\" (= inf): must be finite"},
      {"f = 5", "pi = 5",
       "case.toml:3:1: parameters.pi = 5: the name is taken by a built-in function or constant"},
      {"f = 5", "sin = 5",
       "case.toml:3:1: parameters.sin = 5: the name is taken by a built-in function or constant"},
      {"f = 5", "\"1f\" = 5",
       "case.toml:3:1: parameters.1f = 5: the name must be a letter followed by letters, digits and _"},
      {"f = 5", "\"\" = 5",
       "case.toml:3:1: parameters. = 5: the name must be a letter followed by letters, digits and _"},
  });
}

TEST(CaseFaults, ABadCableIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"length = 2.0", "length = 0", "case.toml:6:10: cable.length = 0: must be a number greater than 0 (m)"},
      {"length = 2.0", "length = -2.0",
       "case.toml:6:10: cable.length = -2.0: must be a number greater than 0 (m)"},
      {"length = 2.0", "length = inf",
       "case.toml:6:10: cable.length = inf: must be finite: a number greater than 0 (m)"},
      {"length = 2.0", "length = nan",
       "case.toml:6:10: cable.length = nan: must be finite: a number greater than 0 (m)"},
      {"area = \"1e-6 * f^2\"", "area = 0",
       "case.toml:7:8: cable.area = 0: must be a number greater than 0 (m²)"},
      {"area = \"1e-6 * f^2\"", "area = -1e-6",
       "case.toml:7:8: cable.area = -1e-6: must be a number greater than 0 (m²)"},
      {"area = \"1e-6 * f^2\"", "area = -inf",
       "case.toml:7:8: cable.area = -inf: must be finite: a number greater than 0 (m²)"},
      {"density = 320", "density = 0",
       "case.toml:8:11: cable.density = 0: must be a number greater than 0 (kg/m³)"},
      {"density = 320", "density = -320",
       "case.toml:8:11: cable.density = -320: must be a number greater than 0 (kg/m³)"},
      {"density = 320", "density = inf",
       "case.toml:8:11: cable.density = inf: must be finite: a number greater than 0 (kg/m³)"},
      {"youngs_modulus = 1.6e6", "youngs_modulus = 0",
       "case.toml:9:18: cable.youngs_modulus = 0: must be a number greater than 0 (Pa)"},
      {"youngs_modulus = 1.6e6", "youngs_modulus = -1",
       "case.toml:9:18: cable.youngs_modulus = -1: must be a number greater than 0 (Pa)"},
      {"youngs_modulus = 1.6e6", "youngs_modulus = inf",
       "case.toml:9:18: cable.youngs_modulus = inf: must be finite: a number greater than 0 (Pa)"},
      {"second_moment = 5e-11", "second_moment = -1e-20",
       "case.toml:10:17: cable.second_moment = -1e-20: must be a number of at least 0 (m⁴)"},
      {"second_moment = 5e-11", "second_moment = nan",
       "case.toml:10:17: cable.second_moment = nan: must be finite: a number of at least 0 (m⁴)"},
      {"elements = 4", "elements = 0",
       "case.toml:11:12: cable.elements = 0: must be a whole number from 1 to 1000000"},
      {"elements = 4", "elements = 1000001",
       "case.toml:11:12: cable.elements = 1000001: must be a whole number from 1 to 1000000"},
      {"elements = 4", "elements = 4.5",
       "case.toml:11:12: cable.elements = 4.5: must be a whole number from 1 to 1000000"},
      {"\"green-geometric\"", "\"green-geometry\"",
       "case.toml:12:10: cable.strain = \"green-geometry\": must be \"green-geometric\" or "
       "\"engineering-material\"; did you mean \"green-geometric\"?"},
      {"quadrature = \"full\"", "quadrature = \"half\"",
       "case.toml:13:14: cable.quadrature = \"half\": must be \"full\" or \"reduced\""},
      {"density = 320", "density = 1e-320",
       "case.toml:8:11: cable.density = 1e-320: the mass, density × area × length, comes to 0; must be "
       "greater than 0 and finite"},
      {"area = \"1e-6 * f^2\"\ndensity = 320\nyoungs_modulus = 1.6e6",
       "area = 10\ndensity = 320\nyoungs_modulus = 1e308",
       "case.toml:9:18: cable.youngs_modulus = 1e308: the stiffness, youngs_modulus × area, comes to inf; "
       "must be greater than 0 and finite"},
      {"area = \"1e-6 * f^2\"\ndensity = 320\nyoungs_modulus = 1.6e6\nsecond_moment = 5e-11",
       "area = 1e160\ndensity = 320\nyoungs_modulus = 1e6",
       "case.toml:7:8: cable.area = 1e160: the bending stiffness is not finite"},
      {"second_moment = 5e-11", "second_moment = 1e306",
       "case.toml:10:17: cable.second_moment = 1e306: the bending stiffness is not finite"},
  });
}

TEST(CaseFaults, ABadStartIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"direction = [3, 0, 4]", "direction = [0, 0, 0]",
       "case.toml:15:13: start.direction = [0, 0, 0]: must not be zero"},
      {"direction = [3, 0, 4]", "direction = [3, inf, 4]",
       "case.toml:15:17: start.direction.1 = inf: must be finite: a number"},
      {"angular_velocity = [0, 4, 0]", "angular_velocity = [0, nan, 0]",
       "case.toml:16:24: start.angular_velocity.1 = nan: must be finite: a number (rad/s)"},
      {"\"rigid\"", "\"zeros\"",
       "case.toml:17:15: start.slope_rates = \"zeros\": must be \"rigid\" or \"zero\"; did you mean "
       "\"zero\"?"},
  });
}

TEST(CaseFaults, ABadSupportIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"\"pinned\"", "\"hinged\"",
       "case.toml:19:9: supports.first = \"hinged\": must be \"free\", \"pinned\" or \"clamped\"; did you "
       "mean \"pinned\"?"},
      {"last = \"free\"", "last = \"clamp\"",
       "case.toml:20:8: supports.last = \"clamp\": must be \"free\", \"pinned\" or \"clamped\"; did you mean "
       "\"clamped\"?"},
  });
}

TEST(CaseFaults, ABadLoadIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"gravity = [0, \"-g + 0.19\", 0]", "gravity = [0, -inf, 0]",
       "case.toml:22:15: loads.gravity.1 = -inf: must be finite: a number (m/s²)"},
      {"gravity = [0, \"-g + 0.19\", 0]", "gravity = [0, -9.81]",
       "case.toml:22:11: loads.gravity = [0, -9.81]: must be a list of 3 numbers (m/s²), found 2 of them"},
  });
}

TEST(CaseFaults, ABadTimeIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"end = 2.0", "end = 0", "case.toml:29:7: time.end = 0: must be a number greater than 0 (s)"},
      {"end = 2.0", "end = -1", "case.toml:29:7: time.end = -1: must be a number greater than 0 (s)"},
      {"end = 2.0", "end = inf",
       "case.toml:29:7: time.end = inf: must be finite: a number greater than 0 (s)"},
      {"output_interval = 0.5", "output_interval = 0",
       "case.toml:30:19: time.output_interval = 0: must be a number greater than 0 (s)"},
      {"output_interval = 0.5", "output_interval = 2.5",
       "case.toml:30:19: time.output_interval = 2.5: must be at most the end time, 2 (s)"},
      {"output_interval = 0.5", "output_interval = 1e-6",
       "case.toml:30:19: time.output_interval = 1e-6: gives 2e+06 outputs until the end time, 2 s; at most "
       "1000000 are allowed"},
  });
}

TEST(CaseFaults, ABadMethodIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"\"generalized-alpha\"", "\"generalised-alpha\"",
       "case.toml:24:8: method.name = \"generalised-alpha\": must be …; did you mean \"generalized-alpha\"?"},
      {"\"generalized-alpha\"", "\"magic\"", "case.toml:24:8: method.name = \"magic\": must be …"},
      {"step = 1e-3", "step = 0", "case.toml:25:8: method.step = 0: must be a number greater than 0 (s)"},
      {"step = 1e-3", "step = -1e-3",
       "case.toml:25:8: method.step = -1e-3: must be a number greater than 0 (s)"},
      {"step = 1e-3", "step = 2.5", "case.toml:25:8: method.step = 2.5: must be at most the end time, 2 (s)"},
      {"step = 1e-3", "step = 1e-10",
       "case.toml:25:8: method.step = 1e-10: gives 2e+10 steps until the end time, 2 s; at most 1000000000 "
       "are allowed"},
      {"spectral_radius = 0.9", "spectral_radius = 1.1",
       "case.toml:26:19: method.spectral_radius = 1.1: must be a number from 0 to 1"},
      {"spectral_radius = 0.9", "spectral_radius = -0.1",
       "case.toml:26:19: method.spectral_radius = -0.1: must be a number from 0 to 1"},
      {"newton_iterations = 15", "newton_iterations = 1.5",
       "case.toml:27:21: method.newton_iterations = 1.5: must be a whole number from 1 to 100"},
      {"newton_iterations = 15", "newton_iterations = 0",
       "case.toml:27:21: method.newton_iterations = 0: must be a whole number from 1 to 100"},
      {"newton_iterations = 15", "rtol = 1e-6",
       "case.toml:25:8: method.step = 1e-3: generalized-alpha takes either step or rtol and atol, not both"},
      {"newton_iterations = 15", "atol = 1e-6",
       "case.toml:25:8: method.step = 1e-3: generalized-alpha takes either step or rtol and atol, not both"},
      {"newton_iterations = 15", "max_order = 3",
       "case.toml:27:1: method.max_order = 3: not a key of generalized-alpha, which takes: …"},
  });
}

TEST(CaseFaults, ABadToleranceIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"cvode-bdf\"\nrtol = 0\n",
       "case.toml:25:8: method.rtol = 0: must be a number greater than 0 and less than 1"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"cvode-bdf\"\nrtol = 1\n",
       "case.toml:25:8: method.rtol = 1: must be a number greater than 0 and less than 1"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"cvode-bdf\"\natol = 0\n",
       "case.toml:25:8: method.atol = 0: must be a number greater than 0 (of L, L/T, 1 and 1/T)"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"cvode-bdf\"\natol = inf\n",
       "case.toml:25:8: method.atol = inf: must be finite: a number greater than 0 (of L, L/T, 1 and 1/T)"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"cvode-bdf\"\nmax_order = 6\n",
       "case.toml:25:13: method.max_order = 6: must be a whole number from 1 to 5"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"cvode-bdf\"\nstep = 1e-3\n",
       "case.toml:25:1: method.step = 1e-3: not a key of cvode-bdf, which takes: …"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"arkode-erk\"\norder = 2.5\n",
       "case.toml:25:9: method.order = 2.5: must be a whole number from 2 to 8"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"arkode-erk\"\nrtol = 1e-6\nstep = 1e-3\n",
       "case.toml:26:8: method.step = 1e-3: arkode-erk takes either step or rtol and atol, not both"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"arkode-dirk\"\nstep = 0\n",
       "case.toml:25:8: method.step = 0: must be a number greater than 0 (s)"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"arkode-dirk\"\nstep = 1e-3\norder = 6\n",
       "case.toml:26:9: method.order = 6: must be a whole number from 2 to 5"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"arkode-dirk\"\nstep = 1e-3\nnewton_tolerance = 0\n",
       "case.toml:26:20: method.newton_tolerance = 0: must be a number from 1e-15 to 0.001"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"cvode-adams\"\nmax_order = 13\n",
       "case.toml:25:13: method.max_order = 13: must be a whole number from 1 to 12"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"ida\"\nstabilised = 2\n",
       "case.toml:25:14: method.stabilised = 2: must be a whole number from 0 to 1"},
      {"name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15\n",
       "name = \"ida\"\nstep = 1e-3\n",
       "case.toml:25:1: method.step = 1e-3: not a key of ida, which takes: …"},
  });
}

TEST(CaseFaults, ABadProbeIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"at = 0.5", "at = 1.01",
       "case.toml:33:6: probe.0.at = 1.01: must be a number from 0 to 1 (fraction of the length)"},
      {"at = 0.5", "at = -0.01",
       "case.toml:33:6: probe.0.at = -0.01: must be a number from 0 to 1 (fraction of the length)"},
      {"at = 0.5", "at = nan",
       "case.toml:33:6: probe.0.at = nan: must be finite: a number from 0 to 1 (fraction of the length)"},
      {"name = \"pull\"", "name = \"mid\"",
       "case.toml:36:8: probe.1.name = \"mid\": is the name of another probe"},
      {"name = \"mid\"", "name = \"mid point\"",
       "case.toml:32:8: probe.0.name = \"mid point\": must be letters, digits, - and _, at most 100, not "
       "starting with -"},
      {"name = \"mid\"", "name = \"-mid\"",
       "case.toml:32:8: probe.0.name = \"-mid\": must be letters, digits, - and _, at most 100, not starting "
       "with -"},
      {"name = \"mid\"", "name = \"mid.y\"",
       "case.toml:32:8: probe.0.name = \"mid.y\": must be letters, digits, - and _, at most 100, not "
       "starting with -"},
      {"name = \"mid\"", "name = \"\"", "case.toml:32:8: probe.0.name = \"\": must not be empty: a name"},
      {"name = \"mid\"", "name = \"t\"", "case.toml:32:8: probe.0.name = \"t\": is the name of the time"},
      {"\"axial-force\"", "\"axial-forces\"",
       "case.toml:38:12: probe.1.quantity = \"axial-forces\": must be \"position\", \"relative-position\", "
       "\"velocity\", \"slope\", "
       "\"axial-strain\", \"axial-force\", \"curvature\" or \"bending-moment\"; did you mean "
       "\"axial-force\"?"},
  });
}

TEST(CaseFaults, ABadUseOfAReferenceIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"\"small_reference.toml\"", "\"absent.toml\"",
       "case.toml:41:8: reference.0.file = \"absent.toml\": cannot be read: its text is not among those of "
       "the case"},
      {"\"small_reference.toml\"", "\"\"",
       "case.toml:41:8: reference.0.file = \"\": must not be empty: the path of a reference file, relative "
       "to this one"},
      {"name = \"book\"", "name = \"the book\"",
       "case.toml:40:8: reference.0.name = \"the book\": must be letters, digits, - and _, at most 100, not "
       "starting with -"},
      {"mid_y = \"mid.y\"", "mid_z = \"mid.y\"",
       "case.toml:42:13: reference.0.compare.mid_z = \"mid.y\": small_reference.toml has no series "
       "\"mid_z\"; did you mean \"mid_y\"?"},
      {"mid_y = \"mid.y\"", "mid_y = \"mid.w\"",
       "case.toml:42:21: reference.0.compare.mid_y = \"mid.w\": not a column of the probes; did you mean "
       "\"mid.x\"?"},
      {"mid_y = \"mid.y\"", "mid_y = \"greatest mid.w\"",
       "case.toml:42:21: reference.0.compare.mid_y = \"greatest mid.w\": not a column of the probes; did you "
       "mean \"mid.x\"?"},
      {"mid_y = \"mid.y\"", "mid_y = \"period mid.y\"",
       "case.toml:42:21: reference.0.compare.mid_y = \"period mid.y\": the unit must be that of the series, "
       "m; "
       "that of the column is s"},
      {"mid_y = \"mid.y\"", "mid_y = \"pull\"",
       "case.toml:42:37: reference.0.compare.force = \"pull\": the column is compared with mid_y already"},
      {"force = \"pull\"", "force = \"mid.y\"",
       "case.toml:42:38: reference.0.compare.force = \"mid.y\": the column is compared with mid_y already"},
      {"mid_y = \"mid.y\", force = \"pull\"", "",
       "case.toml:42:11: reference.0.compare: must name at least one series and its column"},
      {"mid_y = \"mid.y\", force = \"pull\"", "mid_y = \"pull\"",
       "case.toml:42:21: reference.0.compare.mid_y = \"pull\": the unit must be that of the series, m; that "
       "of the column is N"},
      {"norm = \"rms\"", "norm = \"mean\"",
       "case.toml:43:8: reference.0.norm = \"mean\": must be \"max\" or \"rms\"; did you mean \"max\"?"},
      {"tolerance = 0.01", "tolerance = 0",
       "case.toml:44:13: reference.0.tolerance = 0: must be a number greater than 0 (the unit of the "
       "series)"},
      {"tolerance = 0.01", "tolerance = inf",
       "case.toml:44:13: reference.0.tolerance = inf: must be finite: a number greater than 0 (the unit of "
       "the series)"},
      {"reason = \"because\"\n",
       "reason = \"because\"\n[[reference]]\nname = \"book\"\nfile = \"small_reference.toml\"\ncompare = { "
       "mid_y = \"mid.y\" }\ntolerance = 1\n",
       "case.toml:47:8: reference.1.name = \"book\": must differ from that of every other reference"},
  });
}

TEST(CaseFaults, ABadFigureIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"x = \"t\"", "x = \"time\"",
       "case.toml:49:5: figure.0.x = \"time\": not a column of the probes; known: mid.x, mid.y, mid.z, pull, "
       "t"},
      {"y = \"mid.y\"\nx_label", "y = \"mid.w\"\nx_label",
       "case.toml:50:5: figure.0.y = \"mid.w\": not a column of the probes; did you mean \"mid.x\"?"},
      {"y = \"mid.y\"\nx_label", "y = \"t\"\nx_label",
       "case.toml:50:5: figure.0.y = \"t\": not a column of the probes; known: mid.x, mid.y, mid.z, pull"},
      {"reference = \"book\"", "reference = \"books\"",
       "case.toml:53:13: figure.0.reference = \"books\": not the name of a [[reference]]; did you mean "
       "\"book\"?"},
      {"x = \"t\"", "x = \"mid.x\"",
       "case.toml:53:13: figure.0.reference = \"book\": that reference does not compare mid.x"},
      {"name = \"path\"", "name = \"height\"",
       "case.toml:56:8: figure.1.name = \"height\": is the name of another figure"},
      {"name = \"height\"", "name = \"a/b\"",
       "case.toml:47:8: figure.0.name = \"a/b\": must be letters, digits, - and _, at most 100, not starting "
       "with -"},
      {"name = \"height\"", "name = \"..\"",
       "case.toml:47:8: figure.0.name = \"..\": must be letters, digits, - and _, at most 100, not starting "
       "with -"},
      {"equal_axes = false", "equal_axes = true",
       "case.toml:54:14: figure.0.equal_axes = true: the axes have different units, s and m"},
      {"title = \"Height\"", "title = \"Hei\\nght\"",
       "case.toml:48:9: figure.0.title = \"Hei\\nght\": must be one line"},
  });
}

TEST(CaseFaults, ABadSceneIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {"size = [640, 480]", "size = [640, 15]",
       "case.toml:61:14: scene.size.1 = 15: must be a whole number from 16 to 32768"},
      {"size = [640, 480]", "size = [32769, 480]",
       "case.toml:61:9: scene.size.0 = 32769: must be a whole number from 16 to 32768"},
      {"size = [640, 480]", "size = [640.5, 480]",
       "case.toml:61:9: scene.size.0 = 640.5: must be a whole number from 16 to 32768"},
      {"size = [640, 480]", "size = [640]",
       "case.toml:61:8: scene.size = [640]: must be a list of 2 numbers, found 1 of them"},
      {"frame_rate = 10", "frame_rate = 0",
       "case.toml:62:14: scene.frame_rate = 0: must be a number from 0.02 to 1000 (1/s)"},
      {"frame_rate = 10", "frame_rate = 1e6",
       "case.toml:62:14: scene.frame_rate = 1e6: must be a number from 0.02 to 1000 (1/s)"},
      {"end = 2.0", "end = 15000.0",
       "case.toml:62:14: scene.frame_rate = 10: gives 1.5e+05 frames until the end time, 15000 s; at most "
       "100000 "
       "are allowed; give a lower rate"},
      {"size = [640, 480]", "size = [20000, 20000]",
       "case.toml:61:8: scene.size = [20000, 20000]: is 4e+08 pixels; at most 1.5e+08 are allowed"},
      {"supersampling = 2", "supersampling = 0",
       "case.toml:63:17: scene.supersampling = 0: must be a whole number from 1 to 4"},
      {"supersampling = 2", "supersampling = 5",
       "case.toml:63:17: scene.supersampling = 5: must be a whole number from 1 to 4"},
      {"cable_radius = 0.01", "cable_radius = -0.01",
       "case.toml:64:16: scene.cable_radius = -0.01: must be a number of at least 0 (m)"},
      {"target = [0, 0, 0]", "target = [0, 0, 5]",
       "case.toml:67:10: scene.camera.target = [0, 0, 5]: must be somewhere else than eye"},
      {"up = [0, 1, 0]", "up = [0, 0, 0]", "case.toml:68:6: scene.camera.up = [0, 0, 0]: must not be zero"},
      {"up = [0, 1, 0]", "up = [0, 0, -2]",
       "case.toml:68:6: scene.camera.up = [0, 0, -2]: must not be parallel to the view, from eye to target"},
      {"field_of_view = 40", "field_of_view = 0.5",
       "case.toml:69:17: scene.camera.field_of_view = 0.5: must be a number from 1 to 120 (degrees)"},
      {"field_of_view = 40", "field_of_view = 121",
       "case.toml:69:17: scene.camera.field_of_view = 121: must be a number from 1 to 120 (degrees)"},
      {"eye = [0, 0, 5]", "eye = [0, 0, inf]",
       "case.toml:66:14: scene.camera.eye.2 = inf: must be finite: a number (m)"},
  });
}

TEST(CaseFaults, ABadLookOfASceneIsRefusedWithItsPlaceAndWhatIsAllowed) {
  const std::string camera =
      "[scene.camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\nfield_of_view = 40";
  const auto added = [](const std::string& line) { return "cable_radius = 0.01\n" + line; };
  expect_refused({
      {camera, "camera = \"frnt\"",
       "case.toml:65:10: scene.camera = \"frnt\": must be \"fit\", \"front\", \"back\", \"left\", \"right\", "
       "\"top\", \"bottom\", \"orbit\" or \"follow\"; did you mean \"front\"?"},
      {camera, "camera = 5", "case.toml:65:10: scene.camera = 5: must be a table, found a whole number"},
      {"field_of_view = 40", "view_height = 0",
       "case.toml:69:15: scene.camera.view_height = 0: must be a number greater than 0 (m)"},
      {"field_of_view = 40", "field_of_view = 40\nview_height = 2",
       "case.toml:70:15: scene.camera.view_height = 2: is for parallel rays, which have no field_of_view; "
       "give only one"},
      {"cable_radius = 0.01", added("theme = \"drak\""),
       "case.toml:65:9: scene.theme = \"drak\": must be \"light\" or \"dark\"; did you mean \"dark\"?"},
      {"cable_radius = 0.01", added("background = true"),
       "case.toml:65:14: scene.background = true: must be \"scene\", \"plain\" or \"transparent\", found "
       "a boolean"},
      {"cable_radius = 0.01", added("background = \"transparant\""),
       "case.toml:65:14: scene.background = \"transparant\": must be \"scene\", \"plain\" or "
       "\"transparent\"; did you mean \"transparent\"?"},
      {"cable_radius = 0.01", added("color_by = \"axial_force\""),
       "case.toml:65:12: scene.color_by = \"axial_force\": must be \"none\", \"axial-strain\", "
       "\"axial-force\", \"curvature\", \"bending-moment\" or \"speed\"; did you mean \"axial-force\"?"},
      {"cable_radius = 0.01", added("colour_by = \"speed\""),
       "case.toml:65:1: scene.colour_by = \"speed\": unknown key; did you mean \"color_by\"?"},
      {"cable_radius = 0.01", added("ghosts = 51"),
       "case.toml:65:10: scene.ghosts = 51: must be a whole number from 0 to 50"},
      {"cable_radius = 0.01", added("ghosts = -1"),
       "case.toml:65:10: scene.ghosts = -1: must be a whole number from 0 to 50"},
      {"cable_radius = 0.01", added("ghost_interval = 0"),
       "case.toml:65:18: scene.ghost_interval = 0: must be a number greater than 0 (s)"},
      {"cable_radius = 0.01", added("trail = -0.1"),
       "case.toml:65:9: scene.trail = -0.1: must be a number of at least 0 (s)"},
  });
}

}  // namespace case_faults_test
}  // namespace plumb
