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

std::string why_not(const std::string& text, const char* column = "y") {
  return message<InputError>([&] { static_cast<void>(parse(text).numbers(column)); });
}

// Seen red: with the check of what follows the number removed ("2 m" was read as 2); with
// isfinite() removed.
TEST(DataTable, NamesThePlaceOfWhatIsNoNumber) {
  for (const char* bad : {"2 m", "nan", "inf", "1e999", "0x10", "1;5", "+-5", "+", "--5", "1,5"})
    expect_contains(why_not("# comment\nx,y\n1,2\n2,\"" + std::string(bad) + "\"\n"),
                    "t.csv:4:3: \"" + std::string(bad) + "\" is not a finite number");
  for (const char* gap : {"", "nan", "NaN", "-nan", "NA"})
    EXPECT_EQ(why_not("x,y\n1,2\n2," + std::string(gap) + "\n"),
              "t.csv:3:3: \"" + std::string(gap) +
                  "\" is not a finite number (fill the gap, or leave the row out)");
}

// Seen red: with the plus left before the number.
TEST(DataTable, ReadsNumbersAsFortranWritesThem) {
  EXPECT_EQ(parse("x\n+0.5\n+.5\n-.5E+01\n+1.E-03\n").numbers("x"),
            (std::vector<double>{0.5, 0.5, -5, 1e-3}));
}

// In Latin-1 the micro sign is a byte that UTF-8 does not begin with. Seen red: without \r alone;
// without Latin-1; without UTF-16 that has its high bytes first.
TEST(DataTable, ReadsTextAsOtherSystemsWriteIt) {
  const auto utf16 = [](const std::string& ascii, bool low_first) {
    std::string out = low_first ? "\xFF\xFE" : "\xFE\xFF";
    for (const char c : ascii) out += low_first ? std::string{c, '\0'} : std::string{'\0', c};
    return out;
  };
  const std::string plain = "# KEY: me\nx,y\n1,2\n3,4\n";
  std::string mac = plain, dos;
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  for (const char c : plain) dos += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& text :
       {plain, mac, dos, "\xEF\xBB\xBF" + dos, utf16(plain, true), utf16(dos, false),
        utf16(mac, true), plain.substr(0, plain.size() - 1)}) {
    const DataTable t = parse(text);
    EXPECT_EQ(t.header("KEY"), "me");
    EXPECT_EQ(t.column_line(), 2);
    EXPECT_EQ(t.numbers("x"), (std::vector<double>{1, 3}));
    EXPECT_EQ(t.numbers("y"), (std::vector<double>{2, 4}));
    EXPECT_EQ(t.place(1, "y"), (std::pair{4, 3}));
  }
  const DataTable latin = parse("# KEY: M\xFCller\nr_\xB5m,y\n1,2\n");
  EXPECT_EQ(latin.header("KEY"), "M\xC3\xBCller");
  EXPECT_EQ(latin.numbers("r_\xC2\xB5m"), (std::vector<double>{1}));
  for (const std::string& no_text :
       {utf16(plain, true).substr(2), std::string("\x89HDF\0\0\0", 7), std::string(1, '\0')})
    EXPECT_EQ(message<InputError>([&] { parse(no_text); }),
              "t.csv:1:1: is not text: it holds bytes of 0 (save it as CSV in UTF-8, not as a "
              "workbook or in UTF-16 without its mark)");
}

// Seen red: with quotes that only toggle, as before: the doubled one was lost in silence.
TEST(DataTable, ReadsQuotesInsideQuotes) {
  const DataTable t = parse("x,name\n1,\"a \"\"b\"\", c\"\n2, \"\"\"d\"\"\" \n\"3\",\"\"\n");
  EXPECT_EQ(t.texts("name"), (std::vector<std::string>{"a \"b\", c", "\"d\"", ""}));
  EXPECT_EQ(t.numbers("x"), (std::vector<double>{1, 2, 3}));
  for (const char* bad : {"5\" pipe", "\"5\" pipe", "\"a\"b\"", "a\"b, c\"d"})
    EXPECT_EQ(message<InputError>([&] { parse("x,y\n1,2\n3," + std::string(bad) + "\n"); }),
              "t.csv:3:3: a double quote inside a text (put the text in double quotes, and write "
              "those inside twice)")
        << bad;
}

