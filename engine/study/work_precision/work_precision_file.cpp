#include "engine/study/work_precision/work_precision_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

#include "engine/base/checked_file.h"
#include "engine/base/errors.h"
#include "engine/base/hdf5.h"
#include "engine/base/message.h"
#include "engine/model/greatest_eigenfrequency.h"
#include "engine/read/stored_source.h"
#include "engine/run/stored_parts.h"
#include "engine/study/study_record.h"
#include "engine/study/work_precision/run_work_precision.h"
#include "engine/study/work_precision/work_precision_members.h"

namespace plumb {
namespace {

constexpr std::string_view format_name = "plumb-study";
constexpr const char* given_path = "given_curves";  // of other programs, as JSON

struct StoredNorm {
  const char* name;
  double ErrorNorms::*value;
  const char* unit;
};
constexpr StoredNorm norms[] = {{"tip_max", &ErrorNorms::tip_max, "m"},
                                {"tip_rms", &ErrorNorms::tip_rms, "m"},
                                {"curve", &ErrorNorms::curve, "m"},
                                {"energy", &ErrorNorms::energy, "1"}};

struct Errors {
  const char* group;
  ErrorNorms WorkPrecisionRun::*value;
};
constexpr Errors errors[] = {{"runs/time_error", &WorkPrecisionRun::time_error},
                             {"runs/total_error", &WorkPrecisionRun::total_error}};

/// Settings of a run that may be missing, which 0 stands for.
struct Setting {
  const char* path;
  std::optional<double> MethodSpec::*value;
  const char* unit;
};
constexpr Setting settings[] = {{"runs/step", &MethodSpec::step, "s"},
                                {"runs/rtol", &MethodSpec::rtol, "1"},
                                {"runs/atol", &MethodSpec::atol, "m, m/s, 1, 1/s"}};

constexpr MethodFamily families[] = {MethodFamily::explicit_one_step, MethodFamily::structural,
                                     MethodFamily::implicit_stages, MethodFamily::multistep,
                                     MethodFamily::constrained};

/// Writes a column: what `get` gives of each row.
template <class Rows, class Get>
void numbers(hdf5::Writer& file, const std::string& path, const Rows& rows, const std::string& unit,
             Get get) {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(get(row));
  file.numbers(path, {values.size()}, values.data(), unit);
}

template <class Rows, class Get>
void integers(hdf5::Writer& file, const std::string& path, const Rows& rows, Get get) {
  std::vector<long> values;
  for (const auto& row : rows) values.push_back(static_cast<long>(get(row)));
  file.integers(path, values);
}

template <class Rows, class Get>
void texts(hdf5::Writer& file, const std::string& path, const Rows& rows, Get get) {
  std::vector<std::string> values;
  for (const auto& row : rows) values.emplace_back(get(row));
  file.texts(path, values);
}

void write_runs(const std::vector<WorkPrecisionRun>& runs, hdf5::Writer& file) {
  texts(file, "runs/method", runs, [](const WorkPrecisionRun& run) { return run.method.name; });
  for (const Setting& setting : settings)
    numbers(file, setting.path, runs, setting.unit,
            [&](const WorkPrecisionRun& run) { return (run.method.*setting.value).value_or(0); });
  integers(file, "runs/elements", runs, [](const WorkPrecisionRun& run) { return run.elements; });
  texts(file, "runs/outcome", runs, [](const WorkPrecisionRun& run) { return word(run.outcome); });
  texts(file, "runs/message", runs, [](const WorkPrecisionRun& run) { return run.message; });
  for (const auto& [name, part] : stored_counters())
    integers(file, fmt::format("runs/counters/{}", name), runs,
             [counter = part](const WorkPrecisionRun& run) { return run.counters.*counter; });
  for (const Errors& of : errors)
    for (const StoredNorm& norm : norms)
      numbers(file, fmt::format("{}/{}", of.group, norm.name), runs, norm.unit,
              [&](const WorkPrecisionRun& run) { return run.*of.value.*norm.value; });
  std::vector<long> parameter_runs, seconds_runs;
  std::vector<std::string> parameter_names;
  std::vector<double> parameter_values, seconds;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    for (const auto& [name, value] : runs[k].method.parameters) {
      parameter_runs.push_back(static_cast<long>(k));
      parameter_names.push_back(name);
      parameter_values.push_back(value);
    }
    for (const double time : runs[k].seconds) {
      seconds_runs.push_back(static_cast<long>(k));
      seconds.push_back(time);
    }
  }
  file.integers("runs/parameters/run", parameter_runs);
  file.texts("runs/parameters/name", parameter_names);
  file.numbers("runs/parameters/value", {parameter_values.size()}, parameter_values.data(), "1");
  file.integers("runs/seconds/run", seconds_runs);
  file.numbers("runs/seconds/value", {seconds.size()}, seconds.data(), "s");
}

void write_curves(const std::vector<MethodCurve>& curves, hdf5::Writer& file) {
  texts(file, "curves/label", curves, [](const MethodCurve& c) { return c.label; });
  texts(file, "curves/method", curves, [](const MethodCurve& c) { return c.method; });
  texts(file, "curves/family", curves, [](const MethodCurve& c) { return word(c.family); });
  texts(file, "curves/stated_order", curves, [](const MethodCurve& c) { return c.stated_order; });
  texts(file, "curves/ending", curves, [](const MethodCurve& c) { return c.ending; });
  integers(file, "curves/elements", curves, [](const MethodCurve& c) { return c.elements; });
  // Not read back but found again; for whoever reads the file with other tools.
  numbers(file, "curves/observed_order", curves, "1", [](const MethodCurve& c) { return c.observed.order; });
  numbers(file, "curves/observed_order_deviation", curves, "1",
          [](const MethodCurve& c) { return c.observed.deviation; });
  std::vector<long> of, runs;
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (const std::size_t run : curves[k].runs) {
      of.push_back(static_cast<long>(k));
      runs.push_back(static_cast<long>(run));
    }
  file.integers("curves/runs/curve", of);
  file.integers("curves/runs/run", runs);
}

void write_references(const WorkPrecision& study, hdf5::Writer& file) {
  std::vector<CertifiedReference> all = study.mesh_references;
  all.push_back(study.converged_reference);
  integers(file, "references/elements", all, [](const CertifiedReference& r) { return r.elements; });
  texts(file, "references/first", all, [](const CertifiedReference& r) { return r.first; });
  texts(file, "references/second", all, [](const CertifiedReference& r) { return r.second; });
  numbers(file, "references/agreement", all, "m", [](const CertifiedReference& r) { return r.agreement; });
  numbers(file, "references/floor", all, "m", [](const CertifiedReference& r) { return r.floor; });
  integers(file, "references/certified", all,
           [](const CertifiedReference& r) { return r.certified ? 1 : 0; });
  file.number("converged_mesh_error", study.converged_mesh_error, "m");
}

void write_mesh(const MeshConvergence& mesh, hdf5::Writer& file) {
  integers(file, "mesh/elements", mesh.elements, [](int n) { return n; });
  file.numbers("mesh/distance", {mesh.distance.size()}, mesh.distance.data(), "m");
  file.numbers("mesh/change", {mesh.change.size()}, mesh.change.data(), "m");
  file.number("mesh/observed_order", mesh.observed_order, "1");
  file.number("mesh/extrapolated_error", mesh.extrapolated_error, "m");
  file.number("mesh/grid_convergence_index", mesh.grid_convergence_index, "m");
  file.number("mesh/safety_factor", mesh.safety_factor, "1");
  file.text("mesh/standard", mesh.standard);
}

[[noreturn]] void inconsistent(const std::string& what) {
  throw std::runtime_error(what + " is not that of a study");
}

/// Columns of one length, read by the rows they belong to.
class Columns {
 public:
  Columns(const hdf5::Reader& file, std::size_t rows) : file_(file), rows_(rows) {}

