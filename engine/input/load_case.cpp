#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/errors.h"
#include "engine/input/case_sections.h"
#include "engine/input/case_source.h"
#include "engine/input/method_keys.h"
#include "engine/input/model_keys.h"
#include "engine/input/override.h"
#include "engine/input/parameters.h"
#include "engine/input/table_reader.h"
#include "engine/integrate/method_info.h"

namespace plumb {
namespace {

constexpr std::size_t longest_title = 500;

/// What is made of [study]: everything, or nothing for a case that is itself a part of a study.
enum class Studies { read, ignored };

LoadedCase read_case(const NamedText& file, const std::vector<std::string>& overrides,
                     const ReferenceText& text_of, Studies studies);

void read_studies(TableReader study, const NamedText& file, const std::vector<std::string>& overrides,
                  const ReferenceText& text_of, Case& spec) {
  const bool has_work_precision = study.has("work_precision");
  const bool has_stability = study.has("stability");
  const bool has_sweep = study.has("sweep");
  const bool has_economy = study.has("economy");
  const std::vector<TableReader> variants = study.tables("variant");
  study.finish();
  if (has_work_precision)
    spec.work_precision = read_work_precision(study.table("work_precision"), spec.cable, spec.time);
  if (has_stability)
    spec.stability = read_stability(study.table("stability"), spec.parameters, spec.cable, spec.time);
  if (has_sweep) spec.sweep = read_sweep(study.table("sweep"), spec.cable);
  if (has_economy) spec.economy = read_economy(study.table("economy"), spec.scene);
  spec.variants = read_variants(variants, [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = overrides;
    all.insert(all.end(), more.begin(), more.end());
    return read_case(file, all, text_of, Studies::ignored).spec;
  });
}

LoadedCase read_case(const NamedText& file, const std::vector<std::string>& overrides,
                     const ReferenceText& text_of, Studies studies) {
  const TomlValue written = parse_toml(file);
  TomlValue merged = written;
  for (const std::string& text : overrides) apply_override(merged, text);

  LoadedCase loaded;
  loaded.remarks = drop_overruled_keys(written, merged);
  for (std::string& remark : drop_keys_of_other_models(merged)) loaded.remarks.push_back(std::move(remark));
  const Parameters parameters(merged.find("parameters"));
  TableReader root(merged, "", &parameters);
  root.has("parameters");

  // All tables are asked for before any is read: an unknown one is likely the reason why another is missing.
  Case& spec = loaded.spec;
  spec.title = root.text("title", "a title");
  if (spec.title.size() > longest_title)
    root.refuse_value("title", fmt::format("must be at most {} bytes long", longest_title));
  const TableReader cable = root.required_table("cable", "a table [cable]"), start = root.table("start");
  const TableReader supports = root.table("supports"), loads = root.table("loads");
  const TableReader method = root.required_table("method", "a table [method]"),
                    time = root.required_table("time", "a table [time]");
  const std::vector<TableReader> probes = root.tables("probe"), references = root.tables("reference");
  const std::vector<TableReader> figures = root.tables("figure");
  const TableReader scene = root.table("scene");
  const TableReader study = root.table("study");
  root.finish();

  spec.parameters = parameters.values();
  spec.cable = read_cable(cable);
  spec.start = read_start(start);
  spec.supports = read_supports(supports, spec.cable.model);
  spec.loads = read_loads(loads);
  spec.time = read_time(time);
  spec.method = read_method(method, spec.time);
  spec.probes = read_probes(probes);
  if (spec.cable.model == CableModel::rigid) check_rigid(spec, {start, method, probes});
  if (const MethodInfo* info = find_method(spec.method.name); info != nullptr && !info->dynamic) {
    const std::string still = fmt::format("must be 0 for {}, which starts at rest", spec.method.name);
    if (!spec.start.angular_velocity.isZero(0)) start.refuse_value("angular_velocity", still);
    if (spec.start.axial_speed != 0) start.refuse_value("axial_speed", still);
  }
  ReferencesRead read = read_references(references, file.name, text_of, spec.probes, spec.time);
  spec.references = std::move(read.uses);
  spec.figures = read_figures(figures, spec.probes, spec.references);
  spec.scene = read_scene(scene, spec.time);
  if (studies == Studies::read) read_studies(study, file, overrides, text_of, spec);

  loaded.references = std::move(read.references);
  loaded.source = {file, overrides, std::move(read.texts)};
  loaded.remarks.insert(loaded.remarks.end(), read.remarks.begin(), read.remarks.end());
  for (const std::string& name : parameters.unused()) {
    loaded.remarks.push_back(fmt::format("parameters.{} is not used", name));
  }
  return loaded;
}

/// Gives the texts of references that a source holds, which must outlive it.
ReferenceText texts_of(const CaseSource& source) {
  return [&](const std::string& name) {
    const auto found = std::find_if(source.references.begin(), source.references.end(),
                                    [&](const NamedText& reference) { return reference.name == name; });
    return found != source.references.end() ? FileText{found->text, ""}
                                            : FileText{"", "its text is not among those of the case"};
  };
}

}  // namespace

LoadedCase load_case(const std::string& path, const std::vector<std::string>& overrides) {
  const std::string text = read_whole_file(path);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return read_case(
      {path, text}, overrides,
      [&](const std::string& name) { return read_file_text((folder / name).string()); }, Studies::read);
}

LoadedCase load_case(const CaseSource& source) {
  return read_case(source.file, source.overrides, texts_of(source), Studies::read);
}

LoadedCase load_variant(const CaseSource& source, const VariantSpec& variant) {
  std::vector<std::string> overrides = source.overrides;
  overrides.insert(overrides.end(), variant.overrides.begin(), variant.overrides.end());
  return read_case(source.file, overrides, texts_of(source), Studies::ignored);
}

}  // namespace plumb
