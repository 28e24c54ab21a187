#pragma once

namespace plumb {

/// Opens what is closed of standard input, output and error, so that no other file can come to be one of
/// them; what is written there fails as before.
void open_standard_files();

/// Throws OutputError where the process may have less stack than all work here counts on.
void refuse_short_stack();

}  // namespace plumb
