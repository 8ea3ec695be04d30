#include "judge.h"

#include "raylab/experiment/measure/quantile.h"
#include "raylab/geometry/quadric.h"

#include <algorithm>
#include <cmath>

namespace raylab {

Truth truth_of(const SphereWorkload& workload, int threads) {
    return ask_oracle(workload.queries.size(), threads, [&](std::size_t i) {
        return oracle::intersect(in<double>(workload.queries[i].ray), in<double>(workload.queries[i].sphere));
    });
}

Truth truth_of(const QuadricWorkload& workload, int threads) {
    std::vector<Shape> shapes;
    for (const Quadric& quadric : workload.data) shapes.push_back(as_shape(quadric));
    return ask_oracle(workload.queries.size(), threads, [&](std::size_t i) {
        return oracle::intersect(in<double>(workload.queries[i].ray), shapes[workload.queries[i].quadric]);
    });
}

TErrors t_errors(std::span<const std::optional<double>> answers, const Truth& truth, const std::string& number) {
    constexpr double double_ulps_in_a_float_ulp = 0x1p29;
    TErrors errors;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (!truth[i].hit() || !answers[i]) continue;
        const bool is_float = number == "float";
        const double own =
            is_float ? truth[i].t->error_in_ulp(cast<float>(*answers[i])) : truth[i].t->error_in_ulp(*answers[i]);
        errors.own_ulps.push_back(own);
        errors.float_ulps.push_back(is_float ? own : own / double_ulps_in_a_float_ulp);
    }
    std::ranges::sort(errors.own_ulps);
    std::ranges::sort(errors.float_ulps);
    return errors;
}

double largest_error(std::span<const std::optional<double>> answers, const Truth& truth) {
    double largest = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        if (truth[i].hit() && answers[i]) largest = std::max(largest, std::abs(*answers[i] - truth[i].t->nearest()));
    return largest;
}

Judgement judge_t(std::span<const std::optional<double>> answers, const Truth& truth, const std::string& number) {
    const TErrors errors = t_errors(answers, truth, number);
    const auto at = [](const std::vector<double>& ulps, double share) {
        return ulps.empty() ? 0 : quantile(ulps, share);  // empty where both never say hit
    };
    return {.error = at(errors.float_ulps, 0.99),
            .counts = {{"own ulp, median", at(errors.own_ulps, 0.5)},
                       {"own ulp, 99 %", at(errors.own_ulps, 0.99)},
                       {"own ulp, max", at(errors.own_ulps, 1)}}};
}

}  // namespace raylab