  std::vector<double> numbers(const std::string& path) const {
    std::vector<double> values = file_.numbers(path, {rows_});
    if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }))
      inconsistent(path);
    return values;
  }
  std::vector<long> integers(const std::string& path) const { return whole(path, file_.integers(path)); }
  std::vector<std::string> texts(const std::string& path) const { return whole(path, file_.texts(path)); }

 private:
  template <class Values>
  Values whole(const std::string& path, Values values) const {
    if (values.size() != rows_) inconsistent(path);
    return values;
  }

  const hdf5::Reader& file_;
  std::size_t rows_;
};

std::size_t index_in(long index, std::size_t size, const std::string& path) {
  if (index < 0 || static_cast<std::size_t>(index) >= size) inconsistent(path);
  return static_cast<std::size_t>(index);
}

int elements_of(long elements, const std::string& path) {
  constexpr long most_elements = 2000000;
  if (elements < 1 || elements > most_elements) inconsistent(path);
  return static_cast<int>(elements);
}

std::vector<WorkPrecisionRun> read_runs(const hdf5::Reader& file) {
  const std::vector<std::string> names = file.texts("runs/method");
  std::vector<WorkPrecisionRun> runs(names.size());
  const Columns columns(file, runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k) runs[k].method.name = one_line(names[k]);
  for (const Setting& setting : settings) {
    const auto values = columns.numbers(setting.path);
    for (std::size_t k = 0; k < runs.size(); ++k)
      if (values[k] != 0) runs[k].method.*setting.value = values[k];
  }
  const auto elements = columns.integers("runs/elements");
  const auto outcome = columns.texts("runs/outcome"), message = columns.texts("runs/message");
  for (std::size_t k = 0; k < runs.size(); ++k) {
    runs[k].elements = elements_of(elements[k], "runs/elements");
    runs[k].outcome = outcome_named(outcome[k]);
    runs[k].message = one_line(message[k]);
  }
  for (const auto& [name, part] : stored_counters()) {
    const auto values = columns.integers(fmt::format("runs/counters/{}", name));
    for (std::size_t k = 0; k < runs.size(); ++k) runs[k].counters.*part = values[k];
  }
  for (const Errors& of : errors)
    for (const StoredNorm& norm : norms) {
      const auto values = columns.numbers(fmt::format("{}/{}", of.group, norm.name));
      for (std::size_t k = 0; k < runs.size(); ++k) runs[k].*of.value.*norm.value = values[k];
    }
  const auto parameter_names = file.texts("runs/parameters/name");
  const Columns parameters(file, parameter_names.size());
  const auto parameter_runs = parameters.integers("runs/parameters/run");
  const auto parameter_values = parameters.numbers("runs/parameters/value");
  for (std::size_t k = 0; k < parameter_names.size(); ++k)
    runs[index_in(parameter_runs[k], runs.size(), "runs/parameters/run")]
        .method.parameters[one_line(parameter_names[k])] = parameter_values[k];
  const auto seconds_runs = file.integers("runs/seconds/run");
  const auto seconds = Columns(file, seconds_runs.size()).numbers("runs/seconds/value");
  for (std::size_t k = 0; k < seconds.size(); ++k) {
    if (!(seconds[k] >= 0)) inconsistent("runs/seconds/value");
    runs[index_in(seconds_runs[k], runs.size(), "runs/seconds/run")].seconds.push_back(seconds[k]);
  }
  return runs;
}