// Seen red: with commas alone for separators; with the first of several.
TEST(DataTable, SeesWhatSeparatesColumns) {
  for (const char* text :
       {"x;y\n1;2\n", "x\ty\n1\t2\n", "sep=;\r\nx;y\r\n1;2\r\n", "sep=\t\nx\ty\n1\t2\n",
        "\"x\";\"y\";\"a, b\"\n1;2;\"c, d\"\n", "x;y;a, b\n1;2;3\n", "x,y,a; b\n1,2,3\n",
        "sep=,\nx,y,a; b\n1,2,c; d\n", "x , y\n 1 , 2\n", "x;y\n;\n1;2\n;\n"}) {
    const DataTable t = parse(text);
    EXPECT_EQ(t.numbers("x"), (std::vector<double>{1})) << text;
    EXPECT_EQ(t.numbers("y"), (std::vector<double>{2})) << text;
  }
  EXPECT_EQ(message<InputError>([] { parse("x;y,z\n1,5;2\n"); }),
            "t.csv:1:1: are columns separated by a comma or by a semicolon? (put names that hold "
            "the other one in double quotes)");
  EXPECT_EQ(message<InputError>([] { parse("x;y\n1;2\n1;2;3\n"); }),
            "t.csv:3:1: 3 fields where 2 columns are named (a text with a semicolon needs double "
            "quotes)");
}

// Seen red: with 0,5 between commas read as 0 and 5, and the separator at the end of names only
// left out.
TEST(DataTable, LeavesOutASeparatorThatEndsAllLines) {
  const DataTable t = parse("\"# yield: 0,25\";;\n# lifetime: 2;;\nx;y;\n1,5;2;\n3,5;4;\n");
  EXPECT_EQ(t.columns(), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(t.numbers("y"), (std::vector<double>{2, 4}));
  EXPECT_EQ(t.number_in_header("yield"), 0.25);
  EXPECT_EQ(t.number_in_header("lifetime"), 2);
  EXPECT_EQ(
      message<InputError>([] { parse("x,y\n0,5,\n1,5,\n"); }),
      "t.csv:2:1: 3 fields where 2 columns are named; 1 more line is like it (end the line of "
      "names with a comma, too)");
  EXPECT_EQ(message<InputError>([] { parse("x,y,\n0,5,1\n"); }),
            "t.csv:1:1: the last column has no name, but fields (leave out what ends the line of "
            "names)");
}

// Seen red: with all commas decimal; with points beside them.
TEST(DataTable, ReadsDecimalCommasIfThatIsSure) {
  for (const char separator : {';', '\t'}) {
    const auto table = [&](std::string text) {
      std::replace(text.begin(), text.end(), ';', separator);
      return text;
    };
    const DataTable t = parse(table("x;y;name\n0;0,119;a, b\n+1,5;-1,5e-3;c\n1,234;2;d. e\n"));
    EXPECT_EQ(t.numbers("x"), (std::vector<double>{0, 1.5, 1.234}));
    EXPECT_EQ(t.numbers("y"), (std::vector<double>{0.119, -1.5e-3, 2}));
    EXPECT_EQ(parse(table("x;y\n0.5;1\n1.234;2\n")).numbers("x"),
              (std::vector<double>{0.5, 1.234}));
    EXPECT_EQ(why_not(table("x;y\n1;1,234\n2;12,500\n")),
              "t.csv:2:3: \"1,234\" may have a decimal comma or thousands (write decimal points, "
              "and nothing between thousands)");
    const std::string both = "x;y\n1.234;0,5\n2.500;0,7\n";  // thousands: of metres, say
    for (const char* column : {"x", "y"})
      expect_contains(why_not(table(both), column),
                      "decimal points and decimal commas in one table: \"1.234\" in line 2, "
                      "\"0,5\" in line 2 (write decimal points, and nothing between thousands)");
    for (const char* thousands : {"1.234,5", "1 234,5", "1'234,5", "1.234.567",
                                  "1\xC2\xA0"
                                  "234"})
      EXPECT_EQ(why_not(table("x;y\n1;0,5\n2;" + std::string(thousands) + "\n")),
                "t.csv:3:3: \"" + std::string(thousands) +
                    "\" is not a finite number (leave out what separates thousands, and write a "
                    "decimal point)");
  }
  EXPECT_EQ(
      why_not("x,y\n1,0.5\n2,\"1,234.5\"\n"),
      "t.csv:3:3: \"1,234.5\" is not a finite number (leave out what separates thousands, and "
      "write a decimal point)");
}

// Of n columns between commas with decimal commas, no line reads as one of n. Seen red: with fields
// beyond the last column left out.
TEST(DataTable, NeverReadsDecimalCommasBetweenCommas) {
  std::string text = "angle,p\n";
  for (int i = 0; i < 181; ++i) text += std::to_string(i) + ",0,11" + std::to_string(i) + "\n";
  EXPECT_EQ(message<InputError>([&] { parse(text); }),
            "t.csv:2:1: 3 fields where 2 columns are named; 180 more lines are like it (a number "
            "needs a decimal point, a text with a comma needs double quotes)");
  EXPECT_NE(message<InputError>([] { parse("x\n0,5\n"); }), "");
  EXPECT_NE(message<InputError>([] { parse("x,y\n1,5,2\n"); }), "");
}

// Seen red: with the first of the two.
TEST(DataTable, DoesNotChooseBetweenColumnsOfOneName) {
  EXPECT_EQ(why_not("x,y,y\n1,2,3\n"),
            "t.csv:1:1: column \"y\" appears twice (give each a name of its own; a scene may call "
            "columns by their numbers)");
  EXPECT_EQ(parse("x,y,y\n1,2,3\n").numbers("x"), (std::vector<double>{1}));
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
            "t.csv:2:1: 1 fields where 2 columns are named (separate them by commas, as the names "
            "are)\nt.csv:4:3: a double quote is not closed");
  EXPECT_EQ(why_not("x,y\n1,a\n1,2\n1,b\n"),
            "t.csv:2:3: \"a\" is not a finite number\nt.csv:4:3: \"b\" is not a finite number");
  // Without the names of columns nothing can be said of the rows.
  EXPECT_EQ(message<InputError>([] { parse("x,\"y\n1\n1,2,3\n"); }),
            "t.csv:1:3: a double quote is not closed");
}

