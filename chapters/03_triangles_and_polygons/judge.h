#pragma once

#include "polygon_workloads.h"

#include "raylab/geometry/oracle.h"
#include "raylab/report/measure.h"
#include "raylab/sampling/ray_triangle_workloads.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <string>
#include <vector>

// What is wrong with a method's answers, against the oracle's.

namespace raylab {

/// What the oracle says of each query, a hit outside the ray's range being a miss.
using Truth = std::vector<oracle::Meeting>;

/// From all threads (0) or some.
Truth truth_of(const TriangleWorkload& workload, int threads);
Truth truth_of(const PolygonWorkload& workload, int threads);

inline bool is_hit(oracle::Meeting meeting) {
    return meeting == oracle::Meeting::interior || meeting == oracle::Meeting::boundary;
}

/// Wrong decisions in parts per million. Rays within the plane are a class apart: they count in `within` only.
struct WrongDecisions {
    double misses = 0, false_hits = 0;
    double within = 0;  // hits of rays that lie in the plane, which should miss
    double all() const { return misses + false_hits; }
};

/// "none wrong" or "1200 ppm wrong (1000 missed, 200 false hits)".
std::string in_words(const WrongDecisions& wrong);

/// One method's answers to one workload.
template <class Data, class Query, class Result>
std::vector<Result> answers_of(const Method<Data, Query, Result>& method, const Workload<Data, Query>& workload) {
    std::vector<Result> answers(workload.queries.size());
    const std::any state = method.prepare ? method.prepare(workload.data) : std::any();
    method.answer(state, workload.data, workload.queries, answers);
    return answers;
}

/// `Result` is an optional: absent, the method says "no hit".
template <class Result>
WrongDecisions wrong_decisions(std::span<const Result> answers, const Truth& truth) {
    assert(answers.size() == truth.size() && !truth.empty());
    std::size_t misses = 0, false_hits = 0, hits_within = 0, within = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const bool says_hit = answers[i].has_value();
        if (truth[i] == oracle::Meeting::within) {
            ++within;
            hits_within += says_hit;
        } else {
            misses += is_hit(truth[i]) && !says_hit;
            false_hits += !is_hit(truth[i]) && says_hit;
        }
    }
    const double million = 1e6 / static_cast<double>(truth.size() - within);
    const double of_all = 1e6 / static_cast<double>(truth.size());
    return {static_cast<double>(misses) * million, static_cast<double>(false_hits) * million,
            static_cast<double>(hits_within) * of_all};
}

/// The judge that a measurement asks.
template <class Result>
Verdict judge_decisions(std::span<const Result> answers, const Truth& truth) {
    const WrongDecisions wrong = wrong_decisions(answers, truth);
    // The rule of three: where none of N is wrong, fewer than 3/N are, with a confidence of 95 %.
    Verdict verdict{.error = wrong.all(),
                    .error_bound = 3e6 / static_cast<double>(truth.size()),
                    .counts = {{"missed [ppm]", wrong.misses}, {"false hits [ppm]", wrong.false_hits}}};
    if (std::ranges::count(truth, oracle::Meeting::within) > 0)
        verdict.counts["hits in the plane [ppm]"] = wrong.within;
    return verdict;
}

}  // namespace raylab
