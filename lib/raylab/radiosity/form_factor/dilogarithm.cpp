#include "raylab/radiosity/form_factor/dilogarithm.h"

#include <array>
#include <numbers>

namespace raylab {

namespace {

using Complex = std::complex<double>;
constexpr double pi_squared = std::numbers::pi * std::numbers::pi;

// With u = -ln(1 - z) the dilogarithm is the sum of B_n u^(n + 1) / (n + 1)! over Bernoulli's numbers, of which those
// of odd index are 0 from the third on. Where it is used |u| < 1.05, and it converges as (|u| / 2 pi)^n.
Complex by_bernoulli_numbers(const Complex& z) {
    // B_2k / (2k + 1)!
    constexpr std::array<double, 10> coefficients{1.0 / 36,
                                                  -1.0 / 3600,
                                                  1.0 / 211680,
                                                  -1.0 / 10886400,
                                                  1.0 / 526901760,
                                                  -691.0 / 2730 / 6227020800,
                                                  7.0 / 6 / 1307674368000,
                                                  -3617.0 / 510 / 355687428096000,
                                                  43867.0 / 798 / 121645100408832000,
                                                  -174611.0 / 330 / 51090942171709440000.0};
    const Complex u = -std::log(1.0 - z), squared = u * u;
    Complex sum = 0;
    for (std::size_t k = coefficients.size(); k-- > 0;) sum = squared * (sum + coefficients[k]);
    return u * (1.0 + sum) - squared / 4.0;
}

// Inside of the unit circle: by z or, near 1, by 1 - z.
Complex within_unit_circle(const Complex& z) {
    if (z.real() <= 0.5) return by_bernoulli_numbers(z);
    const Complex rest = 1.0 - z;
    if (rest == 0.0) return pi_squared / 6;
    return pi_squared / 6 - std::log(z) * std::log(rest) - by_bernoulli_numbers(rest);
}

}  // namespace

Complex dilogarithm(Complex z) {
    if (std::norm(z) <= 1) return within_unit_circle(z);
    const Complex log = std::log(-z);
    return -pi_squared / 6 - log * log / 2.0 - within_unit_circle(1.0 / z);
}

}  // namespace raylab
