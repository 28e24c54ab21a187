#include "engine/run/run_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

#include "engine/base/checked_file.h"
#include "engine/base/codec.h"
#include "engine/base/errors.h"
#include "engine/base/hdf5.h"
#include "engine/base/message.h"
#include "engine/model/support_constraints.h"
#include "engine/read/given_probes.h"
#include "engine/read/stored_source.h"
#include "engine/run/mode_table.h"
#include "engine/run/stored_parts.h"

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

constexpr const char* multipliers_path = "constraints/multipliers";
constexpr const char* shortest_cut_path = "shortest_cut";
constexpr const char* unstable_since_path = "unstable_since";
constexpr const char* equilibria_path = "equilibria/negative_eigenvalues";
constexpr const char* critical_path = "equilibria/critical_points";
constexpr const char* drift_path = "constraints/drift";

/// A number of each point of the path of statics.
struct PathColumn {
  const char* path;
  const char* unit;
  double (*value)(const PathPoint&);
  void (*take)(double, PathPoint&);
};
const PathColumn path_columns[] = {
    {"equilibria/path/load", "1", [](const PathPoint& p) { return p.load; },
     [](double value, PathPoint& p) { p.load = value; }},
    {"equilibria/path/displacement", "m", [](const PathPoint& p) { return p.displacement; },
     [](double value, PathPoint& p) { p.displacement = value; }},
    {"equilibria/path/negative_eigenvalues", "1",
     [](const PathPoint& p) { return static_cast<double>(p.negative); },
     [](double value, PathPoint& p) { p.negative = static_cast<int>(std::clamp(value, -1.0, 1e9)); }},
    {"equilibria/path/joined", "1", [](const PathPoint& p) { return p.joined ? 1.0 : 0.0; },
     [](double value, PathPoint& p) { p.joined = value != 0; }}};

/// What only statics has.
void write_equilibria(const Equilibria& equilibria, hdf5::Writer& file) {
  if (equilibria.path.empty()) return;
  file.integers(equilibria_path,
                {equilibria.negative_eigenvalues.begin(), equilibria.negative_eigenvalues.end()});
  std::vector<double> values;
  for (const PathColumn& column : path_columns) {
    values.clear();
    for (const PathPoint& point : equilibria.path) values.push_back(column.value(point));
    file.numbers(column.path, {values.size()}, values.data(), column.unit);
  }
  file.text(critical_path, encode(equilibria.critical_points).dump());
}

