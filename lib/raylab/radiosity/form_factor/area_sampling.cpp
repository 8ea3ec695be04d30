#include "raylab/radiosity/form_factor/area_sampling.h"

#include "raylab/radiosity/form_factor/convex_polygon.h"
#include "raylab/radiosity/form_factor/form_factor_density.h"
#include "raylab/radiosity/form_factor/uniform_points.h"
#include "raylab/sampling/even_point.h"
#include "raylab/sampling/sequence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace raylab {

namespace {

// A point of the unit hypercube: two coordinates for either polygon.
using PairPlace = std::array<double, 4>;

std::vector<PairPlace> random_places(int count, RandomSequence random) {
    std::vector<PairPlace> places(static_cast<std::size_t>(count));
    for (PairPlace& place : places)
        for (double& coordinate : place) coordinate = random.next();
    return places;
}

// One place in each cell of a grid of four dimensions, whose sides grow in turn until there are enough cells.
std::vector<PairPlace> jittered_places(int count, RandomSequence random) {
    std::array<int, 4> side{1, 1, 1, 1};
    int cells = 1;
    for (std::size_t d = 0; cells < count; d = (d + 1) % 4) {
        cells = cells / side[d] * (side[d] + 1);
        ++side[d];
    }
    std::vector<PairPlace> places(static_cast<std::size_t>(cells));
    for (int i = 0; i < cells; ++i) {
        int rest = i;
        for (std::size_t d = 0; d < 4; ++d) {
            places[static_cast<std::size_t>(i)][d] = (rest % side[d] + random.next()) / side[d];
            rest /= side[d];
        }
    }
    return places;
}

std::vector<PairPlace> low_discrepancy_places(int count, RandomSequence random) {
    PairPlace shift{};
    for (double& coordinate : shift) coordinate = random.next();
    std::vector<PairPlace> places;
    for (int i = 0; i < count; ++i) places.push_back(even_point<4>(i, shift));
    return places;
}

std::vector<PairPlace> batch_places(const AreaSampling& sampling, int batch) {
    const RandomSequence random(sampling.seed, static_cast<std::uint64_t>(batch));
    const int count = std::max(1, (sampling.pairs + AreaSampling::batches - 1) / AreaSampling::batches);
    if (sampling.pattern == PairPattern::random) return random_places(count, random);
    if (sampling.pattern == PairPattern::low_discrepancy) return low_discrepancy_places(count, random);
    return jittered_places(count, random);
}

}  // namespace

SampledFormFactor sampled_form_factor(std::span<const Vec3d> from, std::span<const Vec3d> to,
                                      const AreaSampling& sampling, const PointVisibility& visible) {
    const UniformPoints senders(from), receivers(to);
    const Vec3d normal = polygon_normal(from), normal_to = polygon_normal(to);
    const auto arriving = [&](const PairPlace& place) {
        const Vec3d p = senders.at(place[0], place[1]), q = receivers.at(place[2], place[3]);
        const double density = form_factor_density(p, normal, q, normal_to);
        return density > 0 ? density * receivers.area() * visible(p, q) : 0;
    };

    double sum = 0, sum_of_squares = 0;
    int pairs = 0;
    std::array<double, AreaSampling::batches> means{};
    for (int batch = 0; batch < AreaSampling::batches; ++batch) {
        const auto places = batch_places(sampling, batch);
        double& mean = means[static_cast<std::size_t>(batch)];
        for (const PairPlace& place : places) mean += arriving(place) / static_cast<double>(places.size());
        sum += mean;
        pairs += static_cast<int>(places.size());
    }
    const double value = sum / AreaSampling::batches;
    for (const double mean : means) sum_of_squares += (mean - value) * (mean - value);
    return {value, std::sqrt(sum_of_squares / (AreaSampling::batches * (AreaSampling::batches - 1))), pairs};
}

}  // namespace raylab
