#pragma once

#include <optional>
#include <string>

#include "engine/run/output_folder.h"
#include "engine/study/journal.h"
#include "engine/study/sensitivity/sensitivity.h"
#include "report/program/console.h"

/// The pieces of work on what the criteria of a run notice, that the verbs are made of.
namespace plumb {

/// Finds it where the case of the run asks for it, with a progress bar, and writes it into the folder.
std::optional<Sensitivity> find_sensitivity(const LoadedCase& loaded, Journal& journal, OutputFolder& folder,
                                            Console& console);

/// The same from what lies beside a run, which is written anew; nothing where there is none. Throws
/// InputError where it cannot be used.
std::optional<Sensitivity> sensitivity_beside(const std::string& run_path, const LoadedCase& loaded,
                                              OutputFolder& folder);

}  // namespace plumb
