/* SPDX-License-Identifier: MIT */
/* What is computed, against formulas. */
#include <fdebench.h>

#include "check.h"

#define STEPS 512

/* D^order y = rate y + (the user's number) - y^2 * square */
struct equation {
  double rate, constant, square;
  int calls, stop_after;
};

static int right_hand_side(double t, const double* y, double* f, void* user) {
  struct equation* const e = user;
  (void)t;
  f[0] = e->rate * y[0] + e->constant - e->square * y[0] * y[0];
  return ++e->calls == e->stop_after ? 7 : 0;
}

static int jacobian(double t, const double* y, double* df, void* user) {
  const struct equation* const e = user;
  (void)t;
  df[0] = e->rate - 2 * e->square * y[0];
  return 0;
}

static fdebench_problem* problem_of(double order, double initial, struct equation* e) {
  fdebench_problem* problem = NULL;
  DONE(fdebench_problem_new(1, &order, 1, &initial, 1.0, right_hand_side, e, &problem));
  return problem;
}

static fdebench_options* options_with(const char* name, long long value) {
  fdebench_options* options = NULL;
  DONE(fdebench_options_new(&options));
  DONE(fdebench_options_set_integer(options, name, value));
  return options;
}

/* D^0.5 y = -y: y = e^t erfc(sqrt t), at all times of a graded grid. */
static void test_relaxation(void) {
  struct equation e = {.rate = -1.0};
  fdebench_problem* const problem = problem_of(0.5, 1.0, &e);
  fdebench_options* const options = options_with("steps", STEPS);
  fdebench_table* table = NULL;
  size_t times, columns;
  double t[STEPS + 1], y[STEPS + 1], calls, seconds;
  const char *name, *text;
  DONE(fdebench_options_set_text(options, "grid", "graded:2"));
  DONE(fdebench_solve(problem, "product_trapezoidal", options, &table));
  DONE(fdebench_table_size(table, &times, &columns));
  CHECK(times == STEPS + 1 && columns == 1);
  DONE(fdebench_table_name(table, 0, &name));
  CHECK(strcmp(name, "y") == 0);
  DONE(fdebench_table_times(table, t, times));
  DONE(fdebench_table_values(table, y, times));
  for (size_t i = 0; i < times; ++i) NEAR(y[i], exp(t[i]) * erfc(sqrt(t[i])), 2e-5);
  CHECK(t[0] == 0.0 && y[0] == 1.0 && t[STEPS] == 1.0);
  DONE(fdebench_table_number(table, "rhs", &calls));
  DONE(fdebench_table_number(table, "seconds", &seconds));
  CHECK(calls >= STEPS && calls <= e.calls && seconds > 0);
  DONE(fdebench_table_text(table, "warning", &text));
  CHECK(strcmp(text, "") == 0);
  DONE(fdebench_table_text(table, "ended", &text));
  CHECK(strcmp(text, "") == 0);
  REJECTS(fdebench_table_bounds(table, y, times), "table: must be of fdebench_exact");
  REJECTS(fdebench_table_values(table, y, STEPS), "capacity = 512: must be at least 513");
  REJECTS(fdebench_table_times(table, t, 0), "capacity = 0: must be at least 513");
  REJECTS(fdebench_table_number(table, "warning", &calls), "fact = warning: must be of ");
  REJECTS(fdebench_table_text(table, "rhs", &text), "fact = rhs: must be of ");
  REJECTS(fdebench_table_name(table, 1, &name), "column = 1: must be below 1");
  fdebench_table_free(table);
  fdebench_options_free(options);
  fdebench_problem_free(problem);
}

