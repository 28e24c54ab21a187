#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace plumb {

/// All verbs of the command line.
std::vector<const CLI::App*> verbs_of(const CLI::App& app);

/// The manual page of the command line, plumb(1), in the man macros of roff: all that --help says.
std::string manual_page(const CLI::App& app);

/// What completes verbs, options and the names of installed cases in a shell: "bash", "zsh" or "fish".
/// Throws UsageError for another.
std::string completion(const CLI::App& app, std::string_view shell);

}  // namespace plumb
