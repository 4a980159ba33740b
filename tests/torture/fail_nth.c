/* Preloaded into a program, makes one of its calls fail: the one of the kind FAIL_CALL that has the number FAIL_AT (from 1), or that one
 * and all after it where FAIL_FROM_THEN_ON is set. FAIL_IN: "worker", "parent" or, by default, both. Into the file FAIL_COUNT the number of
 * calls is added at the end, a line a process. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

static atomic_long calls;
static long fail_at = -1;
static int from_then_on;
static const char* kind = "";
static int ready;

__attribute__((constructor)) static void begin(void) {
  const char *at = getenv("FAIL_AT"), *what = getenv("FAIL_CALL"), *in = getenv("FAIL_IN");
  const int worker = getenv("PMREPORT_WORKER") != NULL;
  if (what == NULL) return;
  if (in != NULL && strcmp(in, "worker") == 0 && !worker) return;
  if (in != NULL && strcmp(in, "parent") == 0 && worker) return;
  kind = what;
  fail_at = at != NULL ? atol(at) : 0;
  from_then_on = getenv("FAIL_FROM_THEN_ON") != NULL;
  ready = 1;
}

__attribute__((destructor)) static void end(void) {
  const char* count = getenv("FAIL_COUNT");
  if (!ready || count == NULL) return;
  FILE* file = fopen(count, "a");
  if (file == NULL) return;
  fprintf(file, "%ld\n", (long)calls);
  fclose(file);
}

static int fails(const char* what) {
  if (!ready || strcmp(what, kind) != 0) return 0;
  const long n = ++calls;
  return from_then_on ? fail_at > 0 && n >= fail_at : n == fail_at;
}

#define NEXT(name)               \
  static __typeof__(name)* next; \
  if (next == NULL) next = (__typeof__(name)*)dlsym(RTLD_NEXT, #name)

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);

void* malloc(size_t n) {
  if (fails("malloc")) {
    errno = ENOMEM;
    return NULL;
  }
  return __libc_malloc(n);
}
void* calloc(size_t n, size_t size) {
  if (fails("malloc")) {
    errno = ENOMEM;
    return NULL;
  }
  return __libc_calloc(n, size);
}
void* realloc(void* p, size_t n) {
  if (fails("malloc")) {
    errno = ENOMEM;
    return NULL;
  }
  return __libc_realloc(p, n);
}
ssize_t write(int fd, const void* bytes, size_t n) {
  NEXT(write);
  if (fails("write")) {
    errno = ENOSPC;
    return -1;
  }
  return next(fd, bytes, n);
}
int fsync(int fd) {
  NEXT(fsync);
  if (fails("fsync")) {
    errno = EIO;
    return -1;
  }
  return next(fd);
}
int rename(const char* from, const char* to) {
  NEXT(rename);
  if (fails("rename")) {
    errno = EIO;
    return -1;
  }
  return next(from, to);
}
int renameat2(int a, const char* from, int b, const char* to, unsigned flags) {
  NEXT(renameat2);
  if (fails("rename")) {
    errno = EIO;
    return -1;
  }
  return next(a, from, b, to, flags);
}
int mkdir(const char* path, mode_t mode) {
  NEXT(mkdir);
  if (fails("mkdir")) {
    errno = ENOSPC;
    return -1;
  }
  return next(path, mode);
}
void* mmap(void* at, size_t n, int protection, int flags, int fd, off_t offset) {
  NEXT(mmap);
  if (fails("mmap")) {
    errno = ENOMEM;
    return MAP_FAILED;
  }
  return next(at, n, protection, flags, fd, offset);
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  NEXT(pthread_create);
  if (fails("thread")) return EAGAIN;
  return next(thread, attributes, run, argument);
}
#define OPEN(name)                                                                    \
  int name(const char* path, int flags, ...) {                                        \
    static int (*next)(const char*, int, ...);                                        \
    if (next == NULL) next = (int (*)(const char*, int, ...))dlsym(RTLD_NEXT, #name); \
    mode_t mode = 0;                                                                  \
    if (flags & (O_CREAT | O_TMPFILE)) {                                              \
      va_list more;                                                                   \
      va_start(more, flags);                                                          \
      mode = va_arg(more, mode_t);                                                    \
      va_end(more);                                                                   \
    }                                                                                 \
    if (fails("open")) {                                                              \
      errno = EMFILE;                                                                 \
      return -1;                                                                      \
    }                                                                                 \
    return next(path, flags, mode);                                                   \
  }
OPEN(open)
OPEN(open64)
FILE* fopen(const char* path, const char* mode) {
  static FILE* (*next)(const char*, const char*);
  if (next == NULL) next = (FILE * (*)(const char*, const char*)) dlsym(RTLD_NEXT, "fopen");
  if (fails("open")) {
    errno = EMFILE;
    return NULL;
  }
  return next(path, mode);
}
