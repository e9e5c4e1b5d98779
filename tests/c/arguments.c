/* SPDX-License-Identifier: MIT */
/* Every function refuses what it cannot take: a code, and a message with argument, value and what is allowed.
 */
#include <fdebench.h>

#include "check.h"

static int zero(double t, const double* y, double* f, void* user) {
  (void)t, (void)y, (void)user;
  f[0] = 0.0;
  return 0;
}

static int delayed(double t, const double* y, const double* past, double* f, void* user) {
  (void)past;
  return zero(t, y, f, user);
}

static int before(double t, double* y, void* user) { return zero(t, y, y, user); }

static const double half = 0.5, one = 1.0, not_a_number = NAN, minus = -1.0;

static void test_problem(void) {
  fdebench_problem* p = NULL;
  const double two[2] = {1.0, 2.0}, large = 2.5, between = 1.5;
  const char *same[2] = {"a", "a"}, *none[1] = {NULL}, *empty[1] = {""}, *name;
  const char* refused[2] = {"\xff", "a,b"};
  size_t n, m;
  double x;
  REJECTS(fdebench_problem_new(1, &half, 1, &one, 1.0, zero, NULL, NULL), "problem = NULL: must be ");
  REJECTS(fdebench_problem_new(1, NULL, 1, &one, 1.0, zero, NULL, &p), "orders = NULL: must be ");
  REJECTS(fdebench_problem_new(1, &half, 1, NULL, 1.0, zero, NULL, &p), "initial = NULL: must be ");
  REJECTS(fdebench_problem_new(1, &half, 1, &one, 1.0, NULL, NULL, &p), "f = NULL: must be a function");
  REJECTS(fdebench_problem_new(0, &half, 1, &one, 1.0, zero, NULL, &p), "unknowns = 0: must be in [1, ");
  REJECTS(fdebench_problem_new((size_t)-1, &half, 1, &one, 1.0, zero, NULL, &p), "unknowns = ");
  REJECTS(fdebench_problem_new(1, &half, (size_t)-1, &one, 1.0, zero, NULL, &p), "initial_count = ");
  REJECTS(fdebench_problem_new(1, &large, 1, &one, 1.0, zero, NULL, &p),
          "orders = 2.5: must be a number in [0, 2]");
  REJECTS(fdebench_problem_new(1, &not_a_number, 1, &one, 1.0, zero, NULL, &p), "orders = nan: must be ");
  REJECTS(fdebench_problem_new(1, &between, 1, &one, 1.0, zero, NULL, &p), "initial_count = 1: must be 2");
  REJECTS(fdebench_problem_new(1, &half, 2, two, 1.0, zero, NULL, &p), "initial_count = 2: must be 1");
  REJECTS(fdebench_problem_new(1, &half, 1, &not_a_number, 1.0, zero, NULL, &p),
          "initial[0] = [nan]: must be 1 finite");
  REJECTS(fdebench_problem_new(1, &half, 1, &one, -1.0, zero, NULL, &p),
          "end = -1: must be a number above 0");
  REJECTS(fdebench_problem_new(1, &half, 1, &one, INFINITY, zero, NULL, &p), "end = inf: must be ");
  REJECTS(fdebench_problem_of_scene(NULL, &p), "scene = NULL: must be a text");
  REJECTS(fdebench_problem_of_scene("", &p), "scene = \"\": must not be empty");
  REJECTS(fdebench_problem_of_scene("relaxation", NULL), "problem = NULL: must be ");
  REJECTS(fdebench_problem_of_scene("relaxatio", &p), "scene ");
  REJECTS(fdebench_problem_of_scene("relaxation:gamma=3", &p), "gamma = 3: must be a number in (0, 2]");
  REJECTS(fdebench_problem_of_scene("fractional_extremum:until=0.5", &p), "until = 0.5: must be 1: ");
  REJECTS(fdebench_problem_of_scene("absent.toml", &p), "absent.toml: ");
  CHECK(p == NULL);

  DONE(fdebench_problem_new(1, &half, 1, &one, 1.0, zero, NULL, &p));
  REJECTS(fdebench_problem_set_jacobian(NULL, zero), "problem = NULL: must be ");
  REJECTS(fdebench_problem_set_names(NULL, 1, same), "problem = NULL: must be ");
  REJECTS(fdebench_problem_set_names(p, 1, NULL), "names = NULL: must be ");
  REJECTS(fdebench_problem_set_names(p, 2, same), "count = 2: must be in [1, 1]");
  REJECTS(fdebench_problem_set_names(p, 1, none), "names = NULL: must be a text");
  for (size_t i = 0; i < sizeof refused / sizeof *refused; ++i)
    REJECTS(fdebench_problem_set_names(p, 1, &refused[i]),
            "names: must be texts that print, without a comma");
  REJECTS(fdebench_problem_set_names(p, 1, empty), "names = \"\": must not be empty");
  REJECTS(fdebench_problem_set_jumps(NULL, 1, &half), "problem = NULL: must be ");
  REJECTS(fdebench_problem_set_jumps(p, 1, NULL), "times = NULL: must be ");
  REJECTS(fdebench_problem_set_jumps(p, 1, &minus), "jumps = -1: must be a number above 0");
  {
    const double falling[2] = {0.5, 0.25};
    REJECTS(fdebench_problem_set_jumps(p, 2, falling), "jumps = [0.5, 0.25]: must be increasing");
  }
  DONE(fdebench_problem_set_jumps(p, 0, NULL));
  REJECTS(fdebench_problem_set_delays(NULL, 1, &half, delayed, NULL, before), "problem = NULL: must be ");
  REJECTS(fdebench_problem_set_delays(p, 0, &half, delayed, NULL, before), "count = 0: must be in [1, ");
  REJECTS(fdebench_problem_set_delays(p, 1, NULL, delayed, NULL, before), "delays = NULL: must be ");
  REJECTS(fdebench_problem_set_delays(p, 1, &minus, delayed, NULL, before),
          "delays = -1: must be a number above 0");
  REJECTS(fdebench_problem_set_delays(p, 1, &half, NULL, NULL, before), "f = NULL: must be a function");
  REJECTS(fdebench_problem_set_delays(p, 1, &half, delayed, NULL, NULL), "before = NULL: must be a function");
  REJECTS(fdebench_problem_size(NULL, &n, &m), "problem = NULL: must be ");
  REJECTS(fdebench_problem_size(p, NULL, &m), "unknowns = NULL: must be ");
  REJECTS(fdebench_problem_size(p, &n, NULL), "columns = NULL: must be ");
  REJECTS(fdebench_problem_name(NULL, 0, &name), "problem = NULL: must be ");
  REJECTS(fdebench_problem_name(p, 0, NULL), "name = NULL: must be ");
  REJECTS(fdebench_problem_name(p, 1, &name), "column = 1: must be below 1");
  REJECTS(fdebench_problem_order(NULL, 0, &x), "problem = NULL: must be ");
  REJECTS(fdebench_problem_order(p, 0, NULL), "order = NULL: must be ");
  REJECTS(fdebench_problem_order(p, 1, &x), "unknown = 1: must be below 1");
  REJECTS(fdebench_problem_end(NULL, &x), "problem = NULL: must be ");
  REJECTS(fdebench_problem_end(p, NULL), "end = NULL: must be ");
  fdebench_problem_free(p);
  fdebench_problem_free(NULL);
}

