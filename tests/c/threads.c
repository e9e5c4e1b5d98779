/* SPDX-License-Identifier: MIT */
/* Two threads solve one problem at a time, again and again; each has messages of its own. */
#include <fdebench.h>
#include <pthread.h>

#include "check.h"

#define ROUNDS 20

static int relaxation(double t, const double* y, double* f, void* user) {
  (void)t, (void)user;
  f[0] = -y[0];
  return 0;
}

struct work {
  const fdebench_problem* problem;
  const char* scheme;
  const char* unknown;
};

static void* solve(void* argument) {
  const struct work* const work = argument;
  double y;
  for (int i = 0; i < ROUNDS; ++i) {
    fdebench_options* options = NULL;
    fdebench_table* table = NULL;
    DONE(fdebench_options_new(&options));
    DONE(fdebench_options_set_integer(options, "steps", 256));
    DONE(fdebench_options_set_text(options, "at", "1"));
    DONE(fdebench_solve(work->problem, work->scheme, options, &table));
    DONE(fdebench_table_values(table, &y, 1));
    NEAR(y, exp(1.0) * erfc(1.0), 2e-3);
    CHECK(fdebench_solve(work->problem, work->unknown, options, &(fdebench_table*){NULL}) ==
          FDEBENCH_BAD_ARGUMENT);
    CHECK(strstr(fdebench_last_error(), work->unknown) != NULL);
    fdebench_table_free(table);
    fdebench_options_free(options);
  }
  {
    const double end = 1.0;
    fdebench_table* known = NULL;
    DONE(fdebench_exact(work->problem, 1, &end, &known));
    DONE(fdebench_table_values(known, &y, 1));
    NEAR(y, exp(1.0) * erfc(1.0), 1e-12);
    fdebench_table_free(known);
  }
  fdebench_end_thread();
  return NULL;
}

int main(void) {
  const double order = 0.5, initial = 1.0;
  fdebench_problem* problem = NULL;
  pthread_t threads[2];
  DONE(fdebench_problem_new(1, &order, 1, &initial, 1.0, relaxation, NULL, &problem));
  struct work works[2] = {{problem, "product_trapezoidal", "no_scheme"},
                          {problem, "grunwald_letnikov", "none"}};
  for (int i = 0; i < 2; ++i) CHECK(pthread_create(&threads[i], NULL, solve, &works[i]) == 0);
  for (int i = 0; i < 2; ++i) CHECK(pthread_join(threads[i], NULL) == 0);
  fdebench_problem_free(problem);
  return 0;
}
