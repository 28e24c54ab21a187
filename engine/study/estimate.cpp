#include "engine/study/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "engine/integrate/method_roles.h"
#include "engine/model/straight_frequency.h"
#include "engine/read/case_sections.h"

namespace plumb {
namespace {

// What was measured of the program, rounded up.
constexpr double program_bytes = 20e6;
constexpr double renderer_bytes = 130e6;        // an OpenGL context in software and the fonts
constexpr double column_bytes = 6000;           // of a data set in an HDF5 file
constexpr double number_text_bytes = 20;        // of a number in a table of text
constexpr double report_bytes_an_output = 900;  // of results.json and the tables behind figures
constexpr double report_bytes = 2e6;
constexpr double held_a_report_byte = 3;

MethodCost cost_of(std::string_view method) {
  const MethodInfo* info = find_method(method);
  return info != nullptr ? info->cost : MethodCost{};
}

/// The finest mesh that is tried where it is left to the scene.
constexpr double finest_for_scene = 256;
/// Runs of a study at once.
constexpr double at_once = 2;

double state_bytes(double nodes) {
  return 2 * (48 * nodes + 40) + 100;
}

/// The numbers that sizes are made of.
struct Sizes {
  explicit Sizes(const Case& spec)
      : elements(spec.method.name == scene_method ? std::max<double>(finest_for_scene, spec.cable.elements)
                                                  : spec.cable.elements),
        outputs(spec.time.output_interval > 0 ? std::floor(spec.time.end / spec.time.output_interval) + 2
                                              : 2) {
    for (const ProbeSpec& probe : spec.probes) columns += is_vector(probe.quantity) ? 3 : 1;
    steps = steps_of(spec, spec.method, elements);
  }

  static double steps_of(const Case& spec, const MethodSpec& method, double elements) {
    if (method.step) return std::ceil(spec.time.end / *method.step);
    const MethodInfo* info = find_method(method.name);
    const double least = 100;
    if (info == nullptr || info->implicit) return least;
    // An explicit method takes no longer steps than it is stable with.
    constexpr double stable = 4;
    CableSpec cable = spec.cable;
    cable.elements = static_cast<int>(std::max(1.0, std::min(elements, 1e9)));
    return std::max(least, spec.time.end * straight_frequency(cable) / stable);
  }

  double nodes() const { return elements + 1; }
  double states() const { return outputs * state_bytes(nodes()); }

  double elements;
  double outputs;
  double columns = 1;  // the time
  double steps = 0;
};

class Estimating {
 public:
  Estimating(const Case& spec, const PlannedWork& work) : spec_(spec), work_(work), sizes_(spec) {}

  Estimate result() {
    add(Resource::memory, "", "the program", "", program_bytes);
    if (work_.solves || work_.writes_run || (work_.draws && work_.study == nullptr)) holding();
    if (work_.solves) solving();
    if (work_.writes_run || work_.writes_table) writing();
    if (work_.assesses) assessing();
    if (work_.quick_study)
      study("the quick study", work_precision_parts(work_precision_of(spec_).quick, run()));
    if (work_.study != nullptr) study("study", work_.study(spec_, run()));
    if (work_.draws) drawing();
    return std::move(result_);
  }

 private:
  void add(Resource resource, std::string stage, std::string what, std::string keys, double amount) {
    result_.parts.push_back({resource, std::move(stage), std::move(what), std::move(keys), amount});
  }

  void holding() {
    add(Resource::memory, "",
        fmt::format("states: {:.0f} outputs × {:.0f} nodes", sizes_.outputs, sizes_.nodes()),
        "cable.elements, time.output_interval, time.end", sizes_.states());
    add(Resource::memory, "",
        fmt::format("probes: {:.0f} outputs × {:.0f} columns", sizes_.outputs, sizes_.columns),
        "probe, time.output_interval, time.end", 12 * sizes_.outputs * sizes_.columns);
  }

