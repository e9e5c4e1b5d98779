/* SPDX-License-Identifier: MIT */
#ifndef FDE_TESTS_CHECK_H
#define FDE_TESTS_CHECK_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Ends the program unless the condition holds. */
#define CHECK(condition)                                                                                     \
  do {                                                                                                       \
    if (!(condition)) {                                                                                      \
      fprintf(stderr, "%s:%d: %s; last error: %s\n", __FILE__, __LINE__, #condition, fdebench_last_error()); \
      exit(1);                                                                                               \
    }                                                                                                        \
  } while (0)

#define DONE(call) CHECK((call) == FDEBENCH_DONE)
#define NEAR(value, wanted, error) CHECK(fabs((value) - (wanted)) <= (error))

/* The call fails with this status and a message that begins so. */
#define FAILS(call, status, message)                                        \
  do {                                                                      \
    CHECK((call) == (status));                                              \
    CHECK(strncmp(fdebench_last_error(), (message), strlen(message)) == 0); \
  } while (0)
#define REJECTS(call, message) FAILS(call, FDEBENCH_BAD_ARGUMENT, message)

#endif
