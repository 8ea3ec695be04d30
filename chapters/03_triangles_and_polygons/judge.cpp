#include "judge.h"

namespace raylab {

Truth truth_of(const TriangleWorkload& workload, int threads) {
    return ask_oracle(workload.queries.size(), threads, [&](std::size_t i) {
        const auto& [ray, triangle] = workload.queries[i];
        return oracle::intersect(in<double>(ray), in<double>(workload.data[triangle]));
    });
}

Truth truth_of(const PolygonWorkload& workload, int threads) {
    std::vector<Shape> shapes(workload.data.begin(), workload.data.end());
    return ask_oracle(workload.queries.size(), threads, [&](std::size_t i) {
        const auto& [ray, polygon] = workload.queries[i];
        return oracle::intersect(in<double>(ray), shapes[polygon]);
    });
}

}  // namespace raylab