  void solving() {
    constexpr const char* stage = "solving";
    add(Resource::memory, stage,
        fmt::format("{}: {:.0f} nodes × {:.0f} bytes", spec_.method.name, sizes_.nodes(),
                    cost_of(spec_.method.name).bytes),
        "cable.elements, method.name", sizes_.nodes() * cost_of(spec_.method.name).bytes);
    add(Resource::time, stage,
        fmt::format("{}: {}{:.3g} steps × {:.0f} elements", spec_.method.name,
                    spec_.method.step ? "" : "at least ", sizes_.steps, sizes_.elements),
        spec_.method.step ? "method.step, time.end, cable.elements" : "time.end, cable.elements",
        run_seconds());
  }

  double run_seconds() const {
    return sizes_.steps * sizes_.elements * seconds_an_element(spec_.method.name);
  }

  void writing() {
    constexpr const char* stage = "run file";
    const double table = number_text_bytes * sizes_.outputs * sizes_.columns;
    if (work_.writes_run) {
      const double file =
          sizes_.states() + 8 * sizes_.outputs * sizes_.columns + column_bytes * sizes_.columns;
      const std::string what = fmt::format("run.h5: {:.0f} outputs × {:.0f} nodes and {:.0f} columns",
                                           sizes_.outputs, sizes_.nodes(), sizes_.columns);
      constexpr const char* keys = "cable.elements, time.output_interval, time.end, probe";
      add(Resource::memory, stage, what, keys, 2.5 * file);
      add(Resource::disk, stage, what, keys, file);
    }
    const std::string what =
        fmt::format("probes.csv: {:.0f} outputs × {:.0f} columns", sizes_.outputs, sizes_.columns);
    constexpr const char* keys = "probe, time.output_interval, time.end";
    // The text grows twofold at a time.
    add(Resource::memory, work_.writes_run ? "table" : stage, what, keys, 2.5 * table);
    add(Resource::disk, stage, what, keys, table);
  }

  void assessing() {
    if (spec_.uncertainty) {
      const double samples = spec_.uncertainty->samples;
      const double finest = 4 * sizes_.elements;
      const double meshes = spec_.uncertainty->numerical ? 4 : 0;
      add(Resource::memory, "uncertainty",
          fmt::format("runs on up to {:.0f} elements, {:.0f} at once", finest, at_once),
          "cable.elements, time.output_interval",
          (meshes > 0 ? at_once : 0) * sizes_.outputs * state_bytes(finest + 1) + at_once * sizes_.states());
      add(Resource::memory, "uncertainty",
          fmt::format("{:.0f} samples × {:.0f} columns", samples, sizes_.columns), "uncertainty.samples",
          (samples + meshes) * (case_bytes() + reference_bytes()));
      const double seconds = exact_run_seconds(sizes_.elements);
      add(Resource::time, "uncertainty", fmt::format("{:.0f} samples", samples), "uncertainty.samples",
          samples * seconds + (meshes > 0 ? 2 * exact_run_seconds(finest) : 0));
    }
    if (spec_.error_budget) {
      const double runs = static_cast<double>(spec_.error_budget->items.size()) + 2;
      add(Resource::memory, "error budget", fmt::format("{:.0f} runs", runs), "error_budget.item",
          at_once * sizes_.states() + runs * reference_bytes());
      add(Resource::time, "error budget", fmt::format("{:.0f} runs", runs), "error_budget.item",
          runs * run_seconds());
    }
    if (spec_.sensitivity) study("sensitivity", sensitivity_parts(spec_, run()));
  }

  /// Of a run whose time integration has no part in its error.
  double exact_run_seconds(double elements) const {
    const MethodSpec exact = plain_method(embedded_explicit());
    return Sizes::steps_of(spec_, exact, elements) * elements * seconds_an_element(classical_explicit().name);
  }

  static double case_bytes() { return 20e3; }
  /// What is taken down of a run at the times of the references, of which a file has at most this many.
  double reference_bytes() const {
    constexpr double times = 1000;
    return static_cast<double>(spec_.references.size()) * times * 8 * sizes_.columns;
  }

