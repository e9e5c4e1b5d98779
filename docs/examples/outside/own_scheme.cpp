#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <fdebench/fdebench.hpp>

namespace bench = fde::bench;

// The explicit rule that takes f on each step from the beginning of the step, with y = T + J^a f and T the
// Taylor polynomial of the initial values:
//   y_n = T(t_n) + sum_{j < n} ((t_n - t_j)^a - (t_n - t_{j+1})^a) / Gamma(a + 1) f(t_j, y_j).
fde::Rows rectangle_rule(const fde::Problem& problem, const std::vector<double>& times) {
  const auto count = static_cast<Eigen::Index>(times.size());
  fde::Rows y(problem.size(), count), f(problem.size(), count);
  fde::Vec rate(problem.size());
  for (Eigen::Index n = 0; n < count; ++n) {
    const double t = times[n];
    for (Eigen::Index i = 0; i < y.rows(); ++i) {
      const double order = problem.components[i].order;
      const auto& initial = problem.components[i].initial;
      double sum = 0.0;
      for (Eigen::Index j = 0; j < n; ++j)
        sum += (std::pow(t - times[j], order) - std::pow(t - times[j + 1], order)) * f(i, j);
      y(i, n) = initial[0] + (initial.size() > 1 ? initial[1] * t : 0.0) + sum / std::tgamma(order + 1.0);
    }
    problem.rhs(t, y.col(n), rate);
    f.col(n) = rate;
  }
  return y;
}

// What the rule takes for an error of 1 % on ten scenes, beside the best scheme.
int main() {
  const bench::OwnScheme mine("rectangle_rule", rectangle_rule);
  for (const char* name :
       {"relaxation", "relaxation_pair", "linear_system", "power", "diethelm", "pendulum:until=2",
        "bagley_torvik:until=2", "brusselator:until=2", "loxodrome", "stiff_relaxation"}) {
    const auto variant = bench::read_variant(name, {});
    const auto made =
        bench::choose(bench::make_scene(variant),
                      {.error = 1e-2, .seconds = 20.0, .schemes = {&mine.scheme()}}, variant.key());
    const auto show = [&](const bench::RecommendedRun& run, const std::string& what) {
      const double times = run.time.median / made.options.front().time.median;
      std::printf("%-22s %-22s N = %-5d error %.1e, %.2g times as long: %s\n", name,
                  run.schemes.front().c_str(), run.steps, run.error, times, what.c_str());
    };
    show(made.options.front(), "the best");
    const auto is_mine = [](const bench::RecommendedRun& run) {
      return run.schemes.front() == "rectangle_rule";
    };
    const auto within = std::ranges::find_if(made.options, is_mine);
    const auto missed = std::ranges::find_if(made.rejected, is_mine, &bench::RejectedScheme::finest);
    if (within != made.options.end())
      show(*within, "within 1 %");
    else if (missed != made.rejected.end())
      show(missed->finest, missed->reason);
  }
}
