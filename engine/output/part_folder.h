#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "engine/output/beneath.h"

namespace plumb {

/// A folder `.NAME.part-XXXXXX` for what is to become `NAME`. A mark in it says that it is ours and a lock
/// that it is in use, so that what a killed program left behind can be told from the work of a running one
/// and from the folder of somebody else.
class PartFolder {
 public:
  /// Made in the folder `parent`. Throws std::system_error.
  PartFolder(const std::string& parent, const std::string& name);
  /// Removes it and what was written into it, unless it was let go. Where anything else came into it that
  /// stays, in `NAME.new` if that name is free.
  ~PartFolder();
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;

  const std::string& path() const { return path_; }
  /// Tells what of it is ours by the name below it.
  void own(std::function<bool(const std::string&)> is_ours) { is_ours_ = std::move(is_ours); }
  int descriptor() const { return folder_.get(); }

  /// Removes the mark: what is in it is told by a manifest from now on.
  void unmark();
  /// It is left as it is from now on: it has become what it was to be.
  void let_go();

 private:
  std::string path_;
  std::string visible_;  ///< what it is called if something of others is left in it
  std::function<bool(const std::string&)> is_ours_;
  Descriptor folder_;
};

/// Empties and removes such a folder as far as it is ours, as below. False if it is not gone then.
bool clear_leftover(
    const std::string& path,
    const std::function<bool(std::string_view)>& is_ours = [](std::string_view) { return false; });

/// Removes what programs that were killed left behind in `parent` on the way to `name`, and returns of how
/// many. A folder counts only if its mark or its manifest says that it is ours and no running program has it;
/// in it only what the manifest lists, or, with a mark, files that `is_ours` by their name below it, are
/// removed, and the folder if nothing else is in it.
int clear_leftovers(const std::string& parent, const std::string& name,
                    const std::function<bool(std::string_view)>& is_ours);

}  // namespace plumb
