#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/base/interrupt.h"
#include "engine/base/job.h"
#include "engine/base/message.h"
#include "engine/base/nearest.h"
#include "engine/study/job_workers.h"
#include "render/gl/environment.h"
#include "report/base/stages.h"
#include "report/exports/export_formats.h"
#include "report/program/command_line_texts.h"
#include "report/program/installed_cases.h"
#include "report/program/limits.h"
#include "report/program/results_schema.h"
#include "report/program/share_option.h"
#include "report/program/study_kinds.h"
#include "report/program/surroundings.h"
#include "report/program/verbs.h"

namespace plumb {
namespace {

constexpr const char* exit_statuses =
    "Exit status: 0 done and every criterion met; 1 a criterion not met; 2 wrong usage; 3 invalid case, "
    "reference or\n"
    "run file; 4 the solver failed; 5 drawing or writing failed; 130 interrupted.";

/// Where the program is one of several processes of a job.
Job* job_here = nullptr;

bool serves() {
  return job_here != nullptr && job_here->rank() > 0;
}

/// Says the one line. Whatever goes wrong after a stop was asked for, that is why.
int fail(const std::string& error, ExitStatus status) {
  if (is_interrupted()) status = ExitStatus::interrupted;
  const std::string message = status == ExitStatus::interrupted ? Interrupted().what() : error;
  if (serves()) {
    fail_in_job(*job_here, message);  // rank 0 says it, and its status is that of the job
    return static_cast<int>(ExitStatus::done);
  }
  const Undivided undivided;
  if (may_say_interrupted() || status != ExitStatus::interrupted)
    std::fputs(("plumb: " + one_line(message) + "\n").c_str(), stderr);
  return static_cast<int>(status);
}

/// Says what there was too much of.
int fail_for_memory() {
  const std::string_view stage = Stages::current();
  const auto status = stage == solving_stage ? ExitStatus::solver_failed : ExitStatus::output_failed;
  try {
    return fail(fmt::format("out of memory{}{}{}{}", stage.empty() ? "" : " while ", stage,
                            heaviest_part().empty() ? "" : "; most is for ", heaviest_part()),
                status);
  } catch (const std::exception&) {
    // Not even for the words.
    constexpr std::string_view line = "plumb: out of memory\n";
    if (::write(STDERR_FILENO, line.data(), line.size()) < 0) return static_cast<int>(status);
    return static_cast<int>(status);
  }
}

/// Of the largest number of a column, of the pixels in a window, of the levels of a channel: with more a
/// column could be turned round unseen, or a picture be another.
constexpr double most_share = 0.5;
constexpr int most_levels = 127;

/// Finite numbers from `low` to `high`; words that strtod takes for numbers are none.
CLI::Validator number_between(double low, double high) {
  return {[low, high](const std::string& text) -> std::string {
            double number = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
            if (error == std::errc() && end == text.data() + text.size() && number >= low && number <= high)
              return {};
            return fmt::format("{}: must be a number from {} to {}", text, low, high);
          },
          ""};
}

/// An option that was given and says nothing was meant to say something: an unset variable of a script.
std::string refuse_empty(const std::string& text) {
  return text.empty() ? "must not be empty" : "";
}

/// An error that names an option by its long name, with the short one where that was typed.
std::string as_typed(std::string what, int count, const char* const* arguments) {
  constexpr std::string_view long_name = "--output", short_name = "-o";
  const std::vector<std::string_view> typed(arguments + 1, arguments + count);
  const auto uses = [&](std::string_view name) {
    return std::any_of(typed.begin(), typed.end(),
                       [&](std::string_view word) { return word.starts_with(name); });
  };
  if (const std::size_t at = what.find(long_name);
      at != std::string::npos && uses(short_name) && !uses(long_name))
    what.replace(at, long_name.size(), short_name);
  return what;
}

/// A word that is no verb where a verb should be is refused with the nearest verb.
void refuse_unknown_verb(int count, const char* const* arguments) {
  if (count < 2 || arguments[1][0] == '-') return;
  const std::string word = arguments[1];
  std::vector<std::string> names;
  for (const Verb& verb : verbs()) names.push_back(verb.name);
  if (std::find(names.begin(), names.end(), word) == names.end())
    throw UsageError(fmt::format("'{}' is no verb{}", word, suggestion(word, names)));
}

void add_drawing(CLI::App& command, Options& options) {
  command.add_option("--frames", options.frames, "frame numbers from 0: 10:20 (both drawn), 10: or 10")
      ->type_name("A:B");
  command
      .add_option("--mode", options.mode, "the mode in which the frames of a run of modes vibrate, from 1")
      ->type_name("N");
  command.add_option("--size", options.size, "pixels, instead of scene.size: 3840x2160")->type_name("WxH");
  command.add_option("--camera", options.camera, "instead of scene.camera, as the case file has it: top")
      ->type_name("NAME");
  command
      .add_option("--video", options.video, "write the frames to FILE.mp4 or FILE.webm as well, with ffmpeg")
      ->type_name("FILE");
  const auto add_runs = [&](const char* name, std::vector<std::string>& runs, const char* help) {
    command.add_option(name, runs, help)
        ->type_name("RUN")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  };
  add_runs("--over", options.over, "show another run in the frames, over this one (repeatable)");
  add_runs("--beside", options.beside, "show another run in the frames, to the right (repeatable)");
  command.add_flag(
      "--points", options.points,
      "show the points of the references in the frames, where enough of their components is known");
}

void add_comparison(CLI::App& command, Options& options) {
  command.add_option("B", options.other, "what is held against it")->required()->type_name("");
  command
      .add_option(
          "--channel", options.channel,
          "levels by which a channel of a pixel may differ; default 8, but 0 for pictures of the same "
          "renderer unless this or --density is given")
      ->type_name("N")
      ->check(CLI::Range(0, most_levels));
  command
      .add_option("--density", options.density,
                  "share of the pixels in any window of 16 x 16 that may differ by more; default 0.01, or 0")
      ->type_name("SHARE")
      ->check(number_between(0, most_share));
  command
      .add_option("--numbers", options.numbers,
                  "difference of numbers, relative to the largest of their column; default 1e-9")
      ->type_name("SHARE")
      ->check(number_between(0, most_share));
  command.add_option("--html", options.html, "write a page with the pictures that differ to FILE")
      ->type_name("FILE");
  command.add_flag("--accept", options.accept, "make B the baseline: put it in the place of A");
}

void add_shares(const Verb& verb, CLI::App& command, Options& options) {
  CLI::Option* share =
      command.add_option("--share", options.share, "one share of the work, as of many machines: 3/16")
          ->type_name("K/N");
  if (!verb.takes_parts) return;
  CLI::Option* only = command
                          .add_option("--only", options.only,
                                      "compute only the points that FILE, of --merge, lists as missing")
                          ->type_name("FILE");
  command
      .add_option("--merge", options.merge,
                  "compute nothing: the report from the folders of shares, or a list of what is missing")
      ->type_name("DIR...")
      ->expected(1, 1'000'000)
      ->excludes(share)
      ->excludes(only);
}

void add_input(const Verb& verb, CLI::App& command, Options& options) {
  const std::string meaning =
      verb.exports           ? "run.h5, or its folder"
      : verb.input != "CASE" ? "run.h5, study.h5 or study.json, or its folder"
      : verb.takes_many ? "case file (TOML), folder of such, or the name of one that came with the program"
                        : "case file (TOML)";
  if (!verb.takes_many) {
    command.add_option(verb.input, options.input, meaning)->required()->type_name("");
    return;
  }
  command
      .add_option(verb.input, options.inputs,
                  meaning + (verb.exports ? "; several stand in one file"
                                          : "; several make an index over their reports"))
      ->required(!verb.takes_document)
      ->type_name("");
}

void add_verb(const Verb& verb, CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand(verb.name, verb.summary);
  command->footer(exit_statuses);
  if (!verb.input.empty()) add_input(verb, *command, options);
  if (verb.takes_document)
    command
        ->add_option(
            "--from", options.from,
            "the page again from a results.json and the pictures beside it: nothing is solved, drawn "
            "or compared")
        ->type_name("FILE");
  if (verb.takes_pdf)
    command->add_flag("--pdf", options.pdf,
                      "print the page as report.pdf as well, with Chromium where that is installed");
  if (verb.takes_baseline) {
    CLI::Option* baseline =
        command
            ->add_option(
                "--baseline", options.baseline,
                "an earlier output folder, or its results.json: what moved since is a criterion not met")
            ->type_name("DIR");
    command
        ->add_option("--numbers", options.numbers,
                     "what a column may move by since the baseline, relative to its largest; default 1e-9")
        ->type_name("SHARE")
        ->check(number_between(0, most_share))
        ->needs(baseline);
  }
  if (verb.takes_history)
    command
        ->add_option(
            "--history", options.history,
            "add a line of JSON a run to FILE, and show what became of errors and time over its lines")
        ->type_name("FILE");
  if (verb.takes_kind)
    command
        ->add_option("KIND", options.kind,
                     fmt::format("what to vary: {}; default: the first that the case has a table for",
                                 fmt::join(study_kind_names(), ", ")))
        ->type_name("");
  if (verb.takes_share) add_shares(verb, *command, options);
  if (verb.takes_overrides)
    command
        ->add_option("--set", options.overrides,
                     verb.draws ? "set a key of [scene], such as scene.theme=dark (repeatable)"
                                : "set a key of the case, such as cable.elements=8 (repeatable)")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  if (verb.takes_output)
    command
        ->add_option(
            "-o,--output", options.output,
            verb.exports
                ? "the file, or of a format of many files the folder; default: in the folder of the run"
            : verb.input == "CASE"
                ? verb.takes_many
                      ? "output folder; default: output/ and the name of the case file or folder; for "
                        "several "
                        "files output"
                      : "output folder; default: output/ and the name of the case file (and of the study)"
            : verb.draws ? "output folder, or - for the frames alone, as PNG files one after another "
                           "on standard output; default: that of the run"
                         : "output folder; default: that of the run")
        ->type_name(verb.exports ? "FILE" : "DIR");
  if (verb.exports) {
    std::string formats;
    for (const ExportFormat& format : export_formats())
      formats += fmt::format("{}{}: {}", formats.empty() ? "" : "; ", format.name, format.summary);
    command->add_option("--to", options.to, formats)->required()->type_name("FORMAT");
  }
  if (verb.takes_csv)
    command
        ->add_option("--csv", options.csv,
                     "write the probes to FILE (- for standard output); then a folder only with -o")
        ->type_name("FILE");
  if (verb.is_estimated)
    command
        ->add_option("--limit", options.limits,
                     "refuse work beyond it before any is done: memory=2GB,disk=10GB,time=1h")
        ->type_name("LIMITS")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  if (verb.chooses) {
    command->add_flag("--economy", options.economy,
                      "model, mesh, method and step no better than the picture needs (scene.tolerance)");
    command->add_flag("--explain", options.explain,
                      "with --economy or method.name=scene: what was tried, what it costs, why it was left");
  }
  if (verb.draws) add_drawing(*command, options);
  if (verb.compares) add_comparison(*command, options);
  command->add_flag("--json", options.json, "the result as JSON on standard output, talk on standard error");
  command->add_flag("--quiet", options.quiet, "say nothing but errors");
  for (CLI::Option* option : command->get_options())
    if (option->get_items_expected_max() > 0 && !option->check_lname("set"))
      option->check(CLI::Validator(refuse_empty, ""));
}

/// What packages and shells ask the program for: its texts end it as --version does.
void add_texts(CLI::App& app) {
  const auto say = [&](const std::string& text) { throw CLI::CallForVersion(text, 0); };
  app.add_flag_callback(
      "--cases",
      [=] {
        std::string names;
        for (const std::string& name : installed_cases()) names += (names.empty() ? "" : "\n") + name;
        say(names);
      },
      "the names of the cases that came with the program");
  app.add_flag_callback(
      "--manual", [=, &app] { say(manual_page(app)); }, "the manual page, in roff");
  app.add_flag_callback(
      "--schema", [=] { say(results_schema()); }, "the JSON Schema of results.json");
  app.add_option_function<std::string>(
         "--completion", [=, &app](const std::string& shell) { say(completion(app, shell)); },
         "what completes command lines in a shell: bash, zsh or fish")
      ->type_name("SHELL");
}

/// Options that go with no other, or not with this verb.
void check_together(const Verb& verb, const Options& options) {
  if (options.json && options.csv == "-")
    throw UsageError("--json and --csv - cannot both have standard output");
  if (options.output == "-" && !verb.draws)
    throw UsageError(fmt::format("-o -: plumb {} writes a folder, and only plumb render streams", verb.name));
  if (!options.from.empty() && !options.inputs.empty()) throw UsageError("--from takes the place of RUN");
  if (!options.from.empty() && !options.history.empty())
    throw UsageError("--history goes with RUN: --from shows what a results.json says, no new run");
  asked_bounds(options.limits);
  asked_share(options);
}

/// Refuses what is wrong in the environment where it matters, and remarks on it elsewhere.
void heed_environment(const Verb& verb, Console& console) {
  for (const std::string& remark : mistyped_variables()) console.remark(remark);
  try {
    check_environment();
  } catch (const UsageError& error) {
    if (verb.uses_renderer) throw;
    console.remark(fmt::format("{} (plumb {} does not use it)", error.what(), verb.name));
  }
}

}  // namespace

Command parse_command(int count, const char* const* arguments) {
  refuse_unknown_verb(count, arguments);
  CLI::App app{
      "Plumb integrates a flexible cable pendulum, draws it without a display, and reports how far it can be "
      "trusted.",
      "plumb"};
  app.footer(exit_statuses);
  if (count < 2) throw UsageError("a verb is missing (see plumb --help)");
  app.require_subcommand(1);
  app.set_version_flag("--version", "Plumb " PLUMB_VERSION);
  add_texts(app);
  Command command;
  Options& options = command.options;
  for (const Verb& verb : verbs()) add_verb(verb, app, options);
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // help and version are "errors" too
      std::ostringstream said;
      app.exit(error, said, said);
      command.said = said.str();
      return command;
    }
    throw UsageError(as_typed(error.what(), count, arguments) + " (see plumb --help)");
  }
  if (!options.inputs.empty()) options.input = options.inputs.front();
  const std::string chosen = app.get_subcommands().front()->get_name();
  command.verb =
      &*std::find_if(verbs().begin(), verbs().end(), [&](const Verb& verb) { return verb.name == chosen; });
  check_together(*command.verb, options);
  return command;
}

