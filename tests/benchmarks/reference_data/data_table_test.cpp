// SPDX-License-Identifier: MIT
// The text formats of the reference data: CSV of any program, the precision of written numbers, checksums.

#include "fdebench/benchmarks/reference_data/data_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "fdebench/benchmarks/reference_data/table_comparison.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"
#include "support/matchers.hpp"

namespace fde::bench {
namespace {

const std::vector<std::string> header{"t", "y"};
const std::vector<std::vector<std::string>> cells{{"0", "1"}, {"0.5", "-2e-3"}};

TEST(Csv, IsReadAsItWasWritten) {
  const std::string text = to_csv({.columns = header, .rows = cells});
  EXPECT_EQ(text, "t,y\n0,1\n0.5,-2e-3\n");
  const auto table = parse_csv("a.csv", text);
  EXPECT_EQ(table.columns, header);
  EXPECT_EQ(table.rows, cells);
  EXPECT_EQ(table.find("y"), 1U);
  EXPECT_EQ(table.find("z"), std::nullopt);
  EXPECT_EQ(table.place(1, "y"), "a.csv: line 3, column y");
}

class OtherCsv : public testing::TestWithParam<const char*> {};

TEST_P(OtherCsv, IsTheSameTable) {
  const auto table = parse_csv("a.csv", GetParam());
  EXPECT_EQ(table.columns, header);
  EXPECT_EQ(table.rows, cells);
}

INSTANTIATE_TEST_SUITE_P(Csv, OtherCsv,
                         testing::Values("t,y\r\n0,1\r\n0.5,-2e-3\r\n", "t,y\n0,1\n0.5,-2e-3",
                                         "\xEF\xBB\xBFt,y\n0,1\n0.5,-2e-3\n\n\r\n",
                                         "\"t\",\"y\"\n\"0\",1\n0.5,\"-2e-3\"\n",
                                         "t, y\n 0 ,1\n0.5,\t-2e-3 \n"));

TEST(Csv, AQuotedCellMayHoldACommaAndQuotes) {
  EXPECT_THAT(parse_csv("a.csv", "a,b\n\"1,5\",\"say \"\"no\"\"\"\n").rows.at(0),
              ElementsAre("1,5", "say \"no\""));
}

struct Malformed {
  const char *text, *message;
};

class MalformedCsv : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedCsv, IsNamedWithFileAndLine) {
  const auto [text, message] = GetParam();
  EXPECT_THAT([text = text] { parse_csv("a.csv", text); },
              ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
}

INSTANTIATE_TEST_SUITE_P(
    Csv, MalformedCsv,
    testing::Values(Malformed{"", "a.csv: is empty"}, Malformed{"\n\n", "a.csv: is empty"},
                    Malformed{"t,y\n0,1\n2\n", "a.csv: line 3: must have 2 cells, as the header, not 1"},
                    Malformed{"t,y\n0,1,2\n", "a.csv: line 2: must have 2 cells, as the header, not 3"},
                    Malformed{"t,y\n0,1\n\n2,3\n", "a.csv: line 3: must have 2 cells"},
                    Malformed{"t,y,t\n", "a.csv: line 1: column t occurs twice"},
                    Malformed{"t,y\n0,\"1\n", "a.csv: line 2: a quoted cell has no end"}));

struct WrittenNumberCase {
  const char* text;
  int digits, first_place, last_place;
};

class Number : public testing::TestWithParam<WrittenNumberCase> {};

TEST_P(Number, SaysHowPreciselyItIsWritten) {
  const auto [text, digits, first, last] = GetParam();
  const auto number = decimal_precision(text);
  ASSERT_TRUE(number) << text;
  EXPECT_EQ(number->digits, digits) << text;
  EXPECT_EQ(number->first_place, first) << text;
  EXPECT_EQ(number->last_place, last) << text;
}

INSTANTIATE_TEST_SUITE_P(
    WrittenNumbers, Number,
    testing::Values(WrittenNumberCase{"12.50", 4, 1, -2}, WrittenNumberCase{"-0.00120", 3, -3, -5},
                    WrittenNumberCase{"+1e-9", 1, -9, -9}, WrittenNumberCase{"1.25E+3", 3, 3, 1},
                    WrittenNumberCase{"100", 3, 2, 0}, WrittenNumberCase{".5", 1, -1, -1},
                    WrittenNumberCase{"5.", 1, 0, 0}, WrittenNumberCase{"0", 0, 0, 0},
                    WrittenNumberCase{"0.000", 0, -3, -3}, WrittenNumberCase{"0e5", 0, 5, 5}));

TEST(WrittenNumbers, NothingElseIsANumber) {
  for (const auto* text : {"", "-", ".", "1e", "1e+", "nan", "inf", "1.2.3", "1,5", "0x1p3", "1 2", "--1",
                           "1e9999999", "1e2.5", "1d5"})
    EXPECT_FALSE(decimal_precision(text)) << text;
}

// FIPS 180-4: the one-block example, and the empty message.
TEST(Checksums, AreThoseOfTheStandard) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Checksums, AreReadAsTheyWereWritten) {
  const Checksums sums{{"a.csv", sha256("a")}, {"b c/d,e=1.json", sha256("b")}};
  EXPECT_EQ(parse_checksums("SHA256SUMS", write_checksums(sums)), sums);
  EXPECT_EQ(parse_checksums("SHA256SUMS",
                            "BA7816BF8F01CFEA414140DE5DAE2223B00361A396177A9CB410FF61F20015AD *abc\r\n"),
            (Checksums{{"abc", sha256("abc")}}));
}

TEST(Checksums, AMalformedLineIsNamed) {
  for (const auto& line :
       {std::string("abc  file"), sha256("a"), sha256("a") + "  ", sha256("a") + " file"}) {
    EXPECT_THAT([&] { parse_checksums("SHA256SUMS", sha256("b") + "  b\n" + line + "\n"); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("SHA256SUMS: line 2 must be a SHA-256")))
        << line;
  }
}

}  // namespace
}  // namespace fde::bench