static void test_options(void) {
  fdebench_options* o = NULL;
  REJECTS(fdebench_options_new(NULL), "options = NULL: must be ");
  DONE(fdebench_options_new(&o));
  REJECTS(fdebench_options_set_integer(NULL, "steps", 1), "options = NULL: must be ");
  REJECTS(fdebench_options_set_integer(o, NULL, 1), "name = NULL: must be a text");
  REJECTS(fdebench_options_set_integer(o, "stepz", 1), "name = stepz: must be of accuracy, at, ");
  REJECTS(fdebench_options_set_real(NULL, "error", 1), "options = NULL: must be ");
  REJECTS(fdebench_options_set_real(o, "", 1), "name = \"\": must not be empty");
  REJECTS(fdebench_options_set_reals(o, "at", 0, &one), "count = 0: must be in [1, ");
  REJECTS(fdebench_options_set_reals(o, "at", 1, NULL), "values = NULL: must be ");
  REJECTS(fdebench_options_set_reals(NULL, "at", 1, &one), "options = NULL: must be ");
  REJECTS(fdebench_options_set_text(NULL, "grid", "uniform"), "options = NULL: must be ");
  REJECTS(fdebench_options_set_text(o, "grid", NULL), "value = NULL: must be a text");
  REJECTS(fdebench_options_set_text(o, "grid", ""), "value = \"\": must not be empty");
  fdebench_options_free(o);
  fdebench_options_free(NULL);
}

/* Sets one option, and calls a function that refuses it. */
static void rejects_option(const fdebench_problem* p, const char* name, const char* value,
                           const char* message) {
  fdebench_options* o = NULL;
  fdebench_table* table = NULL;
  DONE(fdebench_options_new(&o));
  DONE(fdebench_options_set_integer(o, "steps", 8));
  DONE(fdebench_options_set_text(o, name, value));
  REJECTS(fdebench_solve(p, "l1", o, &table), message);
  CHECK(table == NULL);
  fdebench_options_free(o);
}

