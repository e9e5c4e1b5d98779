#include <fdebench.h>
#include <math.h>
#include <stdio.h>

/* D^0.9 y = 1 - y^2, y(0) = 0. */
static int riccati(double t, const double* y, double* f, void* user) {
  (void)t, (void)user;
  f[0] = 1.0 - y[0] * y[0];
  return 0;
}

int main(void) {
  const double order = 0.9, initial = 0.0, end = 1.0;
  double solved, exact, bound, calls;
  fdebench_problem* problem = NULL;
  fdebench_options* options = NULL;
  fdebench_table *table = NULL, *known = NULL;
  int status = fdebench_problem_new(1, &order, 1, &initial, end, riccati, NULL, &problem);
  if (!status) status = fdebench_options_new(&options);
  if (!status) status = fdebench_options_set_integer(options, "steps", 1024);
  if (!status) status = fdebench_options_set_reals(options, "at", 1, &end);
  if (!status) status = fdebench_solve(problem, "product_trapezoidal", options, &table);
  if (!status) status = fdebench_table_values(table, &solved, 1);
  if (!status) status = fdebench_table_number(table, "rhs", &calls);
  if (!status) status = fdebench_exact(problem, 1, &end, &known);
  if (!status) status = fdebench_table_values(known, &exact, 1);
  if (!status) status = fdebench_table_bounds(known, &bound, 1);
  if (status)
    fprintf(stderr, "%s\n", fdebench_last_error());
  else
    printf("y(1) = %.12f after %.0f calls of f, error %.1e, known to %.0e\n", solved, calls,
           fabs(solved - exact), bound);
  fdebench_table_free(known);
  fdebench_table_free(table);
  fdebench_options_free(options);
  fdebench_problem_free(problem);
  return status;
}
