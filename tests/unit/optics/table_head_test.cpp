// Tables as other programs write them: what separates fields, and where the names of columns stand.
#include <fmt/format.h>

#include <algorithm>

#include "optics/data_table.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

DataTable read_table(const std::string& text) { return DataTable::parse(text, "t.dat"); }

std::string refusal_of(const std::string& text, const std::string& column = "sand") {
  return message<InputError>([&] { static_cast<void>(read_table(text).numbers(column)); });
}

/// Three rows of wavelength, sand and mud between these.
std::string sand_rows(const std::string& separator) {
  std::string text;
  for (const char* row : {"400,0.10,0.02", "500,0.14,0.04", "600,0.18,0.06"}) {
    for (const char c : std::string(row)) text += c == ',' ? separator : std::string(1, c);
    text += "\n";
  }
  return text;
}
std::string sand_names(const std::string& separator) {
  return "nm" + separator + "sand" + separator + "mud\n";
}

// Seen red, each for itself: without blanks among the separators; with comments that are never
// names; with blanks before commas in comments; with the header of SeaBASS read as rows; with texts
// above the names refused.
TEST(TableHead, NamesStandInManyPlacesBetweenManySeparators) {
  const std::vector<std::pair<std::string, std::string>> separators{
      {",", "comma"}, {", ", "comma"},  {";", "semicolon"}, {"\t", "tab"},
      {" ", "space"}, {"   ", "space"}, {" \t", "space"}};
  for (const auto& [separator, word] : separators) {
    const std::string seabass =
        "/begin_header\n/investigators=nobody\n! /fields=x,y\n/fields=nm,sand,mud\n"
        "/units=nm,unitless,unitless\n/delimiter=" +
        word + "\n/missing=-999\n/end_header\n";
    for (const std::string& head : std::vector<std::string>{
             sand_names(separator), "# a sand of nobody's\n" + sand_names(separator),
             "# a sand of nobody's\n# " + sand_names(separator) + "#\n# ------\n",
             "#" + sand_names(separator), "! " + sand_names(separator), "# nm sand mud\n",
             "# nm, sand, mud\n", seabass,
             "A sand of nobody's making, of 2020\n\nwith a star for what is not measured\n" +
                 sand_names(separator),
             sand_names(separator) + "\n# a comment below\n"}) {
      std::string dos = head + sand_rows(separator);
      for (auto at = dos.find('\n'); at != std::string::npos; at = dos.find('\n', at + 2))
        dos.insert(at, "\r");
      for (const std::string& text : {head + sand_rows(separator), "\xEF\xBB\xBF" + dos}) {
        SCOPED_TRACE(text);
        const DataTable table = read_table(text);
        EXPECT_EQ(table.columns(), (std::vector<std::string>{"nm", "sand", "mud"}));
        EXPECT_EQ(table.ascending_numbers("nm"), (std::vector<double>{400, 500, 600}));
        EXPECT_EQ(table.numbers("sand"), (std::vector<double>{0.10, 0.14, 0.18}));
        EXPECT_EQ(table.numbers("mud"), (std::vector<double>{0.02, 0.04, 0.06}));
      }
    }
  }
}

// As libRadtran, the USGS's old library and MODTRAN write theirs, in short and with other numbers.
// Seen red: with units below the names taken for a row; with a line of as many words as a row, one
// of which is a number, taken for one.
TEST(TableHead, ReadsTheFormsOfOtherPrograms) {
  const DataTable air = read_table(
      "# An atmosphere of nobody's\n#     z(km)      p(mb)        T(K)    air(cm-3)\n"
      "    50.000  7.97800E-01    270.700  2.13540E+16\n     0.000  1.01300E+03    288.200  "
      "2.54810E+19\n");
  EXPECT_EQ(air.numbers("p(mb)"), (std::vector<double>{0.7978, 1013}));
  EXPECT_EQ(air.place(1, "T(K)"), (std::pair{4, 28}));
  const DataTable mineral = read_table(
      "Digital Library\nSomebody and others 2007, a survey, Data Series.\n\nline 15 title\n"
      "     wavelength    reflectance    standard deviation\n\n(      -1.23e34  indicates a "
      "deleted "
      "number)\n----------------\nA mineral\n       0.500      0.20       0.000000\n       0.600   "
      "   0.25       0.000000\n");
  EXPECT_EQ(mineral.columns(), (std::vector<std::string>(3)));
  EXPECT_EQ(mineral.with({{"r", {"", 2}}}).numbers("r"), (std::vector<double>{0.20, 0.25}));
  const DataTable filter = read_table(
      "Nanometer data of a filter\nCHANNEL   1   CENTER: 532 NM   FWHM: 2 NM\n  530.0  0.0  "
      "18868.\n  532.0  1.0  18797.\n");
  EXPECT_EQ(filter.with({{"t", {"", 2}}}).numbers("t"), (std::vector<double>{0, 1}));
  const DataTable units = read_table("nm sand\nnm -\n400 0.1\n500 0.2\n");
  EXPECT_EQ(units.numbers("sand"), (std::vector<double>{0.1, 0.2}));
  const DataTable wide = read_table("wave length\tgrey sand\n400\t0.1\n500\t0.2\n");
  EXPECT_EQ(wide.numbers("grey sand"), (std::vector<double>{0.1, 0.2}));
}

