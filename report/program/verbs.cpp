#include "report/program/verbs.h"

#include <vector>

namespace plumb {

// In the order of the help.
#define PLUMB_VERBS(verb)                                                                         \
  verb(run) verb(solve) verb(render) verb(report) verb(study) verb(check) verb(diff) verb(export) \
      verb(doctor) verb(yardstick)

#define PLUMB_DECLARE(name) Verb name##_verb();
PLUMB_VERBS(PLUMB_DECLARE)
#undef PLUMB_DECLARE

std::span<const Verb> verbs() {
#define PLUMB_LIST(name) name##_verb(),
  static const std::vector<Verb> all{PLUMB_VERBS(PLUMB_LIST)};
#undef PLUMB_LIST
  return all;
}

}  // namespace plumb