/* y' = 1 - y^2: y = tanh t, with a Jacobian and an accuracy in place of steps. */
static void test_tanh(void) {
  struct equation e = {.constant = 1.0, .square = 1.0};
  fdebench_problem* const problem = problem_of(1.0, 0.0, &e);
  fdebench_options* options = NULL;
  fdebench_table* table = NULL;
  const double at[2] = {0.25, 1.0};
  const char* const names[1] = {"height"};
  const char* name;
  double y[2], bounds[2];
  DONE(fdebench_problem_set_jacobian(problem, jacobian));
  DONE(fdebench_problem_set_names(problem, 1, names));
  DONE(fdebench_options_new(&options));
  DONE(fdebench_options_set_real(options, "accuracy", 1e-9));
  DONE(fdebench_options_set_reals(options, "at", 2, at));
  DONE(fdebench_solve(problem, "spectral_collocation", options, &table));
  DONE(fdebench_table_name(table, 0, &name));
  CHECK(strcmp(name, "height") == 0);
  DONE(fdebench_table_values(table, y, 2));
  for (int i = 0; i < 2; ++i) NEAR(y[i], tanh(at[i]), 1e-8);
  fdebench_table_free(table);

  DONE(fdebench_exact(problem, 2, at, &table));
  DONE(fdebench_table_values(table, y, 2));
  DONE(fdebench_table_bounds(table, bounds, 2));
  for (int i = 0; i < 2; ++i) {
    NEAR(y[i], tanh(at[i]), bounds[i] + 1e-15);
    CHECK(bounds[i] < 1e-10);
  }
  fdebench_table_free(table);
  fdebench_options_free(options);
  fdebench_problem_free(problem);
}

/* q' = v, D^1.5-free oscillator as one row of order 2, and an algebraic row that doubles it: two kinds of
 * rows. */
static int doubled(double t, const double* y, double* f, void* user) {
  (void)t, (void)user;
  f[0] = -y[0];
  f[1] = y[1] - 2 * y[0];
  return 0;
}

static int doubled_jacobian(double t, const double* y, double* df, void* user) {
  const double by_rows[4] = {-1, 0, -2, 1};
  (void)t, (void)y, (void)user;
  memcpy(df, by_rows, sizeof by_rows);
  return 0;
}

static void test_rows(void) {
  const double orders[2] = {2.0, 0.0}, initial[3] = {1.0, 0.0, 2.0}, end = 1.0;
  fdebench_problem* problem = NULL;
  fdebench_options* const options = options_with("steps", 400);
  fdebench_table* table = NULL;
  size_t unknowns, columns;
  double y[2], order, last;
  DONE(fdebench_problem_new(2, orders, 3, initial, end, doubled, NULL, &problem));
  DONE(fdebench_problem_set_jacobian(problem, doubled_jacobian));
  DONE(fdebench_problem_size(problem, &unknowns, &columns));
  CHECK(unknowns == 2 && columns == 2);
  DONE(fdebench_problem_order(problem, 0, &order));
  DONE(fdebench_problem_end(problem, &last));
  CHECK(order == 2.0 && last == 1.0);
  DONE(fdebench_options_set_reals(options, "at", 1, &end));
  DONE(fdebench_solve(problem, "product_trapezoidal", options, &table));
  DONE(fdebench_table_values(table, y, 2));
  NEAR(y[0], cos(1.0), 1e-5);
  NEAR(y[1], 2 * cos(1.0), 2e-5);
  fdebench_table_free(table);
  fdebench_options_free(options);
  fdebench_problem_free(problem);
}

static void test_stop(void) {
  struct equation e = {.rate = -1.0, .stop_after = 100};
  fdebench_problem* const problem = problem_of(0.5, 1.0, &e);
  fdebench_options* const options = options_with("steps", STEPS);
  const double at = 1.0;
  fdebench_table* table = NULL;
  fdebench_choice* choice = NULL;
  FAILS(fdebench_solve(problem, "adams_pc", options, &table), FDEBENCH_STOPPED, "f: returned 7 at t = 0.");
  CHECK(fdebench_callback_code() == 7 && e.calls == 100 && table == NULL);
  e.calls = 0;
  FAILS(fdebench_exact(problem, 1, &at, &table), FDEBENCH_STOPPED, "f: returned 7 at t = ");
  CHECK(table == NULL);
  fdebench_options_free(options);
  {
    fdebench_options* question = NULL;
    DONE(fdebench_options_new(&question));
    DONE(fdebench_options_set_real(question, "error", 1e-4));
    e.calls = 0;
    FAILS(fdebench_choose(problem, question, &choice), FDEBENCH_STOPPED, "f: returned 7 at t = ");
    CHECK(choice == NULL);
    fdebench_options_free(question);
  }
  fdebench_problem_free(problem);
}

