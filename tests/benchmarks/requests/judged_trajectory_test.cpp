// SPDX-License-Identifier: MIT
// Trajectories of `power` for p = 2, whose solution is y(t) = t^2 up to t = 1.
#include "fdebench/benchmarks/requests/judged_trajectory.hpp"

#include <gtest/gtest.h>

#include "support/refusal_of.hpp"

namespace fde::bench {
namespace {

ExternalTrajectory path_of_squares(std::vector<double> times, double error_at_end = 0.0) {
  ExternalTrajectory path{.columns = {0}, .times = std::move(times)};
  path.values.resize(1, std::ssize(path.times));
  for (Eigen::Index i = 0; i < path.values.cols(); ++i) {
    const double t = path.times[static_cast<std::size_t>(i)];
    path.values(0, i) = t * t;
  }
  path.values(0, path.values.cols() - 1) += error_at_end;
  return path;
}

JudgeRequest request_for(const ExternalTrajectory& path, const std::string& scene = "power:p=2") {
  return {.variant = read_variant(scene, {}), .trajectory = [=](const Scene&) { return path; }};
}

std::string refused(const JudgeRequest& request) {
  return refusal_of([&] { judge(request); });
}

TEST(JudgedTrajectories, HaveNoErrorWhereTheyAreExact) {
  const auto exact = judge(request_for(path_of_squares({0.0, 0.25, 0.5, 1.0}))).run;
  EXPECT_LE(exact["error_maximum"].value(), 1e-15);
  const auto inexact = judge(request_for(path_of_squares({0.0, 0.25, 0.5, 1.0}, 0.125))).run;
  EXPECT_NEAR(inexact["error_end"].value(), 0.125, 1e-15);
}

TEST(JudgedTrajectories, EndTheirSceneAndNameTheirProgram) {
  auto request = request_for(path_of_squares({0.0, 0.5}));
  request.name = "other";
  request.seconds = {0.5, 0.25};
  const auto judged = judge(request);
  EXPECT_EQ(label_of(judged.run.key.scene), "power:p=2,until=0.5");
  EXPECT_EQ(judged.run.key.scheme, "other");
  EXPECT_EQ(judged.run["time_minimum"], 0.25);
  EXPECT_EQ(judged.description().scene, judged.run.key.scene);
}

TEST(JudgedTrajectories, NameTheFieldThatTheyRefuse) {
  auto request = request_for(path_of_squares({0.0, 1.0}));
  request.seconds = {0.5, 0.0};
  EXPECT_EQ(refused(request), "<seconds> = 0: must be a finite number above 0");
  request.name = "l1";
  EXPECT_EQ(refused(request), "<name> = l1: must be another name than those of our schemes");
  EXPECT_EQ(refused(request_for(path_of_squares({0.0, 0.5}), "fractional_hamilton")),
            "<trajectory>: ends at t = 0.5, scene fractional_hamilton is posed at both ends, 0 and 2");
}

}  // namespace
}  // namespace fde::bench
