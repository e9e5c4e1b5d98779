// SPDX-License-Identifier: MIT
// Scenes that are built-in equation files, and files found in the folder $FDEBENCH_SCENES.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

std::vector<const SceneFactory*> built_in_files() {
  std::vector<const SceneFactory*> makers;
  for (const SceneFactory& factory : built_in_scenes())
    if (!factory.toml.empty()) makers.push_back(&factory);
  return makers;
}

class BuiltInFile : public testing::TestWithParam<const SceneFactory*> {};

TEST_P(BuiltInFile, IsPrintedAsItIs) {
  const std::string id = GetParam()->id;
  EXPECT_EQ(fdebench("scenes " + id + " --toml").out,
            content_of(FDE_SOURCE_DIR "/benchmarks/scenes/" + id + ".toml"));
}

TEST_P(BuiltInFile, IsTheSameSceneWhenItIsSaved) {
  const SceneFactory& factory = *GetParam();
  const SceneFactory saved = equation_scene(parse_equation_text("saved.toml", factory.toml));
  EXPECT_EQ(saved.title, factory.title);
  EXPECT_EQ(saved.source, factory.source);
  EXPECT_FALSE(saved.checksum.empty());
  EXPECT_TRUE(factory.checksum.empty());
  const Scene a = make_scene(saved), b = make_scene(factory);
  EXPECT_TRUE(a.from_file);
  EXPECT_FALSE(b.from_file);
  EXPECT_EQ(a.outputs.names, b.outputs.names);
  EXPECT_EQ(a.smoothness.powers, b.smoothness.powers);
  EXPECT_TRUE(!a.smoothness.powers.empty() || has_algebraic_rows(a.problem));
}

INSTANTIATE_TEST_SUITE_P(Every, BuiltInFile, testing::ValuesIn(built_in_files()), id_of_param);

TEST(BuiltInFiles, ArePrintedOnlyWhereTheyAreFiles) {
  EXPECT_GE(built_in_files().size(), 14U);
  EXPECT_THAT(fdebench("scenes multi_term --toml").err,
              StartsWith("fdebench: --toml = multi_term: must be a scene that is an equation file"));
  EXPECT_EQ(fdebench("scenes --toml").code, 2);
}

class SceneFolder : public testing::Test {
 protected:
  void SetUp() override { ::setenv("FDEBENCH_SCENES", folder_.path().c_str(), 1); }
  void TearDown() override { ::unsetenv("FDEBENCH_SCENES"); }
  TemporaryFolder folder_;
};

TEST_F(SceneFolder, HasScenesByTheirNames) {
  folder_.write("my_scene.toml", relaxation_file("-x"));
  EXPECT_THAT(printed(fdebench("solve my_scene:until=2 --scheme l1 --steps 8 --at 2")),
              StartsWith("t,x\n2,"));
  EXPECT_THAT(fdebench("solve no_scene --scheme l1 --steps 8").err, HasSubstr("no_scene"));
}

TEST_F(SceneFolder, MustNotHaveTheNameOfABuiltInScene) {
  folder_.write("pendulum.toml", relaxation_file("-x"));
  EXPECT_THAT(
      fdebench("scenes"),
      fails_with(2, HasSubstr("pendulum.toml: must have another name, the scene pendulum is built in\n")));
}

}  // namespace
}  // namespace fde::bench
