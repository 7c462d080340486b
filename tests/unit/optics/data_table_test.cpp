#include "optics/data_table.hpp"

#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

DataTable parse(const std::string& text) { return DataTable::parse(text, "t.csv"); }

TEST(DataTable, ReadsHeadersColumnsAndQuotedText) {
  const DataTable t = parse(
      "\xEF\xBB\xBF# SOURCE: Author: 1999, page 2\r\n\r\nx, name ,y\r\n1,\"a, "
      "b\",-2e-3\n2.5,c,4\n");
  EXPECT_EQ(t.header("SOURCE"), "Author: 1999, page 2");
  EXPECT_EQ(t.columns(), (std::vector<std::string>{"x", "name", "y"}));
  EXPECT_EQ(t.ascending_numbers("x"), (std::vector<double>{1, 2.5}));
  EXPECT_EQ(t.numbers("y"), (std::vector<double>{-2e-3, 4}));
  EXPECT_EQ(t.texts("name"), (std::vector<std::string>{"a, b", "c"}));
}

// Seen red: with the check of what follows the number removed ("2 m" was read as 2); with
// isfinite() removed.
TEST(DataTable, NamesThePlaceOfWhatIsNoNumber) {
  for (const char* bad : {"2 m", "", "nan", "inf", "1e999", "0x10", "1;5"}) {
    const DataTable t = parse("# comment\nx,y\n1,2\n2," + std::string(bad) + "\n");
    EXPECT_EQ(message<InputError>([&] { static_cast<void>(t.numbers("y")); }),
              "t.csv:4:3: \"" + std::string(bad) + "\" is not a finite number");
  }
}

// Seen red: with greater_equal turned into greater (the repeated 2 passed).
TEST(DataTable, NamesTheRowThatDoesNotAscend) {
  EXPECT_EQ(message<InputError>(
                [] { static_cast<void>(parse("x,y\n1,1\n2,1\n2,1\n").ascending_numbers("x")); }),
            "t.csv:4:1: x 2 is not above the 2 before it (this column must ascend)");
}

// Seen red: with the first one thrown alone.
TEST(DataTable, NamesAllThatCannotBeRead) {
  EXPECT_EQ(message<InputError>([] { parse("x,y\n1\n1,2\n1,\"2\n"); }),
            "t.csv:2:1: 1 fields where 2 columns are named (a text with a comma needs double "
            "quotes)\nt.csv:4:3: a double quote is not closed");
  EXPECT_EQ(message<InputError>([] { static_cast<void>(parse("x\na\n1\nb\n").numbers("x")); }),
            "t.csv:2:1: \"a\" is not a finite number\nt.csv:4:1: \"b\" is not a finite number");
  // Without the names of columns nothing can be said of the rows.
  EXPECT_EQ(message<InputError>([] { parse("x,\"y\n1\n1,2,3\n"); }),
            "t.csv:1:3: a double quote is not closed");
}

// Seen red: without the limit.
TEST(DataTable, DoesNotGoOnAboutAnotherKindOfFile) {
  std::string text = "x,y\n";
  for (int i = 0; i < 1000; ++i) text += "1\n";
  const std::string said = message<InputError>([&] { parse(text); });
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 19);
}

// Seen red: with negative numbers let through.
TEST(DataTable, HasNumbersInItsHeaderToo) {
  const DataTable table = parse("# yield: 0.25\n# lifetime_ns: -1\n# note: much\nx\n1\n");
  EXPECT_EQ(table.number_in_header("yield"), 0.25);
  const auto why_not = [&](const char* key) {
    return message<InputError>([&] { static_cast<void>(table.number_in_header(key)); });
  };
  EXPECT_EQ(why_not("lifetime_ns"),
            "t.csv:2:1: lifetime_ns must be a finite number, not negative, not \"-1\"");
  EXPECT_EQ(why_not("note"), "t.csv:3:1: note must be a finite number, not negative, not \"much\"");
  EXPECT_EQ(why_not("colour"), "t.csv:1:1: no line \"# colour: …\"");
}

TEST(DataTable, NamesOtherFaults) {
  EXPECT_EQ(
      message<InputError>([] { parse("x,y\n1,2\n1,2,3\n"); }),
      "t.csv:3:1: 3 fields where 2 columns are named (a text with a comma needs double quotes)");
  EXPECT_EQ(message<InputError>([] { parse("x,y\n1,\"2\n"); }),
            "t.csv:2:3: a double quote is not closed");
  EXPECT_EQ(message<InputError>([] { parse("x,y\n"); }), "t.csv:1:1: has no rows of data");
  EXPECT_EQ(message<InputError>([] { parse(""); }), "t.csv:1:1: has no rows of data");
  EXPECT_EQ(message<InputError>([] { static_cast<void>(parse("# a\nx,y\n1,2\n").numbers("z")); }),
            "t.csv:2:1: no column \"z\" (there are: x, y)");
  EXPECT_EQ(message<InputError>([] { static_cast<void>(parse("x,y\n1,2\n").header("SOURCE")); }),
            "t.csv:1:1: no line \"# SOURCE: …\"");
  EXPECT_EQ(message<InputError>([] { DataTable::read("/nowhere/t.csv"); }),
            "/nowhere/t.csv: cannot be read (is the path right, and the file readable?)");
  EXPECT_EQ(message<InputError>([] { DataTable::read("/"); }),
            "/: cannot be read (is the path right, and the file readable?)");
}

}  // namespace
}  // namespace photic::optics