  void study(const std::string& stage, std::vector<EstimatedPart> parts) {
    for (EstimatedPart& part : parts) {
      part.stage = stage;
      result_.parts.push_back(std::move(part));
    }
  }

  RunSize run() const { return {sizes_.elements, sizes_.outputs, run_seconds()}; }

  void drawing() {
    const SceneSpec& scene = spec_.scene;
    constexpr const char* stage = "pictures";
    add(Resource::memory, stage, "the renderer", "", renderer_bytes);
    result_.drawing_address_space = renderer_address_space;
    const double pixels = 1.0 * scene.size[0] * scene.size[1];
    const double all_frames = std::floor(spec_.time.end * scene.frame_rate) + 1;
    const double frames = work_.frames >= 0 ? std::min(work_.frames, all_frames) : all_frames;
    const double samples = pixels * scene.supersampling * scene.supersampling;
    constexpr double most_at_once = 1e8, tile_side = 4096;
    const double side = tile_side / scene.supersampling;
    const double at_a_time = samples > most_at_once ? side * side : pixels;
    constexpr double fewest_samples = 4;
    const double per_pixel =
        8 + 8 * std::max<double>(fewest_samples, scene.supersampling * scene.supersampling);
    constexpr const char* size_keys = "scene.size, scene.supersampling";
    add(Resource::memory, stage,
        fmt::format("a frame: {} × {} pixels, {} × {} samples each", scene.size[0], scene.size[1],
                    scene.supersampling, scene.supersampling),
        size_keys, at_a_time * per_pixel + 4 * pixels * std::min(frames, 3.0));
    const double file = picture_file_bytes(pixels);
    const std::string what =
        fmt::format("frames: {:.0f} × {} × {} pixels", frames, scene.size[0], scene.size[1]);
    constexpr const char* keys = "scene.size, scene.frame_rate, time.end";
    add(Resource::memory, stage, what, keys, 2 * frames * file);
    add(Resource::disk, stage, what, keys, 2 * frames * file);
    constexpr double nanoseconds_a_sample = 40, nanoseconds_a_pixel = 150;
    add(Resource::time, stage, what, keys,
        1e-9 * frames * (samples * nanoseconds_a_sample + pixels * nanoseconds_a_pixel));

    constexpr double page_width = 512, page_rate = 12.5;
    const double shrunk = std::min(1.0, page_width / scene.size[0]);
    const double page_frames = std::floor(spec_.time.end * std::min(scene.frame_rate, page_rate)) + 1;
    const double animation = page_frames * picture_file_bytes(pixels * shrunk * shrunk);
    const double text = report_bytes + report_bytes_an_output * sizes_.outputs;
    add(Resource::memory, "report",
        fmt::format("the page: {:.0f} frames, {:.0f} outputs", page_frames, sizes_.outputs),
        "scene.frame_rate, time.output_interval, time.end", 5 * animation + held_a_report_byte * text);
    add(Resource::disk, "report",
        fmt::format("the report: {:.0f} frames, {:.0f} outputs", page_frames, sizes_.outputs),
        "scene.frame_rate, time.output_interval, time.end", 2.4 * animation + text);
  }

  /// Of a PNG file of a scene, whose detail grows slower than its area.
  static double picture_file_bytes(double pixels) { return 12.5 * std::pow(pixels, 0.7); }

