#include "io/netcdf_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <type_traits>

#include "io/netcdf.hpp"
#include "io/netcdf_reader.hpp"

namespace photic::io {
namespace {

constexpr const char* group = "continuation";

using Names = std::vector<std::string>;

// The places of the numbers of an element, in the order of the file's last dimension.
constexpr auto itself = [](auto& x) { return std::array{&x}; };
constexpr auto row = [](auto& r) {
  return std::array{&r.photons, &r.batches, &r.rests, &r.will_rest};
};
constexpr auto sums = [](auto& s) { return std::array{&s.x, &s.xx}; };
constexpr auto tail_sums = [](auto& s) {
  auto& [a, b, c, d] = s.power;
  return std::array{&s.low.x, &s.low.xx, &s.origin, &s.photons, &a, &b, &c, &d};
};
constexpr std::size_t tally_fields = 8 + 1;
constexpr auto tally_sums = [](auto& s) {
  std::array<decltype(&s.largest), tally_fields> out{};
  *std::ranges::copy(tail_sums(s.scored), out.begin()).out = &s.largest;
  return out;
};
constexpr std::size_t environment_fields = 2 * 8 + 5;
constexpr auto environment_sums = [](auto& s) {
  std::array<decltype(&s.largest), environment_fields> out{};
  const auto difference = std::ranges::copy(tail_sums(s.echo), out.begin()).out;
  const auto rest = std::ranges::copy(tail_sums(s.difference), difference).out;
  std::ranges::copy(std::array{&s.largest, &s.of_scores.square, &s.of_scores.fourth,
                               &s.of_differences.square, &s.of_differences.fourth},
                    rest);
  return out;
};
constexpr auto octaves = [](auto& counts) {
  std::array<decltype(&counts[0]), tally::score_octaves> out{};
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = &counts[k];
  return out;
};

const std::string of_sums =
    ": sums over the batches of the score and of its square over the photons of the batch";

const std::string of_tail_sums =
    of_sums +
    "; mean score per photon of the first batch that scored, photons of those that did, and sums "
    "of photons times powers 1 to 4 of the distance from that mean";

template <class Visitor, class State>
void describe_run(Visitor& v, State& s) {
  v.count("photons", s.photons);
  v.count("batches", s.batches);
  v.count("collisions", s.collisions);
  v.count("scores", s.scores);
  tally::Operations::each([&](const char* name, auto& number) { v.count(name, number); },
                          s.operations);
  v.count("photons_lost_too_many_events", s.too_many_events);
  v.count("photons_lost_not_finite", s.not_finite);
  tally::Ledger::each(
      [&](const char* name, auto& weight) { v.number(fmt::format("weight_{}", name), weight); },
      s.ledger);
  v.number("weight_excess", s.ledger_excess.x);
  v.number("weight_excess_squares", s.ledger_excess.xx);
  v.number("resting_target", s.resting_target);
}

template <class Visitor, class State>
void describe_tallies(Visitor& v, State& s) {
  v.array("tally_sums", {"tally_cell", "tally_sum"}, s.tallies, tally_sums,
          "cells of the quantities beside echoes, one quantity after the other" + of_tail_sums +
              "; largest single score");
  v.array("tally_octaves", {"tally_cell", "octave"}, s.tally_octaves, octaves,
          "number of their scores by octave of their size");
}

template <class Visitor, class State>
void describe_groups(Visitor& v, State& s) {
  if (s.groups.photons.sums.empty()) return;
  v.array("group_photons", {"batch_group", "telescope", "channel"}, s.groups.photons.sums, itself,
          "photons of a group of batches that a channel was scored in");
  v.array("group_echo_sums", {"batch_group", "telescope", "channel", "gate"}, s.groups.echo.sums,
          itself, "echo in a group of batches: sum of the scores");
  if (!s.groups.environment.sums.empty())
    v.array("group_environment_sums",
            {"batch_group", "telescope", "channel", "gate", "environment"},
            s.groups.environment.sums, itself,
            "echo in the environment, in a group of batches: sum of the scores");
}

template <class Visitor, class State>
void describe_echoes(Visitor& v, State& s, const std::vector<tally::Grid>& grids) {
  const Names cell{"telescope", "channel", "gate"};
  const auto in_cell = [&](const Names& more) {
    Names all = cell;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  v.array("row_counts", {"telescope", "channel", "row_count"}, s.row, row,
          "photons and batches that a channel was scored in, and whether it rests up to the next "
          "look at the target, and after it");
  v.array("echo_sums", in_cell({"tail_sum"}), s.echo, tail_sums, "echo" + of_tail_sums);
  for (std::size_t g = 0; g < grids.size(); ++g) {
    Names more;
    for (const tally::Axis& axis : grids[g].axes) more.push_back(axis.name);
    more.emplace_back("sum");
    v.array(grids[g].name + "_sums", in_cell(more), s.grids[g], sums,
            "echo " + grids[g].long_name + of_sums);
  }
  v.array("order_cut_sum", cell, s.cut_order, itself, "first order cut off: sum of the scores");
  v.array("largest_score", cell, s.largest, itself, "largest single score");
  v.array("score_octaves", in_cell({"walked", "octave"}), s.octaves, octaves,
          "number of scores by octave of their size, 2^-128 to 1; of the bidirectional estimator "
          "apart for paths of no walk, of the laser's walks alone, and with the telescope's");
  if (!s.environment.empty())
    v.array("environment_sums", in_cell({"other_water", "environment_sum"}), s.environment,
            environment_sums,
            "echo in the environment, or tangent of a parameter" + of_tail_sums +
                "; the same of its difference to the scene's echo; largest single score; sums of "
                "squares and fourth powers of single scores, and of their differences");
  if (s.batches == 0) return;
  describe_groups(v, s);
  const Names in_snapshot{"snapshot", "telescope", "channel"};
  v.array("snapshot_photons", in_snapshot, s.snapshot_photons, itself,
          "photons that a channel was scored in when there were 1, 2, 4, 8 … batches");
  v.array("snapshot_batches", in_snapshot, s.snapshot_batches, itself, "batches of those photons");
  v.array("snapshot_echo_sums", {"snapshot", "telescope", "channel", "gate", "sum"},
          s.snapshot_echo, sums, "echo at that time" + of_sums);
}

/// All of a state under its names in the file: for the visitor that writes, and the one that reads.
/// A state to be read into has the extents of what is read.
template <class Visitor, class State>
void describe(Visitor& v, State& s, const std::vector<tally::Grid>& grids) {
  describe_run(v, s);
  if (!s.tallies.empty()) describe_tallies(v, s);
  if (!s.echo.empty()) describe_echoes(v, s, grids);
}

class StateWriter {
 public:
  explicit StateWriter(NetcdfImage& file) : file_(file) {}

  void count(const std::string& name, std::uint64_t value) { file_.add_global(name, value); }
  void number(const std::string& name, double value) { file_.add_global(name, value); }

  template <class Elements, class Fields>
  void array(const std::string& name, const Names& dimensions, const Elements& elements,
             const Fields& fields, const std::string& long_name) {
    using Number = std::remove_cvref_t<decltype(*fields(elements[0])[0])>;
    ZeroedVector<Number> values;
    if (!elements.empty()) values.reserve(elements.size() * fields(elements[0]).size());
    for (const auto& element : elements)
      for (const Number* field : fields(element)) values.push_back(*field);
    file_.add_variable(name, dimensions, std::span<const Number>(values),
                       {{"long_name", long_name}, {"units", "1"}}, Zeros::left_out);
  }

 private:
  NetcdfImage& file_;
};

class StateReader {
 public:
  StateReader(const NetcdfReader& file, std::map<std::string, std::size_t> lengths)
      : file_(file), lengths_(std::move(lengths)) {}

  void count(const std::string& name, std::uint64_t& value) const { value = file_.count(name); }
  void number(const std::string& name, double& value) const { value = file_.number(name); }

  template <class Elements, class Fields>
  void array(const std::string& name, const Names& dimensions, Elements& elements,
             const Fields& fields, const std::string& /*long_name*/) const {
    std::vector<std::size_t> lengths;
    for (const std::string& dimension : dimensions) lengths.push_back(lengths_.at(dimension));
    typename Elements::value_type element{};
    using Number = std::remove_cvref_t<decltype(*fields(element)[0])>;
    const std::vector<Number> values = read<Number>(name, lengths);
    elements.clear();
    for (auto value = values.begin(); value != values.end();) {
      for (Number* field : fields(element)) *field = *value++;
      elements.push_back(element);
    }
  }

 private:
  template <class Number>
  [[nodiscard]] std::vector<Number> read(const std::string& name,
                                         const std::vector<std::size_t>& lengths) const {
    if constexpr (std::is_same_v<Number, double>)
      return file_.numbers(name, lengths);
    else
      return file_.counts(name, lengths);
  }

  const NetcdfReader& file_;
  std::map<std::string, std::size_t> lengths_;
};

void add_dimensions_of_echoes(NetcdfImage& file, const tally::TotalsState& state) {
  file.add_dimension("sum", 2);
  file.add_dimension("row_count", 4);
  file.add_dimension("walked", state.octaves.size() / state.echo.size());
  if (!state.environment.empty()) {
    file.add_dimension("other_water", state.environment.size() / state.echo.size());
    file.add_dimension("environment_sum", environment_fields);
  }
  if (state.batches == 0) return;
  file.add_dimension("snapshot", tally::snapshots_at(state.batches));
  if (!state.groups.photons.sums.empty())
    file.add_dimension("batch_group", tally::groups_of(state.batches));
}

}  // namespace

void add_state(NetcdfImage& file, const tally::TotalsState& state,
               const std::vector<tally::Grid>& grids) {
  file.enter_group(group);
  file.add_global("comment",
                  "what `photic run --continue` starts from: the sums of all whole "
                  "batches, exact to the last bit");
  file.add_dimension("tail_sum", 8);
  file.add_dimension("octave", tally::score_octaves);
  if (!state.tallies.empty()) {
    file.add_dimension("tally_cell", state.tallies.size());
    file.add_dimension("tally_sum", tally_fields);
  }
  if (!state.echo.empty()) add_dimensions_of_echoes(file, state);
  StateWriter writer(file);
  describe(writer, state, grids);
}

tally::TotalsState read_state(const std::string& path, const tally::Shape& shape) {
  NetcdfReader file(path);
  file.expect_result();
  if (file.format() < photic_format)
    file.refuse(fmt::format(
        "written by Photic {} in result format {}; this program continues format {}: start anew",
        file.text("version"), file.format(), photic_format));
  const std::uint64_t photons = file.count("photons");
  if (!file.enter_group(group))
    file.refuse(std::string("a result that no run can continue: it has no group ") + group +
                ", which is lost where another program writes a result again");
  std::map<std::string, std::size_t> lengths{
      {"telescope", shape.telescopes},
      {"channel", shape.channels},
      {"gate", shape.gates},
      {"sum", 2},
      {"row_count", 4},
      {"tail_sum", 8},
      {"walked", shape.techniques},
      {"octave", tally::score_octaves},
      {"other_water", shape.environments},
      {"environment_sum", environment_fields},
      {"tally_cell", tally::cells_of(shape.tallies)},
      {"tally_sum", tally_fields},
      {"snapshot", tally::snapshots_at(file.count("batches"))}};
  const std::size_t groups = tally::groups_of(file.count("batches"));
  lengths["batch_group"] = groups;
  lengths["environment"] = shape.waters();
  for (const tally::Grid& grid : shape.grids)
    for (const tally::Axis& axis : grid.axes) lengths[axis.name] = axis.size();
  const StateReader reader(file, std::move(lengths));
  tally::TotalsState state(shape);
  if (shape.keeps_groups && groups > 0)
    state.groups.each(shape.rows(), shape.cells(), shape.waters(),
                      [&](auto& sums, std::size_t cells) { sums.open(groups - 1, cells); });
  describe(reader, state, shape.grids);
  if (state.photons > photons)
    file.refuse("a damaged result: its state counts more photons than it does");
  return state;
}

}  // namespace photic::io
