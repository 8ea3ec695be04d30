#include "raylab/experiment/measure/wrong_decisions.h"

#include "raylab/base/number_text.h"
#include "raylab/base/tiles.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

Truth ask_oracle(std::size_t queries, int threads, const std::function<oracle::Answer(std::size_t)>& ask) {
    constexpr std::size_t grain = 256;  // queries in a piece of work: milliseconds of rational arithmetic
    Truth truth(queries);
    for_each_piece(queries, grain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            truth[i] = ask(i);
            if (!truth[i].hit() && truth[i].hit_kind != oracle::HitKind::within)
                truth[i].hit_kind = oracle::HitKind::miss;
        }
    });
    return truth;
}

std::string in_words(const WrongDecisions& wrong) {
    if (wrong.all() == 0) return "none wrong";
    return fmt::format("{} wrong ({} missed, {} false hits)", share_text(wrong.all() / 1e6),
                       share_text(wrong.misses / 1e6), share_text(wrong.false_hits / 1e6));
}

Judgement verdict_on(const WrongDecisions& wrong, const Truth& truth) {
    // The rule of three: where none of N is wrong, the share of wrong ones is below 3/N with a confidence of 95 %.
    Judgement verdict{.error = wrong.all(),
                      .error_bound = 3e6 / static_cast<double>(truth.size()),
                      .counts = {{"missed [ppm]", wrong.misses}, {"false hits [ppm]", wrong.false_hits}}};
    if (std::ranges::count(truth, oracle::HitKind::within, &oracle::Answer::hit_kind) > 0)
        verdict.counts["hits in the plane [ppm]"] = wrong.within;
    return verdict;
}

}  // namespace raylab
