#pragma once

#include <string>

namespace plumb {

/// Makes SIGINT, SIGTERM and SIGHUP ask the running work to stop instead of killing the program; a second one
/// kills it. Work that does not stop by itself within some 0.4 s, as within a library, is ended from outside:
/// what is Unfinished is removed, and the program exits with status 130. Writes to a closed pipe or beyond a
/// file size limit fail instead of killing it.
void catch_interrupts();

/// Throws Interrupted if a stop was asked for. Cheap enough for every step and every frame.
void stop_if_interrupted();

/// Whether a stop was asked for.
bool is_interrupted();

/// True for the first who asks, of the work that stops and what ends it from outside: it is said once.
bool may_say_interrupted();

/// Takes down a folder in the making, which `remove` clears where the program is ended from outside while its
/// work goes on, and strikes it out again. `remove` throws nothing.
void begin_unfinished(const std::string& path, void (*remove)(const std::string& path));
void end_unfinished(const std::string& path);

/// While one exists the program is not ended from outside: for the moments in which something new takes the
/// place of something old.
class Undivided {
 public:
  Undivided();
  ~Undivided();
  Undivided(const Undivided&) = delete;
  Undivided& operator=(const Undivided&) = delete;
};

}  // namespace plumb