std::vector<MethodCurve> read_curves(const hdf5::Reader& file, std::size_t runs) {
  const auto labels = file.texts("curves/label");
  std::vector<MethodCurve> curves(labels.size());
  const Columns columns(file, curves.size());
  const auto method = columns.texts("curves/method"), family = columns.texts("curves/family"),
             order = columns.texts("curves/stated_order"), ending = columns.texts("curves/ending");
  const auto elements = columns.integers("curves/elements");
  for (std::size_t k = 0; k < curves.size(); ++k) {
    curves[k].label = one_line(labels[k]);
    curves[k].method = one_line(method[k]);
    curves[k].stated_order = one_line(order[k]);
    curves[k].ending = one_line(ending[k]);
    curves[k].elements = elements_of(elements[k], "curves/elements");
    const auto known = std::find_if(std::begin(families), std::end(families),
                                    [&](MethodFamily any) { return word(any) == family[k]; });
    if (known == std::end(families)) inconsistent("curves/family");
    curves[k].family = *known;
  }
  const auto of = file.integers("curves/runs/curve");
  const auto indices = Columns(file, of.size()).integers("curves/runs/run");
  for (std::size_t k = 0; k < of.size(); ++k)
    curves[index_in(of[k], curves.size(), "curves/runs/curve")].runs.push_back(
        index_in(indices[k], runs, "curves/runs/run"));
  return curves;
}

