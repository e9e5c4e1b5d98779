// SPDX-License-Identifier: MIT
// Every test named in docs/papers.md exists, and the page names every test of a printed error.

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <regex>
#include <set>
#include <string>

#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

std::string text_of_the_page() { return content_of(FDE_SOURCE_DIR "/docs/papers.md"); }

// Names in backquotes of the form Suite.Test or Suite.Test/parameter.
std::set<std::string> tests_on_the_page() {
  const std::string page = text_of_the_page();
  const std::regex name("`([A-Z][A-Za-z0-9]*\\.[A-Z][A-Za-z0-9]*(/[a-z0-9_]+)?)`");
  std::set<std::string> names;
  for (auto it = std::sregex_iterator(page.begin(), page.end(), name); it != std::sregex_iterator(); ++it) {
    names.insert((*it)[1]);
  }
  return names;
}

std::set<std::string> tests_of_this_program() {
  std::set<std::string> names;
  const auto& program = *testing::UnitTest::GetInstance();
  for (int i = 0; i < program.total_test_suite_count(); ++i) {
    const auto& suite = *program.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count(); ++k) {
      names.insert(std::string(suite.name()) + "." + suite.GetTestInfo(k)->name());
    }
  }
  return names;
}

// Whether the conformance tests, which run over all scenes and schemes, contain this name.
bool is_conformance_test(const std::string& name) {
  const std::string command = "'" FDE_CONFORMANCE_TESTS "' --gtest_list_tests --gtest_filter=" + name;
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string list;
  for (int c = 0; (c = std::fgetc(pipe.get())) != EOF;) list += static_cast<char>(c);
  return list.find(name.substr(name.find('.') + 1)) != std::string::npos;
}

TEST(PapersPage, NamesTestsThatExist) {
  const auto named = tests_on_the_page(), existing = tests_of_this_program();
  EXPECT_GT(named.size(), 30U);
  for (const auto& name : named) EXPECT_TRUE(existing.contains(name) || is_conformance_test(name)) << name;
}

// Suites as in `Modes.*`: each has a test in a source file of any folder of tests.
TEST(PapersPage, NamesSuitesThatExist) {
  std::string sources;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(FDE_SOURCE_DIR "/tests")) {
    if (entry.path().extension() != ".cpp") continue;
    sources += content_of(entry.path());
  }
  const std::string page = text_of_the_page();
  const std::regex name("`([A-Z][A-Za-z0-9]*)\\.\\*`");
  int named = 0;
  for (auto it = std::sregex_iterator(page.begin(), page.end(), name); it != std::sregex_iterator(); ++it) {
    const std::string suite = (*it)[1];
    const bool exists = sources.find("TEST(" + suite + ", ") != std::string::npos ||
                        sources.find("TEST_P(" + suite + ", ") != std::string::npos;
    EXPECT_TRUE(exists) << suite;
    ++named;
  }
  EXPECT_GT(named, 8);
}

TEST(PapersPage, HasEveryTestOfAPrintedError) {
  const auto named = tests_on_the_page();
  for (const auto& name : tests_of_this_program()) {
    if (name.starts_with("Errata")) {
      EXPECT_TRUE(named.contains(name)) << name;
    }
  }
}

}  // namespace
}  // namespace fde::bench
