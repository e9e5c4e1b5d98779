// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace fde::bench {
namespace {

TEST(SceneRegistry, HasTheIdsOfItsScenesInOrder) {
  const SceneRegistry scenes;
  EXPECT_TRUE(std::ranges::equal(scenes.ids(), scenes, {}, {}, &SceneFactory::id));
  EXPECT_EQ(scenes.ids().size(), scenes.size());
}

TEST(SceneRegistry, SharesItsScenesWithCopies) {
  const SceneRegistry copy(built_in_scenes(), nullptr);
  EXPECT_EQ(find_scene("pendulum", copy), find_scene("pendulum"));
  EXPECT_EQ(&copy.named("pendulum"), find_scene("pendulum"));
}

TEST(SceneRegistry, MakesASceneWhenItIsNamed) {
  SceneRegistry scenes;
  const SceneFactory& added =
      scenes.add({.id = "mine", .title = "", .source = "", .parameters = {}, .make = {}});
  EXPECT_EQ(&scenes.named("mine"), &added);
  EXPECT_EQ(scenes.ids().back(), "mine");
  EXPECT_THROW(scenes.add({.id = "relaxation", .title = "", .source = "", .parameters = {}, .make = {}}),
               std::invalid_argument);
  EXPECT_THROW((void)scenes.named("none"), std::invalid_argument);
}

}  // namespace
}  // namespace fde::bench
