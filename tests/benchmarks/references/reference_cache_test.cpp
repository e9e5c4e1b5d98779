// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>

#include "fdebench/benchmarks/references/cache.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reference/nonlinear/collocation.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

// Tests must not read or write the cache of the user.
class DisabledUserCache : public testing::Environment {
  void SetUp() override { setenv("FDEBENCH_CACHE", "", 1); }
};
const auto* const no_cache = testing::AddGlobalTestEnvironment(new DisabledUserCache);

// D^order y = -y^3 that counts its evaluations.
struct Counted {
  std::shared_ptr<int> calls = std::make_shared<int>(0);
  Problem problem;

  explicit Counted(double order = 0.5, double end = 1.0, double factor = -1.0) {
    problem = {.components = {{order, {1.0}}},
               .rhs =
                   [calls = calls, factor](double, In y, Out f) {
                     ++*calls;
                     f[0] = factor * y[0] * y[0] * y[0];
                   },
               .end = end};
  }
};

class Cache : public testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] auto files() const { return std::distance(fs::directory_iterator(folder_), {}); }

  // Whether the reference of the problem came from the cache: the key takes only a few evaluations.
  [[nodiscard]] bool hit(const Counted& counted, const std::string& name = "cubic") const {
    *counted.calls = 0;
    cached_reference(name, counted.problem, cache_);
    return *counted.calls < 20;
  }

  const fs::path folder_ = fs::temp_directory_path() / ("fde_cache_" + std::to_string(getpid()));
  const ReferenceCache cache_{folder_};
};

