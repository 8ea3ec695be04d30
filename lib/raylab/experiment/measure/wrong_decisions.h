#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/experiment/measure/method.h"
#include "raylab/geometry/oracle/oracle.h"

#include <cassert>
#include <cstddef>
#include <functional>
#include <ranges>
#include <string>
#include <vector>

// Hit or miss: compares a method's answers with the oracle's.

namespace raylab {

/// The oracle's answer to each query of a workload; an intersection outside the ray's range is a miss.
using Truth = std::vector<oracle::Answer>;

/// Asks the oracle about queries 0, 1, ... in this many threads (0: all cores).
Truth ask_oracle(std::size_t queries, int threads, const std::function<oracle::Answer(std::size_t query)>& ask);

/// A method's answers to a workload, prepared and computed once.
template <class Data, class Query, class Result>
std::vector<Result> answers_of(const Method<Data, Query, Result>& method, const Workload<Data, Query>& workload) {
    std::vector<Result> answers(workload.queries.size());
    const std::any state = method.prepare ? method.prepare(workload.data) : std::any();
    method.answer(state, workload.data, workload.queries, answers);
    return answers;
}

/// Wrong decisions in parts per million. Rays that lie in the surface are counted separately, in `within` only.
struct WrongDecisions {
    double misses = 0, false_hits = 0;
    double within = 0;  // hits of rays that lie in the surface, which should miss
    double all() const { return misses + false_hits; }
};

/// Compares answers that are optionals, where an absent one means "no hit".
template <std::ranges::random_access_range Answers>
WrongDecisions wrong_decisions(const Answers& answers, const Truth& truth) {
    assert(answers.size() == truth.size() && !truth.empty());
    std::size_t misses = 0, false_hits = 0, hits_within = 0, within = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const bool says_hit = answers[i].has_value();
        if (truth[i].hit_kind == oracle::HitKind::within) {
            ++within;
            hits_within += says_hit;
        } else {
            misses += truth[i].hit() && !says_hit;
            false_hits += !truth[i].hit() && says_hit;
        }
    }
    const double million = 1e6 / static_cast<double>(truth.size() - within);
    const double of_all = 1e6 / static_cast<double>(truth.size());
    return {static_cast<double>(misses) * million, static_cast<double>(false_hits) * million,
            static_cast<double>(hits_within) * of_all};
}

/// "none wrong" or "3.4 % wrong (3.1 % missed, 0.3 % false hits)".
std::string in_words(const WrongDecisions& wrong);

/// The verdict of a measurement with these wrong decisions.
Judgement verdict_on(const WrongDecisions& wrong, const Truth& truth);

/// The judge that a measurement calls.
template <std::ranges::random_access_range Answers>
Judgement judge_decisions(const Answers& answers, const Truth& truth) {
    return verdict_on(wrong_decisions(answers, truth), truth);
}

}  // namespace raylab
