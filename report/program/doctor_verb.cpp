#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "engine/integrate/method_info.h"
#include "engine/run/provenance.h"
#include "render/gl/environment.h"
#include "render/gl/gl_context.h"
#include "report/program/limits.h"
#include "report/program/print_json.h"
#include "report/program/verbs.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

std::string keys_of(const MethodInfo& method) {
  std::string keys = !method.takes_tolerances ? "step"
                     : method.takes_step      ? "step, or rtol and atol"
                                              : "rtol, atol";
  for (const MethodParameter& p : method.parameters)
    keys += p.words.empty()
                ? fmt::format("; {} in [{:g}, {:g}], default {:g}", p.name, p.minimum, p.maximum, p.fallback)
                : fmt::format("; {}: {}, default {}", p.name, fmt::join(p.words, " or "),
                              p.words[static_cast<std::size_t>(p.fallback)]);
  return keys;
}

Json method_json(const MethodInfo& method) {
  return {{"name", method.name},         {"order", method.order},         {"family", word(method.family)},
          {"implicit", method.implicit}, {"conserves", method.conserves}, {"use", method.use},
          {"summary", method.summary},   {"source", method.source},       {"keys", keys_of(method)}};
}

ExitStatus do_doctor(const Options& options, Console& console) {
  refuse_no_room_to_draw();
  const GlContext context;
  const GlInfo& gl = context.info();
  const Provenance provenance = provenance_now();
  console.line("Renderer");
  console.line(fmt::format("  {}: {}, OpenGL {}", gl.backend, gl.renderer, gl.version));
  console.line(fmt::format("  pictures up to {} pixels a side after supersampling, {} samples a pixel",
                           gl.max_size, gl.max_samples));
  const std::vector<EglDevice> devices = egl_devices();
  console.line(
      fmt::format("  PLUMB_GL=osmesa: {}", osmesa_is_there() ? "there" : "its library cannot be opened"));
  for (std::size_t k = 0; k < devices.size(); ++k)
    console.line(
        fmt::format("  PLUMB_GL=egl:{}: {}", k, devices[k].software ? "draws in software" : "a device"));
  if (devices.empty())
    console.line(fmt::format("  PLUMB_GL=egl: {}",
                             egl_is_there() ? "knows no device" : "its library cannot be opened"));
  console.line("Program");
  for (const auto& [name, value] : provenance) console.line(fmt::format("  {:<22}{}", name, value));
  console.line("Environment");
  for (const EnvironmentVariable& variable : environment_variables()) {
    const char* value = std::getenv(std::string(variable.name).c_str());
    console.line(fmt::format("  {:<27}{}{}", variable.name, variable.meaning,
                             value != nullptr ? fmt::format("; now {}", value) : ""));
  }
  console.line(
      "Methods: order, kind, what they conserve, when to use them, and the keys of [method] they take");
  for (const MethodInfo& method : method_infos()) {
    console.line(
        fmt::format("  {:<25}{:<8}{:<17}{}", method.name, method.order, word(method.family), method.summary));
    console.line(fmt::format("  {:<33}conserves {}; {}", "", method.conserves, method.use));
    console.line(console.faint(fmt::format("  {:<33}{}", "", keys_of(method))));
  }
  if (options.json) {
    Json json{{"backend", gl.backend},
              {"renderer", gl.renderer},
              {"opengl", gl.version},
              {"max_size", gl.max_size},
              {"max_samples", gl.max_samples}};
    json["methods"] = Json::array();
    for (const MethodInfo& method : method_infos()) json["methods"].push_back(method_json(method));
    for (const auto& [name, value] : provenance) json["provenance"][name] = value;
    print_json(json);
  }
  return ExitStatus::done;
}

}  // namespace

Verb doctor_verb() {
  return {.name = "doctor",
          .summary = "what was found on this machine: renderer, libraries, methods",
          .act = do_doctor,
          .uses_renderer = true};
}

}  // namespace plumb
