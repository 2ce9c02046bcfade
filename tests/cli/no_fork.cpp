// Preloaded: the processes that start plug-ins can start none, as where a container has all it may.
#include <errno.h>
#include <unistd.h>

extern "C" pid_t fork() {
  errno = EAGAIN;
  return -1;
}
