// SPDX-License-Identifier: MIT
// Commands offer to project initial velocities onto the constraints, and say by how much each changed.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

TEST(ProjectedVelocity, IsOfferedWhereAStartIsRefusedAndSaidOnce) {
  const TemporaryFolder folder;
  folder.write("f.toml",
               "end = 1\n[coordinate.x]\ninitial = [0, 0.333333]\n[coordinate.y]\ninitial = [0, "
               "-0.166667]\n[mechanics]\n"
               "lagrangian = \"(D(x,1)^2 + 3*D(y,1)^2)/2 - x^2\"\nconstraints = [\"D(x,1) + 2*D(y,1) + "
               "0.3*D(x,0.4)\"]\n");
  const std::string file = folder.file("f.toml");
  EXPECT_THAT(fdebench({"solve", file, "--scheme", "l1", "--steps", "4"}),
              fails_with(2, HasSubstr("--set initial_velocity=projected takes it\n")));
  const std::string line =
      "fdebench: " + file +
      ": initial velocities projected onto the constraints: D(x,1) by 4.29e-07, D(y,1) by "
      "2.86e-07\n";
  const std::string scene = file + ":initial_velocity=projected";
  EXPECT_EQ(fdebench({"solve", scene, "--scheme", "l1", "--steps", "64"}).err, line);
  EXPECT_EQ(fdebench({"exact", scene, "--at", "1"}).err, line);
  EXPECT_EQ(fdebench({"exact", scene, "--at", "1", "--quiet"}).err, "");
  EXPECT_THAT(
      fdebench({"solve", "knife_edge:initial_velocity=projected", "--scheme", "l1", "--steps", "4"}).err,
      HasSubstr("has no such parameter"));
}

}  // namespace
}  // namespace fde::bench