static void test_failure(void) {
  struct equation e = {.square = -1.0}; /* y' = y^2 reaches infinity at t = 1 / y(0) */
  fdebench_problem* const problem = problem_of(1.0, 20.0, &e);
  fdebench_options* const options = options_with("steps", STEPS);
  fdebench_table* table = NULL;
  FAILS(fdebench_solve(problem, "adams_pc", options, &table), FDEBENCH_NUMERICAL_FAILURE, "adams_pc: ");
  CHECK(table == NULL);
  fdebench_options_free(options);
  fdebench_problem_free(problem);
}

/* A scene, what is known of it, and the scheme that choose finds for it. */
static void test_choose(void) {
  fdebench_problem* problem = NULL;
  fdebench_options *options = NULL, *run = NULL;
  fdebench_choice* choice = NULL;
  fdebench_table *table = NULL, *known = NULL;
  const char *scheme, *command, *json, *grid, *name;
  const double end = 1.0;
  double error, seconds, y, exact, bound;
  DONE(fdebench_problem_of_scene("relaxation:gamma=0.7", &problem));
  DONE(fdebench_options_new(&options));
  DONE(fdebench_options_set_real(options, "error", 1e-5));
  DONE(fdebench_options_set_text(options, "scale", "absolute"));
  DONE(fdebench_options_set_real(options, "max-time", 30.0));
  DONE(fdebench_choose(problem, options, &choice));
  DONE(fdebench_choice_text(choice, "scheme", &scheme));
  DONE(fdebench_choice_text(choice, "command", &command));
  DONE(fdebench_choice_text(choice, "json", &json));
  DONE(fdebench_choice_text(choice, "grid", &grid));
  DONE(fdebench_choice_number(choice, "error", &error));
  DONE(fdebench_choice_number(choice, "seconds", &seconds));
  CHECK(strncmp(command, "fdebench solve relaxation:gamma=0.7 --scheme ", 45) == 0 &&
        strstr(command, scheme));
  CHECK(json[0] == '{' && error <= 1e-5 && seconds > 0 && seconds < 1);
  DONE(fdebench_options_new(&run));
  DONE(fdebench_options_set_text(run, "columns", "y"));
  DONE(fdebench_choice_apply(choice, run));
  DONE(fdebench_options_set_reals(run, "at", 1, &end));
  DONE(fdebench_solve(problem, scheme, run, &table));
  DONE(fdebench_table_values(table, &y, 1));
  DONE(fdebench_exact(problem, 1, &end, &known));
  DONE(fdebench_table_values(known, &exact, 1));
  DONE(fdebench_table_bounds(known, &bound, 1));
  CHECK(bound < 1e-15);
  NEAR(y, exact, 1e-5);
  DONE(fdebench_problem_name(problem, 0, &name));
  CHECK(strcmp(name, "y") == 0);
  REJECTS(fdebench_choice_text(choice, "steps", &name), "fact = steps: must be of ");
  REJECTS(fdebench_choice_number(choice, "scheme", &y), "fact = scheme: must be of ");
  REJECTS(fdebench_problem_set_jacobian(problem, jacobian),
          "problem = relaxation:gamma=0.7: must be of fdebench_problem_new");
  fdebench_table_free(known);
  fdebench_table_free(table);
  fdebench_choice_free(choice);
  fdebench_options_free(run);
  fdebench_options_free(options);
  fdebench_problem_free(problem);
}

/* Two columns in another order of times, twice the same time, and columns without a bound. */
static void test_exact(void) {
  fdebench_problem* problem = NULL;
  fdebench_table* table = NULL;
  size_t times, columns;
  const double at[3] = {1.0, 0.5, 1.0};
  double *values, *bounds, known[3];
  DONE(fdebench_problem_of_scene("pendulum", &problem));
  DONE(fdebench_exact(problem, 3, at, &table));
  DONE(fdebench_table_size(table, &times, &columns));
  CHECK(times == 3 && columns > 1);
  DONE(fdebench_table_times(table, known, 3));
  CHECK(memcmp(known, at, sizeof at) == 0);
  values = malloc(2 * times * columns * sizeof *values);
  bounds = values + times * columns;
  DONE(fdebench_table_values(table, values, times * columns));
  DONE(fdebench_table_bounds(table, bounds, times * columns));
  for (size_t c = 0; c < columns; ++c) CHECK(values[c] == values[2 * columns + c]);
  CHECK(values[0] != values[columns] && bounds[0] > 0 && bounds[0] < 1e-10);
  free(values);
  fdebench_table_free(table);
  fdebench_problem_free(problem);
}

