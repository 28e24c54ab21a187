#pragma once

#include <string>

#include "engine/case/case_source.h"

namespace plumb {

/// What points must have been made of to count for a study: the texts and overrides of its case, and the
/// program.
struct StudyIdentity {
  std::string of_case;    ///< a sum over the texts
  std::string case_name;  ///< the name of its file, for people
  std::string program =
      {};  ///< revision, compiler and flags, and what tells apart builds of a changed checkout

  std::string sum() const { return of_case + ' ' + program; }
};

/// That of a case and this program.
StudyIdentity study_identity(const CaseSource& source);

/// Where a point was computed.
struct Machine {
  std::string host;
  std::string processor;  ///< what times depend on
  std::string revision;   ///< of the program

  friend bool operator==(const Machine&, const Machine&) = default;
};

/// The one that this program runs on.
const Machine& this_machine();

}  // namespace plumb