void write(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

TEST_F(Cache, GivesTheSameDoublesAgain) {
  const Counted counted;
  EXPECT_FALSE(hit(counted));
  EXPECT_TRUE(hit(counted));
  const reference::Reference known = cached_reference("cubic", counted.problem, cache_);
  const reference::Reference solved = reference::reference_solution(counted.problem);
  for (const double t : {0.0, 1e-30, 1e-9, 0.1, 0.37, 1.0}) {
    EXPECT_EQ(known.at(t).value, solved.at(t).value);
    EXPECT_EQ(known.at(t).bound, solved.at(t).bound);
  }
  EXPECT_EQ(files(), 1);  // no unfinished file remains
}

TEST_F(Cache, KeepsProblemsApart) {
  const Counted counted;
  EXPECT_FALSE(hit(counted));
  EXPECT_FALSE(hit(Counted(0.6)));
  EXPECT_FALSE(hit(Counted(0.5, 2.0)));
  EXPECT_FALSE(hit(Counted(0.5, 1.0, -1.0000000000000002)));  // the equation itself
  EXPECT_FALSE(hit(counted, "cubic a=2"));
  EXPECT_TRUE(hit(counted));
  EXPECT_EQ(files(), 5);
}

TEST(ReferenceKey, TellsEventsThatSetUnknownsApart) {
  const auto key = [](double at, double jump, Crossing crossing) {
    const Reset reset{.value = [at](double t, In) { return t - at; },
                      .crossing = crossing,
                      .state = [jump](double, In, Out y) { y[0] += jump; }};
    return reference_key(
        "dose",
        {.components = {{0.5, {1.0}}}, .rhs = [](double, In y, Out f) { f = -y; }, .resets = {reset}});
  };
  const auto known = key(0.5, 1.0, Crossing::either);
  EXPECT_NE(key(0.25, 1.0, Crossing::either), known);
  EXPECT_NE(key(0.5, 2.0, Crossing::either), known);
  EXPECT_NE(key(0.5, 1.0, Crossing::rising), known);
  EXPECT_EQ(key(0.5, 1.0, Crossing::either), known);
}

TEST_F(Cache, SolvesAnewWhatIsDamaged) {
  const Counted counted;
  EXPECT_FALSE(hit(counted));
  const auto file = cache_.file_of(reference_key("cubic", counted.problem));
  const std::string good = content_of(file);
  std::vector<std::string> damaged{"",
                                   "short",
                                   "something else of more than thirty-two bytes",
                                   good.substr(0, 32),
                                   good.substr(0, good.size() - 1),
                                   good + " "};
  for (const std::size_t position : {std::size_t{0}, std::size_t{40}, good.size() / 2, good.size() - 1}) {
    damaged.push_back(good);
    damaged.back()[position] ^= 1;
  }
  for (const auto& bytes : damaged) {
    write(file, bytes);
    EXPECT_FALSE(cache_.load(reference_key("cubic", counted.problem), counted.problem));
  }
  EXPECT_FALSE(hit(counted));
  EXPECT_TRUE(hit(counted));
}

TEST_F(Cache, TakesNoFileOfAnotherProblem) {
  const Counted one, other(0.7);
  EXPECT_FALSE(hit(one));
  EXPECT_FALSE(hit(other));
  const auto key = [](const Counted& of) { return reference_key("cubic", of.problem); };
  fs::copy_file(cache_.file_of(key(other)), cache_.file_of(key(one)), fs::copy_options::overwrite_existing);
  EXPECT_FALSE(cache_.load(key(one), one.problem));
}

TEST_F(Cache, TakesNoTableOfAnotherShape) {
  const Counted counted;
  const TimedTable good{reference::reference_table(counted.problem), 0.25};
  const auto loads = [&](const TimedTable& table) {
    cache_.store("key", table);
    return cache_.load("key", counted.problem).has_value();
  };
  EXPECT_TRUE(loads(good));
  TimedTable gap = good, narrow = good, early = good, timeless = good;
  gap.panels.panels.erase(gap.panels.panels.begin() + 3);
  narrow.panels.panels[5].values.conservativeResize(4, 1);
  early.panels.panels.pop_back();
  timeless.seconds = -1.0;
  EXPECT_FALSE(loads(gap));
  EXPECT_FALSE(loads(narrow));
  EXPECT_FALSE(loads(early));
  EXPECT_FALSE(loads(timeless));
  EXPECT_FALSE(loads({}));
}

// Its time is that of the computation, also when the reference is read.
TEST_F(Cache, KeepsTheTimeOfAReference) {
  const Counted counted;
  const auto computed = cached_reference("cubic", counted.problem, cache_).seconds;
  ASSERT_TRUE(computed.has_value());
  EXPECT_GT(*computed, 0.0);
  EXPECT_EQ(cached_reference("cubic", counted.problem, cache_).seconds, computed);
}

TEST_F(Cache, DoesWithoutAFolderThatCannotBeWritten) {
  const Counted counted;
  const auto expected = reference::reference_solution(counted.problem).at(1.0).value;
  write(folder_ / "file", "no folder");
  for (const auto& folder : {std::optional(folder_ / "file" / "cache"), std::optional<fs::path>()})
    EXPECT_EQ(cached_reference("cubic", counted.problem, ReferenceCache(folder)).at(1.0).value, expected);
}

TEST_F(Cache, DoesWithoutAFileThatCannotBeReadOrReplaced) {
  const Counted counted;
  fs::create_directories(cache_.file_of(reference_key("cubic", counted.problem)) / "a folder");
  EXPECT_FALSE(hit(counted));
  EXPECT_FALSE(hit(counted));
  EXPECT_EQ(files(), 1);
}

TEST_F(Cache, IsWhereTheEnvironmentSays) {
  const std::string home = std::getenv("HOME") == nullptr ? "" : std::getenv("HOME");
  EXPECT_EQ(cache_folder(), std::nullopt);
  setenv("FDEBENCH_CACHE", "/some/where", 1);
  EXPECT_EQ(cache_folder(), fs::path("/some/where"));
  unsetenv("FDEBENCH_CACHE");
  setenv("XDG_CACHE_HOME", "/caches", 1);
  EXPECT_EQ(cache_folder(), fs::path("/caches/fdebench"));
  unsetenv("XDG_CACHE_HOME");
  setenv("HOME", "/home/me", 1);
  EXPECT_EQ(cache_folder(), fs::path("/home/me/.cache/fdebench"));
  setenv("HOME", home.c_str(), 1);
  setenv("FDEBENCH_CACHE", "", 1);
}

TEST_F(Cache, MakesNoHomeThatIsNotThere) {
  const std::string home = std::getenv("HOME") == nullptr ? "" : std::getenv("HOME");
  const auto nobody = folder_ / "nobody", cached = nobody / ".cache" / "fdebench";
  const auto keep = [&] {
    const Counted counted;
    const ReferenceCache cache(cached);
    cached_reference("cubic", counted.problem, cache);
  };
  setenv("HOME", nobody.c_str(), 1);
  keep();
  EXPECT_FALSE(fs::exists(nobody));
  fs::create_directories(nobody);
  keep();
  EXPECT_TRUE(fs::exists(cached));
  setenv("HOME", home.c_str(), 1);
}

TEST_F(Cache, HoldsScenesByTheirParametersAndEnd) {
  setenv("FDEBENCH_CACHE", folder_.c_str(), 1);
  auto scene = scene_of("pendulum");
  scene.problem.end = 2.0;
  const Vec value = reference_of(scene).at(1.0).value;
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(reference_of(scene).at(1.0).value, value);
  EXPECT_EQ(files(), 1);
  reference_of(scene_of("relaxation"));  // has an exact solution
  EXPECT_EQ(files(), 1);
  auto other = scene_of("pendulum", {{"mu", 0.07}});
  other.problem.end = 2.0;
  EXPECT_NE(reference_of(other).at(1.0).value, value);
  EXPECT_EQ(files(), 2);
  setenv("FDEBENCH_CACHE", "", 1);
}

}  // namespace
}  // namespace fde::bench
