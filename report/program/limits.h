#pragma once

#include <string>
#include <vector>

#include "engine/study/estimate.h"
#include "report/program/console.h"
#include "report/program/options.h"

/// What a command may take, and what it is expected to.
namespace plumb {

/// A bound on a resource. `amount` itself is allowed.
struct Bound {
  Resource resource;
  double amount;               ///< bytes or s
  std::string source;          ///< what sets it: "the memory that is available", "--limit"
  bool address_space = false;  ///< counts what is mapped, used or not
  bool of_process = false;     ///< whoever started the program set it
  std::string place = {};      ///< of what is free on a disk: the folder that is to be written
};

/// Those of `--limit`: "memory=2GB,disk=10GB,time=1h" each. Throws UsageError.
std::vector<Bound> asked_bounds(const std::vector<std::string>& texts);

/// Those of this machine and process: memory that is available, of control groups, of RLIMIT_AS and
/// RLIMIT_DATA, and what is free on the file system that `folder` is or will be on.
std::vector<Bound> machine_bounds(const std::string& folder);

/// Throws InputError that names what is beyond its bound, both figures and the keys to change; `name` is that
/// of the case. WriteError where that is what is free on the disk, OutputError where a limit of the process
/// is too low for any case.
void refuse_beyond(const Estimate& estimate, const std::vector<Bound>& bounds, const std::string& name);

/// The estimate of a case, refused as above before any work on it. `folder` is the output folder. Work that
/// will take days is remarked on.
Estimate check_estimate(const Case& spec, const PlannedWork& work, const std::string& name,
                        const std::string& folder, const Options& options, Console& console);

/// Throws OutputError where less address space is left than drawing maps: the renderer does not survive that.
void refuse_no_room_to_draw();

/// What `plumb run` does with a case.
PlannedWork work_of_run(const Case& spec);

/// A line each for memory, disk and time, with the parts that take most.
std::vector<std::string> in_words(const Estimate& estimate);

/// What takes most memory of the work that was last estimated, with its keys; empty before.
const std::string& heaviest_part();

}  // namespace plumb
