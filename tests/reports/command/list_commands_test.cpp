// SPDX-License-Identifier: MIT
// The lists of scenes and schemes, scenes added at run time included.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/reports/command/command.hpp"
#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(Lists, NameEverySceneAndScheme) {
  const auto all_scenes = nlohmann::json::parse(fdebench("scenes --json").out);
  ASSERT_EQ(all_scenes.size(), built_in_scenes().size());
  EXPECT_EQ(all_scenes[0]["id"], "relaxation");
  EXPECT_EQ(all_scenes[0]["parameters"][0]["default"], 0.5);
  EXPECT_EQ(all_scenes[0]["columns"], std::vector<std::string>{"y"});
  const auto all_schemes = nlohmann::json::parse(fdebench("schemes --json").out);
  ASSERT_EQ(all_schemes.size(), schemes().size());
  EXPECT_THAT(fdebench("scenes").out, HasSubstr("brusselator"));
  EXPECT_THAT(fdebench("schemes").out, HasSubstr("decoupled_multi_order"));
}

// The positions of the titles in the lines.
std::set<std::size_t> title_places(const std::string& table) {
  std::set<std::size_t> places;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    const auto gap = line.find("   ");
    places.insert(line.find_first_not_of(' ', gap));
  }
  return places;
}

TEST(Lists, TellAllOfOne) {
  const auto pendulum = fdebench("scenes pendulum").out;
  EXPECT_THAT(pendulum, StartsWith("pendulum: "));
  EXPECT_THAT(pendulum, HasSubstr("\ncolumns: phi, Dbeta_phi, dphi, Dalpha_phi\n"));
  EXPECT_THAT(pendulum,
              testing::ContainsRegex("\nbeta +0.5 +a number in .0, 1. +lower order of damping; at 0 not "
                                     "the limit from above\n"));
  EXPECT_THAT(pendulum, HasSubstr("\nreference: two methods\n"));
  EXPECT_THAT(pendulum, HasSubstr("\nschemes that take an accuracy: spectral_collocation, "));
  const std::string program = "fdebench ";
  std::vector<std::string> examples;
  for (auto at = pendulum.find("fdebench solve"); at != std::string::npos;
       at = pendulum.find("fdebench solve", at + 1))
    examples.push_back(pendulum.substr(at, pendulum.find('\n', at) - at).substr(program.size()));
  ASSERT_EQ(examples.size(), 2U) << "one over a grid, one to an accuracy";
  for (const auto& example : examples) EXPECT_EQ(fdebench(example).code, 0) << example;
  EXPECT_THAT(fdebench("schemes l1").out, testing::ContainsRegex("implicit +yes\n"));
}

// The method of the reference of each scene.
TEST(Lists, SayWhatVouchesForEveryScene) {
  std::map<std::string, std::set<std::string>> of;
  for (const auto& scene : nlohmann::json::parse(fdebench("scenes --json").out))
    of[scene["reference"]].insert(scene["id"]);
  EXPECT_THAT(of["closed form"], testing::IsSupersetOf({"power", "diethelm", "knife_edge"}));
  EXPECT_THAT(of["inverse Laplace transform"],
              testing::IsSupersetOf({"relaxation", "bagley_torvik", "fractional_constraint_2d"}));
  EXPECT_THAT(of["two methods"], testing::IsSupersetOf({"pendulum", "brusselator", "isokinetic"}));
}

TEST(Lists, AreAlignedTables) {
  EXPECT_EQ(title_places(fdebench("scenes").out).size(), 1U);
  EXPECT_EQ(title_places(fdebench("schemes").out).size(), 1U);
}

TEST(Lists, SayParametersAndNeedsWhereAsked) {
  const auto parameters = fdebench("scenes --parameters").out;
  EXPECT_THAT(parameters, StartsWith("scene "));
  EXPECT_THAT(parameters, testing::ContainsRegex("formulation +integrated +one of integrated, acceleration"));
  const auto needs = fdebench("schemes --needs").out;
  EXPECT_THAT(needs, testing::ContainsRegex("scheme +implicit +algebraic_rows"));
  EXPECT_THAT(needs, testing::ContainsRegex("adams_pc +no +no +no +2 +no"));
  EXPECT_EQ(fdebench("scenes --json --parameters").code, 2);
}

TEST(Lists, GiveManyColumnsAsAPattern) {
  for (const auto& scene : nlohmann::json::parse(fdebench("scenes --json").out)) {
    if (scene["id"] != "fractional_diffusion") {
      EXPECT_TRUE(scene["columns"].is_array()) << scene["id"];
      continue;
    }
    const nlohmann::json pattern{{"pattern", "u{i}"}, {"from", 1}, {"to", 200}};
    EXPECT_EQ(scene["columns"], pattern);
  }
}

