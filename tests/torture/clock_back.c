/* Preloaded into a program, lets the clock on the wall go back by an hour each time that anybody looks at it. What counts the time that has
 * passed goes on as ever. Into the file CLOCK_COUNT goes how often it was looked at, a line a process. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/time.h>
#include <time.h>

static atomic_long looks;

static time_t back(time_t now) { return now - 3600 * ++looks; }

int clock_gettime(clockid_t clock, struct timespec* out) {
  static int (*next)(clockid_t, struct timespec*);
  if (next == NULL) next = (int (*)(clockid_t, struct timespec*))dlsym(RTLD_NEXT, "clock_gettime");
  const int status = next(clock, out);
  if (status == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)) out->tv_sec = back(out->tv_sec);
  return status;
}

int gettimeofday(struct timeval* out, void* zone) {
  (void)zone;
  struct timespec now;
  if (clock_gettime(CLOCK_REALTIME, &now) != 0) return -1;
  out->tv_sec = now.tv_sec, out->tv_usec = now.tv_nsec / 1000;
  return 0;
}

time_t time(time_t* out) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  if (out != NULL) *out = now.tv_sec;
  return now.tv_sec;
}

__attribute__((destructor)) static void end(void) {
  const char* count = getenv("CLOCK_COUNT");
  FILE* file = count != NULL ? fopen(count, "a") : NULL;
  if (file == NULL) return;
  fprintf(file, "%ld\n", (long)looks);
  fclose(file);
}