void read_equilibria(const hdf5::Reader& file, Trajectory& result) {
  if (!file.has(equilibria_path)) return;
  for (const long negative : file.integers(equilibria_path))
    result.equilibria.negative_eigenvalues.push_back(
        static_cast<int>(std::clamp(negative, -1L, 1'000'000'000L)));
  if (result.equilibria.negative_eigenvalues.size() != result.times.size())
    throw std::runtime_error("its equilibria are not one an output");
  std::vector<PathPoint>& path = result.equilibria.path;
  for (const PathColumn& column : path_columns) {
    const std::vector<double> values = file.numbers(column.path).values;
    if (path.empty()) path.resize(values.size());
    if (path.size() != values.size()) throw std::runtime_error("its path of equilibria is not whole");
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (!std::isfinite(values[k])) throw std::runtime_error("its path of equilibria is not finite");
      column.take(values[k], path[k]);
    }
  }
  try {
    decode(nlohmann::ordered_json::parse(file.text(critical_path)), result.equilibria.critical_points);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(std::string("its critical points cannot be read: ") + error.what());
  }
}

constexpr const char* kinds_path = "modes/kind";

/// A number of each mode.
struct ModeNumber {
  const char* path;
  const char* unit;
  double VibrationMode::*number;
};
const ModeNumber mode_numbers[] = {{"modes/frequency", "1/s", &VibrationMode::frequency},
                                   {"modes/damping_ratio", "1", &VibrationMode::damping_ratio},
                                   {"modes/decay", "1/s", &VibrationMode::decay},
                                   {"modes/residual", "1", &VibrationMode::residual}};

/// Shapes, (modes, nodes, 6), and where there is one with a phase of its own their imaginary parts.
struct ModeShapes {
  const char* path;
  Eigen::VectorXd VibrationMode::*shape;
};
const ModeShapes mode_shapes[] = {{"modes/shape", &VibrationMode::shape},
                                  {"modes/quadrature", &VibrationMode::quadrature}};

/// What only a method that looks for modes has.
void write_vibrations(const Vibrations& vibrations, hdf5::Writer& file) {
  if (vibrations.modes.empty()) return;
  const std::vector<VibrationMode>& modes = vibrations.modes;
  std::vector<long> kinds;
  for (const VibrationMode& mode : modes) kinds.push_back(static_cast<long>(mode.kind));
  file.integers(kinds_path, kinds);
  std::vector<double> values;
  for (const auto& [path, unit, number] : mode_numbers) {
    values.clear();
    for (const VibrationMode& mode : modes) values.push_back(mode.*number);
    file.numbers(path, {modes.size()}, values.data(), unit);
  }
  const auto size = static_cast<hsize_t>(modes.front().shape.size());
  for (const auto& [path, shape] : mode_shapes) {
    values.clear();
    bool any = false;
    for (const VibrationMode& mode : modes) {
      any = any || (mode.*shape).size() > 0;
      values.insert(values.end(), (mode.*shape).begin(), (mode.*shape).end());
      values.resize(values.size() + size - static_cast<hsize_t>((mode.*shape).size()), 0);
    }
    if (any) file.numbers(path, {modes.size(), size / 6, 6}, values.data(), "1/sqrt(kg), slopes per m");
  }
  file.number("modes/spin", vibrations.spin, "rad/s");
  file.numbers("modes/axis", {3}, vibrations.axis.data(), "1");
  file.number("modes/orthonormality", vibrations.orthonormality, "1");
}

void read_vibrations(const hdf5::Reader& file, Trajectory& result) {
  if (!file.has(kinds_path)) return;
  Vibrations& found = result.vibrations;
  const auto refuse = [](const char* what) { throw std::runtime_error(std::string("its modes ") + what); };
  for (const long kind : file.integers(kinds_path)) {
    if (kind < 0 || kind >= static_cast<long>(mode_kinds().size())) refuse("are of no known kind");
    found.modes.emplace_back().kind = static_cast<ModeKind>(kind);
    found.rigid_body += found.modes.back().kind == ModeKind::rigid_body ? 1 : 0;
  }
  const auto all_finite = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  };
  for (const auto& [path, unit, number] : mode_numbers) {
    const std::vector<double> values = file.numbers(path, {found.modes.size()});
    if (!all_finite(values)) refuse("are not finite");
    for (std::size_t k = 0; k < values.size(); ++k) found.modes[k].*number = values[k];
  }
  const auto nodes = static_cast<hsize_t>(result.elements) + 1;
  for (const auto& [path, shape] : mode_shapes) {
    if (!file.has(path)) continue;
    const std::vector<double> values = file.numbers(path, {found.modes.size(), nodes, 6});
    if (!all_finite(values)) refuse("have shapes that are not finite");
    const auto size = static_cast<Eigen::Index>(6 * nodes);
    for (std::size_t k = 0; k < found.modes.size(); ++k) {
      const Eigen::Map<const Eigen::VectorXd> numbers(values.data() + static_cast<Eigen::Index>(k) * size,
                                                      size);
      if (shape == &VibrationMode::shape || !numbers.isZero(0)) found.modes[k].*shape = numbers;
    }
  }
  if (!found.modes.empty() && found.modes.front().shape.size() == 0) refuse("have no shapes");
  found.spin = file.number("modes/spin");
  const std::vector<double> axis = file.numbers("modes/axis", {3});
  found.axis = Eigen::Map<const Eigen::Vector3d>(axis.data());
  found.orthonormality = file.number("modes/orthonormality");
  if (!std::isfinite(found.spin + found.axis.sum() + found.orthonormality))
    refuse("turn with what is no number");
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
  file.number(shortest_cut_path, trajectory.shortest_cut, "s");
  file.number(unstable_since_path, trajectory.unstable_since, "s");
  file.numbers("time", {outputs}, trajectory.times.data(), "s");
  std::vector<double> values;
  for (const Field& field : fields) {
    values.clear();
    for (const Eigen::VectorXd& state : trajectory.*field.coordinates)
      for (Eigen::Index node = 0; node < state.size() / 6; ++node)
        for (int k = 0; k < 3; ++k) values.push_back(state[6 * node + field.offset + k]);
    file.numbers(field.path, {outputs, nodes, 3}, values.data(), field.unit);
  }
  for (const auto& [name, part] : stored_energies()) {
    values.clear();
    for (const Energies& e : trajectory.energies) values.push_back(e.*part);
    file.numbers(fmt::format("energy/{}", name), {outputs}, values.data(), "J");
  }
  for (const auto& [name, part] : stored_counters())
    file.integer(fmt::format("counters/{}", name), trajectory.counters.*part);
  write_equilibria(trajectory.equilibria, file);
  write_vibrations(trajectory.vibrations, file);
  if (trajectory.multipliers.empty()) return;
  values.clear();
  for (const Eigen::VectorXd& lambda : trajectory.multipliers)
    values.insert(values.end(), lambda.begin(), lambda.end());
  const auto rows = static_cast<hsize_t>(trajectory.multipliers.front().size());
  file.numbers(multipliers_path, {outputs, rows}, values.data(), "N and N m");
  file.number(drift_path, trajectory.constraint_drift, "m");
}

/// What only methods that carry the supports as constraints have.
void read_constraints(const hdf5::Reader& file, Trajectory& result) {
  if (!file.has(multipliers_path)) return;
  const hdf5::Numbers numbers = file.numbers(multipliers_path);
  const hsize_t outputs = result.times.size();
  if (numbers.shape.size() != 2 || numbers.shape[0] != outputs || numbers.shape[1] == 0)
    throw std::runtime_error("its multipliers are not one set an output");
  const auto rows = static_cast<Eigen::Index>(numbers.shape[1]);
  for (std::size_t k = 0; k < outputs; ++k)
    result.multipliers.push_back(
        Eigen::Map<const Eigen::VectorXd>(numbers.values.data() + static_cast<Eigen::Index>(k) * rows, rows));
  result.constraint_drift = file.number(drift_path);
}

/// Throws std::runtime_error where numbers read cannot be those of a run.
void check(const Trajectory& trajectory) {
  const auto finite = [](const Eigen::VectorXd& x) { return x.allFinite(); };
  if (trajectory.outcome == Outcome::not_run) throw std::runtime_error("it holds no run");
  if (!(trajectory.element_length > 0) || !std::isfinite(trajectory.element_length + trajectory.end_time +
                                                         trajectory.shortest_cut + trajectory.unstable_since))
    throw std::runtime_error("its lengths and times are not those of a run");
  if (trajectory.times.empty() || trajectory.times.front() != 0)
    throw std::runtime_error("its times do not begin at 0");
  for (std::size_t k = 1; k < trajectory.times.size(); ++k)
    if (!(trajectory.times[k] > trajectory.times[k - 1]))
      throw std::runtime_error("its times do not increase");
  if (!std::isfinite(trajectory.times.back())) throw std::runtime_error("its times are not finite");
  if (!std::all_of(trajectory.q.begin(), trajectory.q.end(), finite) ||
      !std::all_of(trajectory.v.begin(), trajectory.v.end(), finite))
    throw std::runtime_error("its states are not finite");
  if (!std::all_of(trajectory.multipliers.begin(), trajectory.multipliers.end(), finite) ||
      !std::isfinite(trajectory.constraint_drift))
    throw std::runtime_error("its multipliers are not finite");
  for (const Energies& e : trajectory.energies)
    if (!std::isfinite(e.total())) throw std::runtime_error("its energies are not finite");
}

Trajectory read_trajectory(const hdf5::Reader& file) {
  Trajectory result;
  result.outcome = outcome_named(file.text("outcome"));
  result.message = one_line(file.text("message"));
  const long elements = file.integer("elements");
  if (elements < 1 || elements > most_elements_of_a_cable)
    throw std::runtime_error(fmt::format("it has {} elements", elements));
  result.elements = static_cast<int>(elements);
  result.interpolated_outputs = static_cast<int>(file.integer("interpolated_outputs"));
  result.element_length = file.number("element_length");
  result.end_time = file.number("end_time");
  result.solve_seconds = file.number("solve_seconds");
  // Runs of older versions do not have them.
  if (file.has(shortest_cut_path)) result.shortest_cut = file.number(shortest_cut_path);
  if (file.has(unstable_since_path)) result.unstable_since = file.number(unstable_since_path);
  result.times = file.numbers("time").values;
  const hsize_t outputs = result.times.size(), nodes = static_cast<hsize_t>(elements) + 1;
  for (const Field& field : fields) {
    const std::vector<double> values = file.numbers(field.path, {outputs, nodes, 3});
    auto& states = result.*field.coordinates;
    states.resize(outputs, Eigen::VectorXd(6 * (elements + 1)));
    auto value = values.begin();
    for (Eigen::VectorXd& state : states)
      for (Eigen::Index node = 0; node <= elements; ++node)
        for (int k = 0; k < 3; ++k) state[6 * node + field.offset + k] = *value++;
  }
  result.energies.resize(outputs);
  for (const auto& [name, part] : stored_energies()) {
    const std::string path = fmt::format("energy/{}", name);
    // Runs of older versions have no more than kinetic, strain and potential energy.
    if (!is_stored_always(part) && !file.has(path.c_str())) continue;
    const std::vector<double> values = file.numbers(path, {outputs});
    for (std::size_t k = 0; k < outputs; ++k) result.energies[k].*part = values[k];
  }
  for (const auto& [name, part] : stored_counters())
    result.counters.*part = file.integer(fmt::format("counters/{}", name));
  read_equilibria(file, result);
  read_vibrations(file, result);
  read_constraints(file, result);
  check(result);
  return result;
}

}  // namespace