// Seen red: without the limit.
TEST(DataTable, DoesNotGoOnAboutAnotherKindOfFile) {
  std::string text = "x,y\n";
  for (int i = 0; i < 1000; ++i) text += "1\n1,2\n";
  const std::string said = message<InputError>([&] { parse(text); });
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 19);
  EXPECT_EQ(message<InputError>([&] { parse(text + "1\n"); }),
            "t.csv:2:1: 1 fields where 2 columns are named; 1000 more lines are like it (separate "
            "them by commas, as the names are)");
  EXPECT_EQ(why_not("x,y\n1,a\n1,b\n1,c\n1,d\n1,2\n"),
            "t.csv:2:3: \"a\" is not a finite number; 3 more lines are like it");
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
  EXPECT_EQ(message<InputError>([] { parse("x,y\n1,2\n1,2,3\n"); }),
            "t.csv:3:1: 3 fields where 2 columns are named (a number needs a decimal point, a text "
            "with a comma needs double quotes)");
  EXPECT_EQ(message<InputError>([] { parse("x,y\n1,\"2\n1,2\n"); }),
            "t.csv:2:3: a double quote is not closed");
  EXPECT_EQ(message<InputError>([] { parse("x,y\n"); }),
            "t.csv:1:1: no table of numbers: no rows of data");
  EXPECT_EQ(message<InputError>([] { parse(""); }),
            "t.csv:1:1: no table of numbers: no rows of data");
  EXPECT_EQ(message<InputError>([] { static_cast<void>(parse("# a\nx,y\n1,2\n").numbers("z")); }),
            "t.csv:2:1: no column \"z\" (there are, between commas: x, y)");
  EXPECT_EQ(message<InputError>([] { static_cast<void>(parse("x,y\n1,2\n").header("SOURCE")); }),
            "t.csv:1:1: no line \"# SOURCE: …\"");
  EXPECT_EQ(message<InputError>([] { DataTable::read("/nowhere/t.csv"); }),
            "/nowhere/t.csv: cannot be read (is the path right, and the file readable?)");
  EXPECT_EQ(message<InputError>([] { DataTable::read("/"); }),
            "/: no regular file (folders, pipes and devices are not read)");
}

}  // namespace
}  // namespace photic::optics
