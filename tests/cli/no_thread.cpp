// Preloaded: the first thread of the process starts others, which can start none.
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <unistd.h>

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*run)(void*), void* argument) {
  if (::gettid() != ::getpid()) return EAGAIN;
  using Create = decltype(&pthread_create);
  const auto create = reinterpret_cast<Create>(::dlsym(RTLD_NEXT, "pthread_create"));
  return create(thread, attributes, run, argument);
}
