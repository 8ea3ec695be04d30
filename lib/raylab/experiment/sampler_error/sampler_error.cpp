#include "raylab/experiment/sampler_error/sampler_error.h"

#include <cmath>
#include <numbers>

namespace raylab {

SquareIntegrand smooth_integrand() {
    return {"smooth", [](double x, double y) { return std::exp(x + y); }, std::pow(std::numbers::e - 1, 2)};
}

SquareIntegrand disc_integrand() {
    return {"disc", [](double x, double y) { return x * x + y * y < 1 ? 1.0 : 0.0; }, std::numbers::pi / 4};
}

SquareIntegrand step_integrand() {
    return {"step", [](double x, double) { return x < 0.37 ? 1.0 : 0.0; }, 0.37};
}

double sampler_rmse(SamplerKind kind, int count, const SquareIntegrand& integrand, int seeds) {
    double squares = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        const Sampler sampler{.kind = kind, .count = count, .seed = static_cast<std::uint64_t>(seed)};
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            constexpr int some_purpose = 5, some_pixel = 3;
            const auto [x, y] = pair(sampler, {.pixel = some_pixel, .index = i}, some_purpose);
            sum += integrand.value(x, y);
        }
        squares += std::pow(sum / count - integrand.truth, 2);
    }
    return std::sqrt(squares / seeds);
}

double sampler_slope(SamplerKind kind, const SquareIntegrand& integrand, int seeds) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int count = 16; count <= 4096; count *= 4) {
        const double at = std::log(count), error = std::log(sampler_rmse(kind, count, integrand, seeds));
        n += 1;
        x += at;
        y += error;
        xx += at * at;
        xy += at * error;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace raylab