  const Case& spec_;
  const PlannedWork& work_;
  Sizes sizes_;
  Estimate result_;
};

}  // namespace

double RunSize::states(double on_elements) const {
  return outputs * state_bytes(on_elements + 1);
}

std::vector<EstimatedPart> work_precision_parts(const StudyExtent& extent, const RunSize& run) {
  double finest = run.elements;
  for (const int elements : extent.elements) finest = std::max<double>(finest, elements);
  const double runs =
      static_cast<double>(extent.methods.size() * (extent.elements.size() + 1)) * extent.points;
  // A mesh twice as fine stands for the continuum, and two methods are held against one another on it.
  return {{Resource::memory, "",
           fmt::format("references: 4 × {:.0f} outputs × {:.0f} nodes", run.outputs, 2 * finest + 1),
           "study.work_precision.elements, time.output_interval", 4 * run.states(2 * finest)},
          {Resource::time, "", fmt::format("at most {:.0f} runs × {:g} s", runs, extent.time_limit),
           "study.work_precision: elements, methods, points, time_limit", runs * extent.time_limit}};
}

std::vector<EstimatedPart> sensitivity_parts(const Case& spec, const RunSize& run) {
  const SensitivitySpec asked = spec.sensitivity ? *spec.sensitivity : default_sensitivity(spec);
  double criteria = 0;
  for (const ReferenceUse& use : spec.references) criteria += static_cast<double>(use.compare.size());
  // Of one number in one direction: the steps to a bracket, and halvings of it, which criteria share in part.
  constexpr double bracketing = 6, halvings = 4;
  const double runs = 2.0 * static_cast<double>(asked.numbers.size()) * (bracketing + halvings * criteria) +
                      static_cast<double>(asked.blunders.size());
  return {{Resource::memory, "", fmt::format("{:.0f} runs at once", at_once), "cable.elements",
           2 * at_once * run.states(2 * run.elements)},
          {Resource::memory, "", fmt::format("{:.0f} runs in the journal", runs), "sensitivity.numbers",
           runs * (200 + 50 * criteria)},
          {Resource::time, "", fmt::format("some {:.0f} runs", runs),
           "sensitivity: numbers, blunders, largest, time_limit",
           runs * std::min(run.seconds, asked.time_limit)}};
}

std::string_view word(Resource resource) {
  switch (resource) {
    case Resource::memory:
      return "memory";
    case Resource::disk:
      return "disk";
    case Resource::time:
      return "time";
  }
  return "memory";
}

double bytes_a_node(std::string_view method) {
  return cost_of(method).bytes;
}

double seconds_an_element(std::string_view method) {
  return 1e-9 * cost_of(method).nanoseconds;
}

std::vector<EstimatedPart> Estimate::parts_of(Resource resource) const {
  std::vector<EstimatedPart> chosen;
  std::string fullest;
  if (resource == Resource::memory) {
    std::map<std::string, double> stages;
    for (const EstimatedPart& part : parts)
      if (part.resource == resource) stages[part.stage] += part.stage.empty() ? 0 : part.amount;
    double most = -1;
    for (const auto& [stage, amount] : stages) {
      // A sum that is not a number is more than any.
      if (amount <= most) continue;
      most = amount;
      fullest = stage;
    }
  }
  for (const EstimatedPart& part : parts)
    if (part.resource == resource &&
        (resource != Resource::memory || part.stage.empty() || part.stage == fullest))
      chosen.push_back(part);
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const EstimatedPart& a, const EstimatedPart& b) { return a.amount > b.amount; });
  return chosen;
}

double Estimate::total(Resource resource) const {
  double sum = 0;
  for (const EstimatedPart& part : parts_of(resource)) sum += part.amount;
  return sum;
}

Estimate estimate(const Case& spec, const PlannedWork& work) {
  return Estimating(spec, work).result();
}

std::string amount_in_words(Resource resource, double amount) {
  struct Step {
    double size;
    const char* unit;
  };
  static constexpr std::array bytes{Step{1e15, "PB"}, Step{1e12, "TB"}, Step{1e9, "GB"}, Step{1e6, "MB"},
                                    Step{1e3, "kB"}};
  static constexpr std::array seconds{Step{365.25 * 86400, "years"}, Step{86400, "days"}, Step{3600, "h"},
                                      Step{60, "min"}};
  const bool is_time = resource == Resource::time;
  const std::span<const Step> steps = is_time ? std::span<const Step>(seconds) : std::span<const Step>(bytes);
  for (const Step& step : steps)
    if (amount >= step.size) return fmt::format("{:.3g} {}", amount / step.size, step.unit);
  return fmt::format("{:.3g} {}", amount, is_time ? "s" : "bytes");
}

}  // namespace plumb