/* E_{1/2}(-1) = e erfc(1); E_1(i) = e^i. */
static void test_mittag_leffler(void) {
  double value[2], bound;
  char re[96], im[96], error[96];
  DONE(fdebench_mittag_leffler(0.5, 1.0, -1.0, 0.0, value, &bound));
  NEAR(value[0], exp(1.0) * erfc(1.0), bound + 1e-15);
  CHECK(value[1] == 0.0 && bound < 1e-15);
  DONE(fdebench_mittag_leffler(1.0, 1.0, 0.0, 1.0, value, &bound));
  NEAR(value[0], cos(1.0), 1e-15);
  NEAR(value[1], sin(1.0), 1e-15);
  DONE(fdebench_mittag_leffler_digits("0.5", "1", "-1", "0", 40, re, im, error, 72));
  CHECK(strncmp(re, "0.42758357615580700441075034449051518082", 40) == 0 && strlen(error) > 0);
  CHECK(atof(im) == 0.0);
  REJECTS(fdebench_mittag_leffler_digits("0.5", "1", "-1", "0", 40, re, im, error, 4),
          "capacity = 4: must be at least ");
  REJECTS(fdebench_mittag_leffler_digits("0.5", "1", "x", "0", 40, re, im, error, 72),
          "mittag_leffler: re z: 'x' is not a finite decimal number");
  REJECTS(fdebench_mittag_leffler_digits("0.5", "1", "-1", "0", 0, re, im, error, 72),
          "mittag_leffler: digits = 0 ");
  REJECTS(fdebench_mittag_leffler(6.0, 1.0, -1.0, 0.0, value, &bound),
          "mittag_leffler: alpha = 6 has to be in (0, 5]");
}

/* D^0.8 y(t) = -1.5 y(t - 1), y = 1 up to t = 0: the delayed Mittag-Leffler function
 * sum over k < t + 1 of (-1.5)^k (t - k + 1)^(0.8 k) / Gamma(0.8 k + 1). */
static int delayed(double t, const double* y, const double* past, double* f, void* user) {
  (void)t, (void)y, (void)user;
  f[0] = -1.5 * past[0];
  return 0;
}

static int no_slope(double t, const double* y, const double* past, double* df, void* user) {
  (void)t, (void)y, (void)past, (void)user;
  df[0] = 0;
  return 0;
}

static int one(double t, double* y, void* user) {
  (void)t, (void)user;
  y[0] = 1;
  return 0;
}

static void test_delay(void) {
  const double order = 0.8, initial = 1.0, delays[1] = {1.0}, end = 3.0;
  struct equation unused = {.rate = 0.0};
  fdebench_problem* problem = NULL;
  fdebench_options* options = NULL;
  fdebench_table* table = NULL;
  double y, bound, right = 0.0;
  for (int k = 0; k < 4; ++k) right += pow(-1.5, k) * pow(4.0 - k, 0.8 * k) / tgamma(0.8 * k + 1);
  DONE(fdebench_problem_new(1, &order, 1, &initial, end, right_hand_side, &unused, &problem));
  DONE(fdebench_problem_set_delays(problem, 1, delays, delayed, no_slope, one));
  DONE(fdebench_options_new(&options));
  DONE(fdebench_options_set_real(options, "accuracy", 1e-9));
  DONE(fdebench_options_set_reals(options, "at", 1, &end));
  DONE(fdebench_solve(problem, "spectral_collocation", options, &table));
  DONE(fdebench_table_values(table, &y, 1));
  NEAR(y, right, 2e-8);
  fdebench_table_free(table);
  DONE(fdebench_exact(problem, 1, &end, &table));
  DONE(fdebench_table_values(table, &y, 1));
  DONE(fdebench_table_bounds(table, &bound, 1));
  NEAR(y, right, bound + 1e-15);
  CHECK(bound < 1e-11 && unused.calls == 0);
  fdebench_table_free(table);
  fdebench_options_free(options);
  fdebench_problem_free(problem);
}

int main(void) {
  test_relaxation();
  test_tanh();
  test_rows();
  test_delay();
  test_stop();
  test_failure();
  test_choose();
  test_exact();
  test_mittag_leffler();
  fdebench_end_thread();
  return 0;
}
