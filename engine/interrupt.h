#pragma once

namespace plumb {

/// Makes SIGINT, SIGTERM and SIGHUP ask the running work to stop instead of killing the program; a second one
/// kills it. Writes to a closed pipe or beyond a file size limit fail instead of killing it.
void catch_interrupts();

/// Throws Interrupted if a stop was asked for. Cheap enough for every step and every frame.
void stop_if_interrupted();

}  // namespace plumb