// D^g y = -k y or + k y, a scene defined at run time.
SceneFactory decay() {
  return {.id = "decay",
          .title = "Made at run time",
          .source = "here",
          .parameters = {{"g", 0.5, order_up_to_one, "order"}, choice("sign", {"minus", "plus"}, "of k")},
          .make = [](const Parameters& p) -> Scene {
            const double rate = p.choice("sign") == "minus" ? -1.0 : 1.0;
            return {.problem = {.components = {{p["g"], {1.0}}},
                                .rhs = [=](double, In y, Out f) { f = rate * y; }},
                    .smoothness = {{power_lattice({p["g"]}, {p["g"]}, p["g"] + 2.0)}},
                    .outputs = {{"y"}}};
          }};
}

// The smoothness of the solution at 0 is not declared: there is no theoretical rate, and everything else
// works.
TEST(ScenesMadeAtRunTime, NeedNoSmoothness) {
  const TemporaryFolder folder;
  const std::string file = folder.file("r.jsonl");
  SceneRegistry mine;
  SceneFactory bare = decay(), wrong = decay();
  bare.make = [](const Parameters& p) {
    Scene scene = decay().make(p);
    scene.smoothness = {};
    return scene;
  };
  wrong.id = "wrong";
  wrong.make = [](const Parameters& p) {
    Scene scene = decay().make(p);
    scene.smoothness.powers.push_back({1.0});
    return scene;
  };
  mine.add(bare);
  mine.add(wrong);
  expect_success(
      fde::bench::fdebench({"run", "--scene", "decay", "--steps", "16,32,64", "--out", file}, mine));
  for (const auto& recorded : read_results(file).records)
    EXPECT_FALSE(recorded["expected_rate_end"] || recorded["expected_rate_maximum"]);
  for (const std::string scheme : {"l1", "decoupled_multi_order", "grunwald_letnikov"}) {
    const auto solved =
        fde::bench::fdebench({"solve", "decay", "--scheme", scheme, "--steps", "8", "--cost"}, mine);
    EXPECT_EQ(solved.code, 0) << solved.err;
    EXPECT_THAT(solved.err, Not(HasSubstr("expected_rate")));
  }
  EXPECT_EQ(fde::bench::fdebench({"choose", "decay", "--error", "1e-2"}, mine).code, 0);
  EXPECT_THAT(fde::bench::fdebench({"solve", "wrong", "--scheme", "l1", "--steps", "8"}, mine),
              fails_with(2, HasSubstr("scene wrong: its smoothness has 2 rows for 1 components")));
}

TEST(ScenesMadeAtRunTime, AreListedSolvedAndKnown) {
  SceneRegistry mine;
  mine.add(decay());
  EXPECT_EQ(mine.size(), built_in_scenes().size() + 1);
  EXPECT_THAT(fde::bench::fdebench({"scenes"}, mine).out, HasSubstr("Made at run time"));
  const std::vector<std::string> how{"--scheme", "adams_pc", "--steps", "64", "--set"};
  const auto solved = [&](std::vector<std::string> words, const std::string& setting) {
    words.insert(words.end(), how.begin(), how.end());
    words.push_back(setting);
    return fde::bench::fdebench(words, mine);
  };
  EXPECT_EQ(solved({"solve", "decay"}, "g=0.5").out, solved({"solve", "relaxation"}, "gamma=0.5").out);
  EXPECT_EQ(solved({"solve", "decay"}, "sign=plus").out, solved({"solve", "relaxation"}, "lambda=1").out);
  EXPECT_THAT(solved({"solve", "decay"}, "sign=maybe").err,
              HasSubstr("sign = maybe: must be one of minus, plus"));
  const auto known = fde::bench::fdebench({"exact", "decay", "--at", "1"}, mine).out;
  EXPECT_THAT(known, HasSubstr("0.42758357615580"));
  EXPECT_EQ(fdebench("solve decay --scheme l1 --steps 8").code, 2);  // not in the list of scenes
}

TEST(ScenesMadeAtRunTime, HaveIdsOfTheirOwn) {
  SceneRegistry mine;
  const SceneFactory& first = mine.add(decay());
  expect_message([&] { mine.add(decay()); }, "id = decay: must be that of no other scene");
  auto named = decay();
  named.id = "decay:2";
  expect_message([&] { mine.add(named); }, "id = decay:2: must be a name without ':'");
  named.id = "decay2";
  mine.add(named);
  EXPECT_EQ(&first, &mine.named("decay"));
  EXPECT_EQ(parse_variant("decay2:g=0.25,sign=plus", mine).label(), "decay2:g=0.25,sign=plus");
  EXPECT_EQ(find_scene("decay"), nullptr);
}

}  // namespace
}  // namespace fde::bench
