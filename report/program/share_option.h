#pragma once

#include <cstddef>
#include <string>

#include "report/program/options.h"

namespace plumb {

/// One of several shares of some work, counted from 1.
struct Share {
  std::size_t number = 1;
  std::size_t of = 1;

  bool is_all() const { return of == 1; }
  /// Whether the piece with this place in the work, from 0, is in it, where pieces are dealt out in turn.
  bool has(std::size_t place) const { return place % of == number - 1; }
};

/// That of --share: "3/16". Throws UsageError where it is no share.
Share asked_share(const Options& options);

/// What a folder for a share is called after that for all: ".share-3-of-16"; nothing for all of the work.
std::string suffix_of(const Share& share);

}  // namespace plumb