static void test_solve(void) {
  fdebench_problem* p = NULL;
  fdebench_options* o = NULL;
  fdebench_table* table = NULL;
  size_t n, m;
  double x;
  const char* text;
  DONE(fdebench_problem_of_scene("relaxation", &p));
  DONE(fdebench_options_new(&o));
  REJECTS(fdebench_solve(p, "l1", o, &table), "steps is required");
  REJECTS(fdebench_solve(NULL, "l1", o, &table), "problem = NULL: must be ");
  REJECTS(fdebench_solve(p, NULL, o, &table), "scheme = NULL: must be a text");
  REJECTS(fdebench_solve(p, "l1", NULL, &table), "options = NULL: must be ");
  REJECTS(fdebench_solve(p, "l1", o, NULL), "table = NULL: must be ");
  rejects_option(p, "steps", "0", "steps = 0: must be ");
  rejects_option(p, "steps", "many", "steps = many: must be ");
  rejects_option(p, "grid", "square", "grid = square: must be ");
  rejects_option(p, "at", "0.1234567", "at = 0.1234567: must be a time of the grid");
  rejects_option(p, "every", "-1", "every = -1: must be ");
  rejects_option(p, "points", "1", "points = 1: must be ");
  rejects_option(p, "history", "old", "history = old: must be ");
  rejects_option(p, "tolerance", "2", "tolerance = 2: must be ");
  rejects_option(p, "budget", "-1", "budget = -1: must be ");
  rejects_option(p, "threads", "0", "threads = 0: must be ");
  rejects_option(p, "check", "2", "check = 2: must be ");
  rejects_option(p, "error", "1e-3", "option = error: must be of accuracy, at, ");
  rejects_option(p, "accuracy", "1e-3", "scheme = l1: ");
  DONE(fdebench_options_set_integer(o, "steps", 8));
  REJECTS(fdebench_solve(p, "l7", o, &table), "scheme ");
  DONE(fdebench_solve(p, "l1", o, &table));
  REJECTS(fdebench_table_size(NULL, &n, &m), "table = NULL: must be ");
  REJECTS(fdebench_table_size(table, NULL, &m), "times = NULL: must be ");
  REJECTS(fdebench_table_size(table, &n, NULL), "columns = NULL: must be ");
  REJECTS(fdebench_table_name(NULL, 0, &text), "table = NULL: must be ");
  REJECTS(fdebench_table_name(table, 0, NULL), "name = NULL: must be ");
  REJECTS(fdebench_table_times(NULL, &x, 9), "table = NULL: must be ");
  REJECTS(fdebench_table_times(table, NULL, 9), "times = NULL: must be ");
  REJECTS(fdebench_table_values(NULL, &x, 9), "table = NULL: must be ");
  REJECTS(fdebench_table_values(table, NULL, 9), "values = NULL: must be ");
  REJECTS(fdebench_table_bounds(NULL, &x, 9), "table = NULL: must be ");
  REJECTS(fdebench_table_number(NULL, "rhs", &x), "table = NULL: must be ");
  REJECTS(fdebench_table_number(table, NULL, &x), "fact = NULL: must be a text");
  REJECTS(fdebench_table_number(table, "rhs", NULL), "number = NULL: must be ");
  REJECTS(fdebench_table_text(NULL, "warning", &text), "table = NULL: must be ");
  REJECTS(fdebench_table_text(table, "warning", NULL), "text = NULL: must be ");
  fdebench_table_free(table);
  fdebench_table_free(NULL);
  table = NULL;

  REJECTS(fdebench_exact(NULL, 1, &one, &table), "problem = NULL: must be ");
  REJECTS(fdebench_exact(p, 0, &one, &table), "count = 0: must be in [1, ");
  REJECTS(fdebench_exact(p, 1, NULL, &table), "times = NULL: must be ");
  REJECTS(fdebench_exact(p, 1, &minus, &table), "times = -1: must be a finite number of at least 0");
  REJECTS(fdebench_exact(p, 1, &not_a_number, &table), "times = nan: must be a finite number of at least 0");
  REJECTS(fdebench_exact(p, 1, &one, NULL), "table = NULL: must be ");
  CHECK(table == NULL);
  fdebench_options_free(o);
  fdebench_problem_free(p);
}

