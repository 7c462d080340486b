#include "optics/phase_table_cache.hpp"

#include <fmt/format.h>

#include <atomic>
#include <random>
#include <thread>

#include "optics/phase_between_angles.hpp"
#include "optics/phase_from_table.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

/// Values near each other, as often equal as not.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  /// One of `from` or one of its neighbours among all doubles.
  double near(double from) {
    const int which = below(3);
    return which == 0 ? from : std::nextafter(from, which == 1 ? 10 : -10);
  }
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }

 private:
  std::mt19937 random_;
};

DataTable table_of_angles(Draw& draw) {
  const double first = draw.below(2) == 0 ? 1 : 2;
  const double p = 1 / (4 * pi) * (draw.below(2) == 0 ? 1 : 1.001);
  return DataTable::parse(
      fmt::format("angle_deg,phase_function_per_sr\n0,{0}\n{1},{0}\n180,{0}\n", p, first), "t.csv");
}

Spheres spheres_of(Draw& draw) {
  const SizeDistribution sizes[] = {Junge{draw.near(4), 1e-8, 2e-8},
                                    LogNormal{draw.near(1.5e-8), 1.2, 1e-8, 2e-8},
                                    SizeTable{{1e-8, 2e-8}, {draw.near(1), 1}}};
  return {5e-7, draw.near(1.1), 0, sizes[draw.below(3)]};
}

/// Of any maker, by parameters drawn from few.
PhaseShape drawn(Draw& draw, int depth) {
  switch (draw.below(depth == 0 ? 9 : 10)) {
    case 0:
      return isotropic();
    case 1:
      return rayleigh(draw.near(0.04));
    case 2:
      return raman_phase(draw.near(0.17));
    case 3:
      return henyey_greenstein(draw.near(0.9));
    case 4:
      return fournier_forand(draw.near(1.1), draw.near(3.6));
    case 5:
      return phase_from_table(table_of_angles(draw)).shape;
    case 6: {
      std::vector<double> values(PhaseAngles().degrees().size(), 1);
      values[static_cast<std::size_t>(draw.below(2))] = draw.near(1);
      return phase_between_angles(values).shape;
    }
    case 7:
      return *library().spheres.phase(spheres_of(draw));
    case 8:
      return tabulated(henyey_greenstein(draw.near(0.9)));
    default:
      const double share = draw.below(2) == 0 ? 0.25 : 0.75;
      const PhaseShape a = drawn(draw, depth - 1), b = drawn(draw, depth - 1);
      return draw.below(2) == 0 ? mixture({{share, a}, {1 - share, b}}) : mixture({{1, a}});
  }
}

/// Bit for bit, where a table looks.
bool same(const PhaseShape& a, const PhaseShape& b) {
  if (a.core_mass != b.core_mass) return false;
  for (int i = 1; i <= PhaseView::cells; i += 7)
    if (a.p(PhaseView::edge(i)) != b.p(PhaseView::edge(i))) return false;
  return true;
}

// Seen red, each for itself: with keys that leave out a parameter of each maker (two of Fournier's
// and Forand's three, of which the third follows from the others), and with that of a tabulated
// shape being the shape's own.
TEST(PhaseKey, IsThatOfOneFunction) {
  Draw draw(1);
  std::map<PhaseKey, PhaseShape> known;
  int again = 0;
  for (int i = 0; i < 3000; ++i) {
    const PhaseShape shape = drawn(draw, 2);
    ASSERT_FALSE(shape.key.empty());
    const auto [at, is_new] = known.emplace(shape.key, shape);
    if (is_new) continue;
    ++again;
    EXPECT_TRUE(same(at->second, shape)) << i;
  }
  EXPECT_GT(known.size(), 200U);
  EXPECT_GT(again, 500);
}

TEST(PhaseKey, OfPiecesIsNotThatOfOthers) {
  const std::vector<double> none, one{1}, two{1, 2};
  const auto a = PhaseKey("a").add(one).add(two), b = PhaseKey("a").add(two).add(one);
  EXPECT_NE(a, b);
  EXPECT_NE(PhaseKey("a").add(none), PhaseKey("a"));
  EXPECT_NE(PhaseKey("a").add(0.0), PhaseKey("a").add(-0.0));
  EXPECT_NE(PhaseKey("m").add(PhaseKey("a").add(1)), PhaseKey("m").add(PhaseKey("a")).add(1));
  EXPECT_THROW(PhaseKey("mixture").add(PhaseKey()), ContractViolation);
}

TEST(PhaseKey, IsMissingWhereAPartHasNone) {
  const PhaseShape unknown{[](double) { return 1 / (4 * pi); }, PhaseView::x_core / 2};
  EXPECT_TRUE(unknown.key.empty());
  EXPECT_TRUE(tabulated(unknown).key.empty());
  EXPECT_TRUE(mixture({{0.5, isotropic()}, {0.5, unknown}}).key.empty());
}

TEST(PhaseTableCache, SharesTheTableOfAShape) {
  const PhaseTableCache cache;
  const auto table = cache(henyey_greenstein(0.9));
  EXPECT_EQ(cache(henyey_greenstein(0.9)), table);
  EXPECT_NE(cache(henyey_greenstein(std::nextafter(0.9, 1))), table);
  EXPECT_NE(cache(tabulated(henyey_greenstein(0.9))), table);
  const PhaseTable alone(henyey_greenstein(0.9));
  for (const double x : {1e-9, 0.1, 1.9}) {
    EXPECT_EQ(table->view().value(x), alone.view().value(x));
    EXPECT_EQ(table->view().sample(x / 2), alone.view().sample(x / 2));
  }
}

TEST(PhaseTableCache, DoesNotShareWhatNobodyKnows) {
  const PhaseTableCache cache;
  const PhaseShape unknown{[](double) { return 1 / (4 * pi); }, PhaseView::x_core / 2};
  EXPECT_NE(cache(unknown), cache(unknown));
}

/// A shape that nothing else has, and whose table is quickly made.
PhaseShape number(int i) { return henyey_greenstein(i * 1e-5); }

// Seen red, each for itself: with all kept; with none; with those that somebody has made again.
TEST(PhaseTableCache, KeepsTheLastOnes) {
  const PhaseTableCache cache;
  constexpr int most = PhaseTableCache::most_kept;
  const auto held = cache(number(0));
  std::vector<std::weak_ptr<const PhaseTable>> made{held};
  for (int i = 1; i <= 3 * most; ++i) {
    made.push_back(cache(number(i)));
    (void)cache(number(1));  // asked for again and again
  }
  const auto alive = [](const auto& table) { return !table.expired(); };
  EXPECT_EQ(std::ranges::count_if(made, alive), most + 1);
  EXPECT_TRUE(alive(made[1]) && alive(made.back()) && !alive(made[2]));
  EXPECT_EQ(cache(number(0)), held);
}

// Seen red: with slots that threads do not wait for.
TEST(PhaseTableCache, GivesAllThreadsTheSame) {
  const PhaseTableCache cache;
  constexpr int shapes = 12;
  std::vector<std::vector<std::shared_ptr<const PhaseTable>>> got(8);
  std::atomic<int> ready = 0;
  std::vector<std::jthread> threads;
  for (auto& mine : got)
    threads.emplace_back([&] {
      for (++ready; ready < 8;) std::this_thread::yield();
      for (int i = 0; i < shapes; ++i) mine.push_back(cache(number(i)));
    });
  threads.clear();
  for (const auto& mine : got) EXPECT_EQ(mine, got.front());
}

}  // namespace
}  // namespace photic::optics
