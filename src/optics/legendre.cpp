#include "optics/legendre.hpp"

#include <boost/math/special_functions/legendre.hpp>

#include "core/error.hpp"

namespace photic::optics {
namespace {

/// P_0, P_1, … at 1 - x: upwards by their differences, which keep the digits of a small x.
class Polynomials {
 public:
  explicit Polynomials(double x) : x_(x) {}

  [[nodiscard]] double value() const { return p_; }
  void advance() {
    rise_ = (l_ * rise_ - (2 * l_ + 1) * x_ * p_) / (l_ + 1);
    p_ += rise_;
    l_ += 1;
  }

 private:
  double x_, l_ = 0, p_ = 1, rise_ = 0;  ///< the degree, P_l, P_l - P_(l-1)
};

}  // namespace

GaussRule::GaussRule(int count) {
  expect(count >= 2 && count % 2 == 0, "a quadrature has an even number of nodes");
  const std::vector<double> positive = boost::math::legendre_p_zeros<double>(count);
  const auto add = [&](double x) {
    const double slope = boost::math::legendre_p_prime(count, x);
    node.push_back(x);
    weight.push_back(2 / ((1 - x) * (1 + x) * slope * slope));
  };
  for (auto x = positive.rbegin(); x != positive.rend(); ++x) add(-*x);
  for (const double x : positive) add(x);
}

LegendreSeries::LegendreSeries(const GaussRule& rule, const std::vector<double>& values)
    : coefficient_(rule.node.size(), 0.0) {
  expect(values.size() == rule.node.size(), "a polynomial has a value at every node");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double share = rule.weight[i] * values[i] / 2;
    Polynomials p(1 - rule.node[i]);
    for (double& c : coefficient_) {
      c += share * p.value();
      p.advance();
    }
  }
  for (std::size_t l = 0; l < coefficient_.size(); ++l)
    coefficient_[l] *= 2 * static_cast<double>(l) + 1;
}

double LegendreSeries::at(double x) const {
  Polynomials p(x);
  double sum = 0;
  for (const double c : coefficient_) {
    sum += c * p.value();
    p.advance();
  }
  return sum;
}

}  // namespace photic::optics