static void test_choose(void) {
  fdebench_problem* p = NULL;
  fdebench_options* o = NULL;
  fdebench_choice* choice = NULL;
  const char* text;
  double x;
  DONE(fdebench_problem_new(1, &half, 1, &one, 1.0, zero, NULL, &p));
  DONE(fdebench_options_new(&o));
  FAILS(fdebench_choose(p, o, &choice), FDEBENCH_BAD_ARGUMENT, "error");
  REJECTS(fdebench_choose(NULL, o, &choice), "problem = NULL: must be ");
  REJECTS(fdebench_choose(p, NULL, &choice), "options = NULL: must be ");
  REJECTS(fdebench_choose(p, o, NULL), "choice = NULL: must be ");
  DONE(fdebench_options_set_real(o, "error", 2.0));
  REJECTS(fdebench_choose(p, o, &choice), "error = 2: must be ");
  DONE(fdebench_options_set_real(o, "error", 1e-3));
  DONE(fdebench_options_set_text(o, "norm", "largest"));
  REJECTS(fdebench_choose(p, o, &choice), "norm = largest: must be ");
  DONE(fdebench_options_set_text(o, "norm", "end"));
  DONE(fdebench_options_set_text(o, "columns", "--json"));
  REJECTS(fdebench_choose(p, o, &choice), "columns = ");
  CHECK(choice == NULL);
  REJECTS(fdebench_choice_number(NULL, "error", &x), "choice = NULL: must be ");
  REJECTS(fdebench_choice_text(NULL, "scheme", &text), "choice = NULL: must be ");
  REJECTS(fdebench_choice_apply(NULL, o), "choice = NULL: must be ");
  fdebench_choice_free(NULL);
  fdebench_options_free(o);
  fdebench_problem_free(p);
}

static void test_functions_and_lists(void) {
  double value[2], bound;
  char text[64];
  size_t count;
  const char* name;
  REJECTS(fdebench_mittag_leffler(0.5, 1, 0, 0, NULL, &bound), "value = NULL: must be ");
  REJECTS(fdebench_mittag_leffler(0.5, 1, 0, 0, value, NULL), "bound = NULL: must be ");
  REJECTS(fdebench_mittag_leffler(NAN, 1, 0, 0, value, &bound),
          "mittag_leffler: alpha = nan has to be in (0, 5]");
  REJECTS(fdebench_mittag_leffler_digits(NULL, "1", "0", "0", 9, text, text, text, 64),
          "alpha = NULL: must be a text");
  REJECTS(fdebench_mittag_leffler_digits("1", NULL, "0", "0", 9, text, text, text, 64),
          "beta = NULL: must be a text");
  REJECTS(fdebench_mittag_leffler_digits("1", "1", NULL, "0", 9, text, text, text, 64),
          "re = NULL: must be a text");
  REJECTS(fdebench_mittag_leffler_digits("1", "1", "0", NULL, 9, text, text, text, 64),
          "im = NULL: must be a text");
  REJECTS(fdebench_mittag_leffler_digits("1", "1", "0", "0", 9, NULL, text, text, 64),
          "value_re = NULL: must be ");
  REJECTS(fdebench_mittag_leffler_digits("1", "1", "0", "0", 9, text, NULL, text, 64),
          "value_im = NULL: must be ");
  REJECTS(fdebench_mittag_leffler_digits("1", "1", "0", "0", 9, text, text, NULL, 64),
          "bound = NULL: must be ");
  REJECTS(fdebench_scheme_count(NULL), "count = NULL: must be ");
  REJECTS(fdebench_scene_count(NULL), "count = NULL: must be ");
  DONE(fdebench_scheme_count(&count));
  REJECTS(fdebench_scheme_name(count, &name), "index = ");
  REJECTS(fdebench_scheme_name(0, NULL), "name = NULL: must be ");
  DONE(fdebench_scene_count(&count));
  REJECTS(fdebench_scene_name(count, &name), "index = ");
  REJECTS(fdebench_scene_name(0, NULL), "name = NULL: must be ");
}

/* The lists, one name a line, for comparison with those of the command. */
static void print_lists(void) {
  size_t count;
  const char* name;
  DONE(fdebench_scheme_count(&count));
  for (size_t i = 0; i < count; ++i) {
    DONE(fdebench_scheme_name(i, &name));
    puts(name);
  }
  DONE(fdebench_scene_count(&count));
  for (size_t i = 0; i < count; ++i) {
    DONE(fdebench_scene_name(i, &name));
    puts(name);
  }
}

int main(void) {
  CHECK(strcmp(fdebench_last_error(), "") == 0 && fdebench_callback_code() == 0);
  CHECK(strcmp(fdebench_version(), FDEBENCH_VERSION) == 0 && fdebench_abi() == FDEBENCH_ABI);
  test_problem();
  test_options();
  test_solve();
  test_choose();
  test_functions_and_lists();
  print_lists();
  fdebench_end_thread();
  return 0;
}
