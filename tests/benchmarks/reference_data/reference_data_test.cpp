// SPDX-License-Identifier: MIT
// The contents of the reference data: every scene, descriptions, reproducible bytes.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "benchmarks/reference_data/example_tables.hpp"
#include "fdebench/benchmarks/reference_data/data_package.hpp"
#include "fdebench/benchmarks/reference_data/data_table.hpp"
#include "fdebench/benchmarks/reference_data/tables/mittag_leffler_table.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "support/matchers.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

// A scene with two hundred columns has no table of trajectories; its variants with few columns have one.
TEST(ReferenceData, HasATableOfEveryKindAndScene) {
  std::vector<SceneVariant> all;
  for (const auto& factory : built_in_scenes()) all.push_back({.factory = &factory});
  const auto tables = planned_tables(all);
  EXPECT_EQ(tables.size(), 1 + 2 * built_in_scenes().size() - 1);  // no trajectories of fractional_diffusion
  for (const auto& table : tables) {
    EXPECT_TRUE(fs::exists(fmt::format(FDE_SOURCE_DIR "/reference/data/{}.csv", table.stem())))
        << table.stem();
  }
  EXPECT_EQ(tables[0].stem(), "mittag_leffler");
  EXPECT_EQ(example_tables().at(1).stem(), "trajectories/relaxation,gamma=0.2");
}

TEST(ReferenceData, IsTheSameBytesEachTime) {
  const auto again = compute_files(example_tables(), [](std::size_t, std::size_t, const std::string&) {});
  EXPECT_EQ(again, example_files());
}

TEST(ReferenceData, IsDescribed) {
  const auto json = nlohmann::json::parse(example_files().at("trajectories/relaxation,gamma=0.2.json"));
  EXPECT_EQ(json["schema"]["id"], "fdebench.trajectory");
  EXPECT_EQ(json["schema"]["columns"][1]["name"], "y");
  EXPECT_EQ(json["parameters"]["gamma"], 0.2);
  EXPECT_EQ(json["parameters"]["lambda"], -1.0);
  EXPECT_EQ(json["digits"], 50);
  for (const auto* field : {"bound", "method", "source"}) EXPECT_NE(json[field], "") << field;
  EXPECT_EQ(json["generator"]["version"], this_session().version);
  const auto& csv = example_files().at("trajectories/relaxation,gamma=0.2.csv");
  EXPECT_EQ(json["rows"], std::ranges::count(csv, '\n') - 1);
  EXPECT_EQ(json["sha256"], sha256(csv));
  EXPECT_EQ(nlohmann::json::parse(example_files().at("index.json"))["tables"].size(),
            example_tables().size());
  EXPECT_THAT(example_files().at("SHA256SUMS"),
              HasSubstr(sha256(csv) + "  trajectories/relaxation,gamma=0.2.csv\n"));
}

// tests/data_package reads the package in the repository.
TEST(ReferenceData, IsAPackageOfItsTables) {
  const auto package = nlohmann::json::parse(example_files().at("datapackage.json"));
  ASSERT_EQ(package["resources"].size(), example_tables().size());
  for (std::size_t i = 0; i < example_tables().size(); ++i) {
    const auto& resource = package["resources"][i];
    const auto& csv = example_files().at(example_tables()[i].stem() + ".csv");
    EXPECT_EQ(resource["name"], resource_name(example_tables()[i]));
    EXPECT_EQ(resource["path"], example_tables()[i].stem() + ".csv");
    EXPECT_EQ(resource["bytes"], csv.size());
    EXPECT_EQ(resource["hash"], "sha256:" + sha256(csv));
  }
  EXPECT_EQ(resource_name(example_tables().at(1)), "trajectories.relaxation-gamma-0.2");
  EXPECT_THAT(example_files().at("CITATION.cff"),
              HasSubstr("\nversion: " + package["version"].dump() + "\n"));
  EXPECT_EQ(example_files().at("LICENSE"), read_file(fs::path(FDE_SOURCE_DIR) / "LICENSE"));
}

// t^2 at t = 12 is exactly 144.
TEST(ReferenceData, HasFiftyDigits) {
  EXPECT_THAT(example_files().at("trajectories/power.csv"),
              HasSubstr("\n12,144." + std::string(47, '0') + ","));
}

// The examples on the page are the files that ctest runs.
TEST(ReferenceDocs, ShowTheExamplesThatAreTested) {
  const fs::path docs = fs::path(FDE_SOURCE_DIR) / "docs";
  const auto page = read_file(docs / "reference_data.md");
  for (const auto* name : {"read.py", "read.jl", "read.m", "read.R"})
    EXPECT_THAT(page, HasSubstr("\n" + read_file(docs / "reading" / name) + "```\n")) << name;
}

TEST(MittagLefflerPoints, AreManyAndDifferent) {
  const auto points = mittag_leffler_points();
  EXPECT_GT(points.size(), 1500U);
  std::set<std::string> different;
  for (const auto& [alpha, beta, re, im] : points)
    different.insert(fmt::format("{},{},{},{}", alpha, beta, re, im));
  EXPECT_EQ(different.size(), points.size());
}

}  // namespace
}  // namespace fde::bench