void read_references(const hdf5::Reader& file, WorkPrecision& study) {
  const auto elements = file.integers("references/elements");
  const Columns columns(file, elements.size());
  const auto first = columns.texts("references/first"), second = columns.texts("references/second");
  const auto agreements = columns.numbers("references/agreement");
  if (elements.empty()) inconsistent("references/elements");
  for (std::size_t k = 0; k < elements.size(); ++k) {
    CertifiedReference reference;
    reference.elements = elements_of(elements[k], "references/elements");
    reference.first = one_line(first[k]);
    reference.second = one_line(second[k]);
    reference.agreement = agreements[k];
    if (k + 1 < elements.size())
      study.mesh_references.push_back(std::move(reference));
    else
      study.converged_reference = std::move(reference);
  }
  study.converged_mesh_error = file.number("converged_mesh_error");
  if (!std::isfinite(study.converged_mesh_error)) inconsistent("converged_mesh_error");
}

std::optional<MeshConvergence> read_mesh(const hdf5::Reader& file) {
  MeshConvergence mesh;
  const auto elements = file.integers("mesh/elements");
  if (elements.empty()) return {};
  for (const long n : elements) mesh.elements.push_back(elements_of(n, "mesh/elements"));
  mesh.distance = Columns(file, elements.size()).numbers("mesh/distance");
  mesh.change = Columns(file, elements.size() - 1).numbers("mesh/change");
  mesh.observed_order = file.number("mesh/observed_order");
  mesh.extrapolated_error = file.number("mesh/extrapolated_error");
  mesh.grid_convergence_index = file.number("mesh/grid_convergence_index");
  mesh.safety_factor = file.number("mesh/safety_factor");
  mesh.standard = one_line(file.text("mesh/standard"));
  if (!std::isfinite(mesh.observed_order + mesh.extrapolated_error + mesh.grid_convergence_index +
                     mesh.safety_factor))
    inconsistent("mesh");
  return mesh;
}

}  // namespace

std::string encode_study(const Study& study) {
  const WorkPrecision& result = study.result;
  hdf5::Writer file;
  write_format(format_name, study_file_version, file);
  write_source(study.loaded.source, file);
  write_provenance(result.provenance, file);
  file.integer("quick", result.quick ? 1 : 0);
  file.integer("fixed_elements", result.fixed_elements);
  file.number("end", result.end, "s");
  write_runs(result.runs, file);
  write_curves(result.curves, file);
  write_references(result, file);
  write_mesh(result.mesh.value_or(MeshConvergence{}), file);
  integers(file, "fronts/time", result.time_front, [](std::size_t k) { return k; });
  integers(file, "fronts/total", result.total_front, [](std::size_t k) { return k; });
  texts(file, given_path, result.given_curves, [](const GivenCurve& c) { return encode(c).dump(); });
  file.number("yardstick", result.yardstick, "s");
  return with_check_sum(file.bytes());
}

Study read_study(const std::string& path) {
  try {
    const std::string bytes = read_checked(path, "study file");
    const hdf5::Reader file(bytes);
    read_format(file, format_name, study_file_version, "study file");
    Study study;
    WorkPrecision& result = study.result;
    study.loaded = load_case(read_source(file), uses_of_study("work-precision"));
    result.provenance = read_provenance(file);
    result.title = study.loaded.spec.title;
    result.length = study.loaded.spec.cable.length;
    result.fastest_frequency = fastest_frequency_at_start(study.loaded.spec);
    result.quick = file.integer("quick") != 0;
    result.fixed_elements = elements_of(file.integer("fixed_elements"), "fixed_elements");
    result.end = file.number("end");
    if (!(result.end > 0) || !std::isfinite(result.end)) inconsistent("end");
    result.runs = read_runs(file);
    result.curves = read_curves(file, result.runs.size());
    read_references(file, result);
    result.mesh = read_mesh(file);
    if (file.has(given_path)) {  // those of earlier versions have none
      for (const std::string& curve : file.texts(given_path))
        result.given_curves.push_back(decoded<GivenCurve>(nlohmann::ordered_json::parse(curve)));
      for (const GivenCurve& curve : result.given_curves)
        for (const GivenPoint& point : curve.points)
          if (!(point.seconds > 0) || !std::isfinite(point.seconds)) inconsistent(given_path);
      result.yardstick = file.number("yardstick");
    }
    evaluate(result);
    return study;
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