std::string encode_run(const Run& run) {
  hdf5::Writer file;
  write_format(format_name, run_file_version, file);
  write_source(run.loaded.source, file);
  if (reports_given_run(run.loaded.spec)) {
    file.numbers("time", {run.trajectory.times.size()}, run.trajectory.times.data(), "s");
    if (const GivenEnding& ending = run.loaded.given_runs.front().ending; !ending.outcome.empty()) {
      file.text("given/outcome", ending.outcome);
      file.text("given/message", ending.message);
    }
  } else {
    write_trajectory(run.trajectory, file);
  }
  for (const Column& column : run.probes.columns)
    file.numbers("probes/" + column.name, {column.values.size()}, column.values.data(), column.unit);
  write_provenance(run.provenance, file);
  return with_check_sum(file.bytes());
}

Run read_run(const std::string& path, const SectionUse& uses) {
  try {
    const std::string bytes = read_checked(path, "run file");
    const hdf5::Reader file(bytes);
    read_format(file, format_name, run_file_version, "run file");
    Run run;
    const bool has_states = file.has("outcome");
    if (has_states) run.trajectory = read_trajectory(file);
    run.provenance = read_provenance(file);
    run.loaded = load_case(read_source(file), uses);
    if (has_states == reports_given_run(run.loaded.spec))
      throw std::runtime_error(has_states ? "it has states, and a case without [method]"
                                          : "it has neither states nor an external run that is reported");
    if (!has_states) return reported_run(std::move(run.loaded), std::move(run.provenance));
    const Case& spec = run.loaded.spec;
    if (spec.cable.elements != run.trajectory.elements)
      throw std::runtime_error("its states and its case have different numbers of elements");
    const SupportConstraints constraints(spec.supports, spec.start.direction, spec.cable.elements + 1);
    if (!run.trajectory.multipliers.empty() &&
        run.trajectory.multipliers.front().size() != constraints.count())
      throw std::runtime_error("its multipliers are not those of its supports");
    run.probes = probe(run.loaded.spec, run.trajectory);
    run.modes = mode_table(run.loaded.spec, run.trajectory);
    return run;
  } catch (const Interrupted&) {
    throw;
  } catch (const InputError& error) {
    throw InputError(one_line(path + ": the case in it is invalid: " + error.what()));
  } catch (const std::bad_alloc&) {
    throw InputError(one_line(path) + ": cannot be used: it is too large for the memory at hand");
  } catch (const std::runtime_error& error) {
    throw InputError(one_line(path + ": cannot be used: " + reason(error)));
  }
}

}  // namespace plumb