namespace {

int parse_and_act(int count, const char* const* arguments) {
  Command command = parse_command(count, arguments);
  if (command.verb == nullptr) {
    std::fputs(command.said.c_str(), stdout);
    return static_cast<int>(ExitStatus::done);
  }
  Options& options = command.options;
  if (command.verb->input == "CASE" && !command.verb->takes_many) options.input = case_named(options.input);
  if (serves() && !command.verb->works_in_job) return static_cast<int>(ExitStatus::done);
  Console console(options.json || options.csv == "-" || options.output == "-", options.quiet || serves());
  heed_environment(*command.verb, console);
  return static_cast<int>(command.verb->act(options, console));
}

}  // namespace

namespace {

int act_and_tell(int count, const char* const* arguments) {
  try {
    open_standard_files();
    refuse_short_stack();
    catch_interrupts();
    job_here = job_of_process();
    if (serves()) may_say_interrupted();  // rank 0 says it for all
    const int status = parse_and_act(count, arguments);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw WriteError("standard output", "not all that was said got there");
    return status;
  } catch (const UsageError& error) {
    return fail(error.what(), ExitStatus::wrong_usage);
  } catch (const InputError& error) {
    return fail(error.what(), ExitStatus::invalid_input);
  } catch (const OutputError& error) {
    return fail(error.what(), ExitStatus::output_failed);
  } catch (const Interrupted& error) {
    return fail(error.what(), ExitStatus::interrupted);
  } catch (const std::bad_alloc&) {
    return fail_for_memory();
  } catch (const std::length_error&) {
    return fail_for_memory();
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string path = error.path1().string();
    return fail(fmt::format("{}: {}", path.empty() ? "a file" : path, reason(error)),
                ExitStatus::output_failed);
  } catch (const std::exception& error) {
    return fail(fmt::format("{}: cannot go on: {}", count > 1 ? arguments[1] : "plumb", reason(error)),
                ExitStatus::output_failed);
  }
}

}  // namespace

int program(int count, const char* const* arguments) {
  const int status = act_and_tell(count, arguments);
  if (job_here != nullptr && !serves()) end_job(*job_here);
  return status;
}

}  // namespace plumb