// Seen red: with tabs that always separate.
TEST(TableHead, TabsMayBeBlanks) {
  EXPECT_EQ(read_table("nm\tsand\n400\t0.1\n500 0.2\n600\t 0.3\n").numbers("sand"),
            (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(read_table("# nm sand\n400\t\t0.1\n500\t\t0.2\n").numbers("sand"),
            (std::vector<double>{0.1, 0.2}));
  // A gap between tabs is a gap.
  expect_contains(refusal_of("nm\tsand\tmud\n400\t\t0.1\n500\t0.2\t0.1\n"),
                  "t.dat:2:5: \"\" is not a finite number");
}

// Seen red: with blanks between which commas are none of numbers.
TEST(TableHead, NumbersBetweenBlanksMayHaveDecimalCommas) {
  EXPECT_EQ(read_table("nm sand\n400 0,1\n500 0,25\n").numbers("sand"),
            (std::vector<double>{0.1, 0.25}));
  expect_contains(refusal_of("nm sand\n400 1,234\n500 2,345\n"),
                  "\"1,234\" may have a decimal comma or thousands");
}

// No row may be lost as a line of names or of text. Seen red, each for itself: with the fields
// of the first row for those of all, where that is one number; with rows that hold numbers alone;
// with a number for the name of a column that is called by its number.
TEST(TableHead, ARowThatIsAmissIsNoText) {
  expect_contains(refusal_of("# nm sand\n400 n/a\n500 0.1\n"),
                  "t.dat:2:5: \"n/a\" is not a finite number");
  expect_contains(refusal_of("# nm sand\nx 0.3\n500 0.1\n", "nm"),
                  "t.dat:2:1: \"x\" is not a finite number");
  expect_contains(refusal_of("# nm sand\n400 no data\n500 0.1\n"),
                  "t.dat:2:1: 3 fields where 2 columns are named (a text with a blank needs double "
                  "quotes)");
  expect_contains(refusal_of("# nm sand\n400\n500 0.1\n"),
                  "t.dat:2:1: 1 fields where 2 columns are named");
  expect_contains(
      refusal_of("nm sand\n400 0.1\n500\n600 0.2\n"),
      "t.dat:3:1: 1 fields where 2 columns are named (a gap between blanks is not seen: "
      "leave the row out, or write commas)");
  expect_contains(refusal_of("nm sand\n400 NaN\n500 0.1\n"),
                  "t.dat:2:5: \"NaN\" is not a finite number (fill the gap, or leave the row out)");
  expect_contains(refusal_of("CHANNEL 1\n400 0.1 1\n500 0.2 1\nCHANNEL 2\n400 0.1 1\n500 0.2 1\n"),
                  "t.dat:4:1: 2 fields where line 2 has 3");
  expect_contains(refusal_of("400,0.1\n500,x\n600,0.1,0.2\n"),
                  "3 fields where line 1 has 2 (a number");
  const DataTable broken = read_table("n/a,0.1\n400,0.2\n");
  expect_contains(message<InputError>([&] {
                    static_cast<void>(broken.with({{"sand", {"", 2}}}));
                  }),
                  "t.dat:1:1: the name of column 2 is a number: is this line a row? (give names "
                  "above it, or call the column by its name, in quotes)");
  EXPECT_EQ(broken.with({{"x", {"0.1", 0}}}).numbers("x"), (std::vector<double>{0.2}));
}

// Seen red: without the check of whole numbers.
TEST(TableHead, DecimalCommasBetweenCommasAreNotTakenForColumns) {
  EXPECT_NE(refusal_of("x;y\n0,5\n1,5\n", "y"), "");
  expect_contains(refusal_of("nm,sand\n400 0.1\n"), "1 fields where 2 columns are named");
  const DataTable table = read_table("400,0,5\n401,0,6\n");
  expect_contains(message<InputError>([&] {
                    static_cast<void>(table.with({{"sand", {"", 2}}}));
                  }),
                  "t.dat:1:1: whole numbers between commas, without names: may these be decimal "
                  "commas? (write decimal points, or the names of columns in the first line)");
  EXPECT_EQ(read_table("400.0,0,5\n401,0,6\n").with({{"x", {"", 3}}}).numbers("x"),
            (std::vector<double>{5, 6}));
}

// Seen red: with the numbers of the header let through.
TEST(TableHead, WhatIsMissingIsNoValue) {
  const std::string head =
      "/begin_header\n/fields=depth,chl\n/delimiter=space\n/missing=-999\n"
      "/below_detection_limit=-888\n/end_header\n";
  for (const char* missing : {"-999", "-999.0", "-888"})
    EXPECT_EQ(refusal_of(head + "0 0.1\n5 " + missing + "\n", "chl"),
              fmt::format("t.dat:8:3: \"{}\" stands for a value that is not known, by the file's "
                          "own header (fill the gap, or leave the row out)",
                          missing));
  EXPECT_EQ(
      refusal_of("/fields=depth,chl,a\n0 0.1\n", "chl"),
      "t.dat:2:1: 2 fields where 3 columns are named (a gap between blanks is not seen: leave "
      "the row out, or write commas)");
}

// Seen red, each for itself: with columns counted from 0; with one column taken twice; with the
// other columns kept.
TEST(ColumnsInAFile, AreCalledByNameOrNumber) {
  const DataTable table = read_table("# nm sand mud sand\n400 0.1 0.2 0.3\n500 0.4 0.5 0.6\n");
  const DataTable by_number = table.with({{"nm", {}}, {"albedo", {"", 4}}, {"zenith", {}}});
  EXPECT_EQ(by_number.columns(), (std::vector<std::string>{"nm", "albedo"}));
  EXPECT_EQ(by_number.numbers("albedo"), (std::vector<double>{0.3, 0.6}));
  EXPECT_EQ(by_number.place(1, "albedo"), (std::pair{3, 13}));
  EXPECT_EQ(table.with({{"albedo", {"mud", 0}}}).numbers("albedo"),
            (std::vector<double>{0.2, 0.5}));
  EXPECT_EQ(table.name_of_column({"", 3}), "mud");
  EXPECT_EQ(read_table("1 2.5\n").name_of_column({"", 2}), "column 2");
  const auto refusal_of = [&](const std::vector<std::pair<std::string, ColumnInFile>>& columns) {
    return message<InputError>([&] { static_cast<void>(table.with(columns)); });
  };
  const std::string there_are = " (there are, between blanks: nm, sand, mud, sand)";
  EXPECT_EQ(refusal_of({{"albedo", {"", 5}}}), "t.dat:1:1: no column 5" + there_are);
  EXPECT_EQ(refusal_of({{"albedo", {"clay", 0}}}), "t.dat:1:1: no column \"clay\"" + there_are);
  EXPECT_EQ(
      refusal_of({{"albedo", {"sand", 0}}}),
      "t.dat:1:1: column \"sand\" appears twice (give each a name of its own; a scene may call "
      "columns by their numbers)");
  EXPECT_EQ(refusal_of({{"nm", {}}, {"albedo", {"", 1}}}),
            "t.dat:1:1: column 1 is named as both nm and albedo (each has a column of its own)");
  EXPECT_EQ(message<InputError>([] { static_cast<void>(read_table("400 0.1\n").numbers("nm")); }),
            "t.dat:1:1: no column \"nm\" (there are 2, between blanks, without names: call them by "
            "their numbers)");
  const DataTable scene = DataTable::of_columns({{"x", {{"1"}}}}, "scene.toml");
  EXPECT_EQ(message<InputError>([&] {
              static_cast<void>(scene.with({{"y", {"", 1}}}));
            }),
            "scene.toml: is no table of text, whose columns could be named");
}

/// What is said where a column is asked for, but for the column itself.
std::string said_of(const std::string& text, const std::string& column) {
  std::string said;
  try {
    static_cast<void>(read_table(text).numbers(column));
  } catch (const InputError& error) {
    said = error.what();
  }
  const std::string asked = fmt::format("no column \"{}\"", column);
  if (const auto at = said.find(asked); at != std::string::npos) said.erase(at, asked.size());
  return said;
}

void expect_nothing_quoted(const std::string& said) {
  for (const char* word : {"secret", "kept", "many", "mine", "12", "1,5", "=", "-----"})
    EXPECT_EQ(said.find(word), std::string::npos) << said;
}

// Seen red, each for itself: with all files quoted; with columns listed and fields quoted of those
// that are no tables; with one column quoted for one number in it.
TEST(TableHead, NothingIsQuotedOfAFileWithoutARowOfNumbers) {
  for (const char* text : {"my secret\n", "my,secret\nis,kept\n", "my;secret,here\nis;kept,well\n",
                           "user:secret:0:0\n", "\"secret\nis\" kept\n", "secret = 5\n",
                           "-----BEGIN secret-----\nc2VjcmV0\n-----END-----\n",
                           "# secret: 1\nsecret secret\n", "/fields=secret,kept\nsecret kept\n"}) {
    SCOPED_TRACE(text);
    for (const char* column : {"albedo", "secret", "kept", "my"}) {
      expect_nothing_quoted(said_of(text, column));
      expect_contains(said_of(text, column), "no table of numbers");
    }
  }
  for (const char* text : {"a secret\nof many words\n12 34 56\nand more\n",
                           "secret,pin\nmine,1234\nyours,5678\n", "secret\tpin\nmine\t1,5\n",
                           "secret;kept\n1,5;secret\n1.5;secret\n", "my secret\n12\nis kept\n"}) {
    SCOPED_TRACE(text);
    for (const char* column : {"albedo", "secret", "pin", "kept"})
      expect_nothing_quoted(said_of(text, column));
  }
  const DataTable header = read_table("# yield: secret\nx,y\n1,a\n");
  EXPECT_EQ(message<InputError>([&] { static_cast<void>(header.number_in_header("yield")); }),
            "t.dat:1:1: yield must be a finite number, not negative");
}

// Seen red: with all names in the message; with letters that move the cursor.
TEST(TableHead, MessagesAreShortAndPlain) {
  std::string names = "x", row = "1";
  for (int i = 1; i < 5000; ++i) names += fmt::format(" c{}", i), row += " 2";
  const std::string said = refusal_of(names + "\n" + row + "\n");
  EXPECT_LT(said.size(), 300U);
  expect_contains(said, "c18, c19 and 4980 more)");
  EXPECT_EQ(read_table(names + "\n" + row + "\n").numbers("c4999"), (std::vector<double>{2}));
  expect_contains(refusal_of("\x1B[2Jx," + std::string(1000, 'y') + "\xC2\x9B\n1,2\n"),
                  "(there are, between commas: ?[2Jx, " + std::string(60, 'y') + "…)");
  expect_contains(refusal_of("x,sand\n1,2\n2,\x1B]0;me\x07\n"),
                  "\"?]0;me?\" is not a finite number");
}

// Whatever stands in a file: a table, or an InputError.
TEST(TableHead, MayBeCutAnywhere) {
  for (const std::string& whole : std::vector<std::string>{
           "/begin_header\n/fields=nm,sand\n/missing=-9\n/end_header\n400 0.1\n500 \"0.2\"\n",
           "\"# a\";\n! b\nText, more\nnm\tsand\n\n400\t0,1\n500 0,2\r\n\"# c\n",
           "sep= \nnm sand\n400 0.1\n", "/\n/=\n=\n#\n!\n\"\n\"\"\n,\n;\n\t\n 1 \n"}) {
    for (std::size_t n = 0; n <= whole.size(); ++n)
      for (std::size_t m = 0; m < 2; ++m) {
        const std::string text = m == 0 ? whole.substr(0, n) : whole.substr(n);
        EXPECT_NO_THROW({
          try {
            static_cast<void>(read_table(text).with({{"x", {"", 1}}}).numbers("x"));
          } catch (const InputError&) {
          }
        }) << text;
      }
  }
}

}  // namespace
}  // namespace photic::optics
