#pragma once

#include "raylab/geometry/predicate/accuracy.h"
#include "raylab/number/dyadic.h"
#include "raylab/number/fine_enclosure.h"

#include <optional>
#include <variant>

// A question is asked in doubles first, in double-doubles where these leave it open, and in exact numbers where those
// do too: the decision, or a t good enough to be rounded to float.

namespace raylab {

struct Undecided {};
struct Miss {};
using FilterVerdict = std::variant<Undecided, Miss, Candidate>;

/// A hit whose t is not accurate is still open.
inline FilterVerdict if_accurate(const FilterVerdict& verdict) {
    const auto* candidate = std::get_if<Candidate>(&verdict);
    return candidate && !is_accurate(candidate->t, candidate->t_error) ? Undecided{} : verdict;
}

inline std::optional<Candidate> candidate_of(const FilterVerdict& verdict) {
    if (const auto* candidate = std::get_if<Candidate>(&verdict)) return *candidate;
    return std::nullopt;
}

/// The answer to a question that doubles left open; ask.operator()<T>() asks it in numbers of type T.
template <class Ask>
[[gnu::noinline]] std::optional<Candidate> decide_beyond_doubles(const Ask& ask, DecisionCounts& decisions) {
    const FilterVerdict fine = if_accurate(ask.template operator()<FineEnclosure>());
    if (!std::holds_alternative<Undecided>(fine)) return candidate_of(fine);
    ++decisions.exact;
    return candidate_of(ask.template operator()<Dyadic>());
}

}  // namespace raylab
