#include "engine/output/run_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "engine/errors.h"
#include "engine/output/hdf5.h"

namespace plumb {
namespace {

constexpr std::string_view format_name = "plumb-run";

/// A nodal vector field over the outputs, (outputs, nodes, 3): the positions (offset 0) or slopes (offset 3)
/// in q, or their rates in v.
struct Field {
  std::string path;
  std::string unit;
  std::vector<Eigen::VectorXd> Trajectory::*coordinates;
  int offset;
};

const Field fields[] = {{"states/position", "m", &Trajectory::q, 0},
                        {"states/slope", "1", &Trajectory::q, 3},
                        {"states/velocity", "m/s", &Trajectory::v, 0},
                        {"states/slope_rate", "1/s", &Trajectory::v, 3}};

const std::pair<const char*, double Energies::*> energy_parts[] = {
    {"energy/kinetic", &Energies::kinetic},
    {"energy/axial", &Energies::axial},
    {"energy/bending", &Energies::bending},
    {"energy/potential", &Energies::potential}};

const std::pair<const char*, long Counters::*> counter_parts[] = {
    {"counters/steps", &Counters::steps},
    {"counters/rejected_steps", &Counters::rejected_steps},
    {"counters/force_evaluations", &Counters::force_evaluations},
    {"counters/tangent_evaluations", &Counters::tangent_evaluations},
    {"counters/factorizations", &Counters::factorizations},
    {"counters/newton_iterations", &Counters::newton_iterations}};

Outcome outcome_of(const std::string& name) {
  for (const Outcome outcome : {Outcome::not_run, Outcome::completed, Outcome::unstable, Outcome::diverged,
                                Outcome::no_convergence, Outcome::singular})
    if (word(outcome) == name) return outcome;
  throw std::runtime_error("the outcome '" + name + "' is unknown");
}

void write_trajectory(const Trajectory& trajectory, hdf5::Writer& file) {
  const hsize_t outputs = trajectory.times.size();
  const auto nodes = static_cast<hsize_t>(trajectory.elements + 1);
  file.text("outcome", word(trajectory.outcome));
  file.text("message", trajectory.message);
  file.integer("elements", trajectory.elements);
  file.integer("interpolated_outputs", trajectory.interpolated_outputs);
  file.number("element_length", trajectory.element_length, "m");
  file.number("end_time", trajectory.end_time, "s");
  file.number("solve_seconds", trajectory.solve_seconds, "s");
  file.numbers("time", {outputs}, trajectory.times.data(), "s");
  std::vector<double> values;
  for (const Field& field : fields) {
    values.clear();
    for (const Eigen::VectorXd& state : trajectory.*field.coordinates)
      for (Eigen::Index node = 0; node < state.size() / 6; ++node)
        for (int k = 0; k < 3; ++k) values.push_back(state[6 * node + field.offset + k]);
    file.numbers(field.path, {outputs, nodes, 3}, values.data(), field.unit);
  }
  for (const auto& [path, part] : energy_parts) {
    values.clear();
    for (const Energies& e : trajectory.energies) values.push_back(e.*part);
    file.numbers(path, {outputs}, values.data(), "J");
  }
  for (const auto& [path, part] : counter_parts) file.integer(path, trajectory.counters.*part);
}

Trajectory read_trajectory(const hdf5::Reader& file) {
  Trajectory result;
  result.outcome = outcome_of(file.text("outcome"));
  result.message = file.text("message");
  result.elements = static_cast<int>(file.integer("elements"));
  result.interpolated_outputs = static_cast<int>(file.integer("interpolated_outputs"));
  result.element_length = file.number("element_length");
  result.end_time = file.number("end_time");
  result.solve_seconds = file.number("solve_seconds");
  result.times = file.numbers("time").values;
  const std::size_t outputs = result.times.size(), nodes = static_cast<std::size_t>(result.elements) + 1;
  result.q.assign(outputs, Eigen::VectorXd(6 * nodes));
  result.v = result.q;
  for (const Field& field : fields) {
    const hdf5::Numbers numbers = file.numbers(field.path);
    if (numbers.shape != std::vector<hsize_t>{outputs, nodes, 3})
      throw std::runtime_error(
          fmt::format("the data set {} is not {} by {} by 3", field.path, outputs, nodes));
    auto value = numbers.values.begin();
    for (Eigen::VectorXd& state : result.*field.coordinates)
      for (std::size_t node = 0; node < nodes; ++node)
        for (int k = 0; k < 3; ++k) state[static_cast<Eigen::Index>(6 * node) + field.offset + k] = *value++;
  }
  result.energies.resize(outputs);
  for (const auto& [path, part] : energy_parts) {
    const hdf5::Numbers numbers = file.numbers(path);
    if (numbers.values.size() != outputs)
      throw std::runtime_error(fmt::format("the data set {} does not have {} numbers", path, outputs));
    for (std::size_t k = 0; k < outputs; ++k) result.energies[k].*part = numbers.values[k];
  }
  for (const auto& [path, part] : counter_parts) result.counters.*part = file.integer(path);
  return result;
}

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
}

CaseSource read_source(const hdf5::Reader& file) {
  CaseSource source{{file.text("case/name"), file.text("case/text")}, file.texts("case/overrides"), {}};
  const auto names = file.texts("case/reference_names"), texts = file.texts("case/reference_texts");
  if (names.size() != texts.size()) throw std::runtime_error("its references do not have one name each");
  for (std::size_t k = 0; k < names.size(); ++k) source.references.push_back({names[k], texts[k]});
  return source;
}

}  // namespace

std::string encode_run(const Run& run) {
  hdf5::Writer file;
  file.text("format", format_name);
  file.integer("format_version", run_file_version);
  write_source(run.loaded.source, file);
  write_trajectory(run.trajectory, file);
  for (const Column& column : run.probes.columns)
    file.numbers("probes/" + column.name, {column.values.size()}, column.values.data(), column.unit);
  std::vector<std::string> names, values;
  for (const auto& [name, value] : run.provenance) {
    names.push_back(name);
    values.push_back(value);
  }
  file.texts("provenance/names", names);
  file.texts("provenance/values", values);
  return file.bytes();
}

Run read_run(const std::string& path) {
  if (!std::filesystem::exists(path)) throw InputError(path + ": there is no such run file");
  try {
    const hdf5::Reader file(path);
    if (file.text("format") != format_name) throw std::runtime_error("it is no run file of Plumb");
    if (const long version = file.integer("format_version"); version > run_file_version)
      throw std::runtime_error(
          fmt::format("its format version is {}, this program reads up to {}", version, run_file_version));
    Run run;
    run.trajectory = read_trajectory(file);
    const auto names = file.texts("provenance/names"), values = file.texts("provenance/values");
    for (std::size_t k = 0; k < std::min(names.size(), values.size()); ++k)
      run.provenance.emplace_back(names[k], values[k]);
    run.loaded = load_case(read_source(file));
    if (run.loaded.spec.cable.elements != run.trajectory.elements)
      throw std::runtime_error("its states and its case have different numbers of elements");
    run.probes = probe(run.loaded.spec, run.trajectory);
    return run;
  } catch (const InputError& error) {
    throw InputError(path + ": the case in it is invalid: " + error.what());
  } catch (const std::runtime_error& error) {
    throw InputError(path + ": cannot be used: " + error.what());
  }
}

}  // namespace plumb
