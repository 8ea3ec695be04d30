#include "judge.h"

#include "raylab/base/tiles.h"

#include <fmt/format.h>

namespace raylab {

namespace {

constexpr std::size_t grain = 256;  // queries a piece: milliseconds of rational arithmetic

template <class Ask>
Truth asked(std::size_t count, int threads, const Ask& ask) {
    Truth truth(count);
    for_each_piece(count, grain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const oracle::Answer answer = ask(i);
            truth[i] = is_hit(answer.meeting) && !answer.hit() ? oracle::Meeting::miss : answer.meeting;
        }
    });
    return truth;
}

}  // namespace

Truth truth_of(const TriangleWorkload& workload, int threads) {
    return asked(workload.queries.size(), threads, [&](std::size_t i) {
        const auto& [ray, triangle] = workload.queries[i];
        return oracle::meet(in<double>(ray), in<double>(workload.data[triangle]));
    });
}

Truth truth_of(const PolygonWorkload& workload, int threads) {
    std::vector<Shape> shapes(workload.data.begin(), workload.data.end());
    return asked(workload.queries.size(), threads, [&](std::size_t i) {
        const auto& [ray, polygon] = workload.queries[i];
        return oracle::meet(in<double>(ray), shapes[polygon]);
    });
}

std::string in_words(const WrongDecisions& wrong) {
    if (wrong.all() == 0) return "none wrong";
    return fmt::format("{:.0f} ppm wrong ({:.0f} missed, {:.0f} false hits)", wrong.all(), wrong.misses,
                       wrong.false_hits);
}

}  // namespace raylab
