/* Loaded before the C library (LD_PRELOAD): lets one call of a program that touches a file fail.

   PLUMB_FAULT_UNDER  only calls for files below this folder count
   PLUMB_FAULT_AT     the number of the call that fails, from 1
   PLUMB_FAULT_ERROR  the error number that it fails with; 0: the program is killed instead
   PLUMB_FAULT_ON     1: all later calls that need room on the disk fail as well
   PLUMB_FAULT_THREAD the number of the thread that cannot be started, from 1
   PLUMB_FAULT_LOG    the failed call is written to the end of this file */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

static int calls, failing;

static void note(const char* call, const char* path) {
  const char* log = getenv("PLUMB_FAULT_LOG");
  if (log == NULL) return;
  char line[2 * PATH_MAX];
  const int length = snprintf(line, sizeof line, "%s %s\n", call, path);
  const long file = syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND, 0600);
  if (file < 0) return;
  syscall(SYS_write, file, line, length);
  syscall(SYS_close, file);
}

/* Whether this call is to fail; errno is set then. */
static int fails_at(const char* call, const char* path, int needs_room) {
  const char *under = getenv("PLUMB_FAULT_UNDER"), *at = getenv("PLUMB_FAULT_AT"),
             *error = getenv("PLUMB_FAULT_ERROR"), *on = getenv("PLUMB_FAULT_ON");
  if (under == NULL || at == NULL || error == NULL || strncmp(path, under, strlen(under)) != 0) return 0;
  ++calls;
  if (calls != atoi(at) && !(failing && needs_room)) return 0;
  if (calls == atoi(at)) note(call, path);
  if (atoi(error) == 0) kill(getpid(), SIGKILL);
  failing = on != NULL && atoi(on) != 0;
  errno = atoi(error);
  return 1;
}

static const char* path_of(int descriptor, char* path) {
  char link[64];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, path, PATH_MAX - 1);
  path[length < 0 ? 0 : length] = '\0';
  return path;
}

static int fails_at_name(const char* call, int folder, const char* name, int needs_room) {
  char path[2 * PATH_MAX + 2];
  if (name[0] == '/') return fails_at(call, name, needs_room);
  if (folder != AT_FDCWD)
    path_of(folder, path);
  else if (getcwd(path, PATH_MAX) == NULL)
    return 0;
  const size_t length = strlen(path);
  snprintf(path + length, sizeof path - length, "/%s", name);
  return fails_at(call, path, needs_room);
}

static int fails_at_file(const char* call, int file, int needs_room) {
  char path[PATH_MAX];
  const int before = errno;
  const int fails = fails_at(call, path_of(file, path), needs_room);
  if (!fails) errno = before;
  return fails;
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

#define OPENED(name, folder, ...)                                            \
  mode_t mode = 0;                                                           \
  if (flags & (O_CREAT | O_TMPFILE)) {                                       \
    va_list more;                                                            \
    va_start(more, flags);                                                   \
    mode = va_arg(more, mode_t);                                             \
    va_end(more);                                                            \
  }                                                                          \
  if (fails_at_name(#name, folder, path, (flags & O_CREAT) != 0)) return -1; \
  return REAL(name)(__VA_ARGS__, flags, mode)

int open(const char* path, int flags, ...) {
  OPENED(open, AT_FDCWD, path);
}
int open64(const char* path, int flags, ...) {
  OPENED(open64, AT_FDCWD, path);
}
int openat(int folder, const char* path, int flags, ...) {
  OPENED(openat, folder, folder, path);
}
int openat64(int folder, const char* path, int flags, ...) {
  OPENED(openat64, folder, folder, path);
}

ssize_t write(int file, const void* bytes, size_t count) {
  return fails_at_file("write", file, 1) ? -1 : REAL(write)(file, bytes, count);
}
int fsync(int file) {
  return fails_at_file("fsync", file, 0) ? -1 : REAL(fsync)(file);
}
int close(int file) {
  const int fails = fails_at_file("close", file, 0), error = errno;
  const int result = REAL(close)(file);
  if (!fails) return result;
  errno = error;
  return -1;
}
int ftruncate(int file, off_t size) {
  return fails_at_file("ftruncate", file, 0) ? -1 : REAL(ftruncate)(file, size);
}
int mkdir(const char* path, mode_t mode) {
  return fails_at_name("mkdir", AT_FDCWD, path, 1) ? -1 : REAL(mkdir)(path, mode);
}
int mkdirat(int folder, const char* path, mode_t mode) {
  return fails_at_name("mkdirat", folder, path, 1) ? -1 : REAL(mkdirat)(folder, path, mode);
}
char* mkdtemp(char* pattern) {
  return fails_at_name("mkdtemp", AT_FDCWD, pattern, 1) ? NULL : REAL(mkdtemp)(pattern);
}
int rename(const char* from, const char* to) {
  return fails_at_name("rename", AT_FDCWD, to, 0) ? -1 : REAL(rename)(from, to);
}
int renameat(int from_folder, const char* from, int to_folder, const char* to) {
  return fails_at_name("renameat", to_folder, to, 0) ? -1 : REAL(renameat)(from_folder, from, to_folder, to);
}
int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  return fails_at_name("renameat2", to_folder, to, 0)
             ? -1
             : REAL(renameat2)(from_folder, from, to_folder, to, flags);
}
int unlink(const char* path) {
  return fails_at_name("unlink", AT_FDCWD, path, 0) ? -1 : REAL(unlink)(path);
}
int unlinkat(int folder, const char* path, int flags) {
  return fails_at_name("unlinkat", folder, path, 0) ? -1 : REAL(unlinkat)(folder, path, flags);
}
int rmdir(const char* path) {
  return fails_at_name("rmdir", AT_FDCWD, path, 0) ? -1 : REAL(rmdir)(path);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*), void* given) {
  static int threads;
  const char* at = getenv("PLUMB_FAULT_THREAD");
  if (at != NULL && ++threads == atoi(at)) return EAGAIN;
  return REAL(pthread_create)(thread, attributes, work, given);
}
