#include "symptom_search.h"

#include "chance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace raylab::grading {

namespace {

constexpr double digits = 1e-7;
constexpr double seen_in = 0.95;        // of the wrong answers; a second mistake, or rounding, may spoil a few
constexpr double speaks_in = 0.25;      // of the wrong answers at least, where others are only allowed
constexpr double shows_where = 0.75;    // of the cases in which it must show; in some it is right by chance
constexpr double of_right_ones = 0.5;   // of one group: it is said of its cases, and not of wrong answers
constexpr double by_chance = 0.01;      // the wrong answers are all of some kind of case, though it is not to blame
constexpr std::size_t at_least = 4;     // wrong answers: less is no evidence
constexpr std::size_t of_a_group = 10;  // at least, where the cases of one group are judged by themselves

// The library's answers, each computed when it is first asked for.
class RightAnswers {
public:
    RightAnswers(const Exercise& exercise, const std::vector<Case>& cases)
        : exercise_(exercise), cases_(cases), known_(cases.size()) {}

    const std::vector<double>& of(std::size_t index) {
        auto& answer = known_[index];
        if (answer.empty()) {
            answer.assign(exercise_.outputs, std::numeric_limits<double>::quiet_NaN());
            exercise_.reference(cases_[index].input, answer);
        }
        return answer;
    }

private:
    const Exercise& exercise_;
    const std::vector<Case>& cases_;
    std::vector<std::vector<double>> known_;
};

struct Sightings {
    std::size_t seen = 0, allowed = 0, wrong_there = 0, asked_there = 0, first = 0;
    bool shows_in_every_group = true;  // of those cases in which it must show
};

// Whether of the cases in which the symptom must show no group is right as a whole.
bool shows_in_every_group(const std::vector<Case>& cases, const Outcomes& outcomes, const auto& is_there) {
    struct Count {
        std::size_t wrong = 0, asked = 0;
    };
    std::map<std::string, Count> groups;
    for (const std::size_t i : outcomes.wrong)
        if (is_there(i)) ++groups[cases[i].group].wrong, ++groups[cases[i].group].asked;
    for (const std::size_t i : outcomes.right)
        if (is_there(i)) ++groups[cases[i].group].asked;
    return std::ranges::all_of(groups, [](const auto& group) {
        const auto& [wrong, asked] = group.second;
        return asked < of_a_group || wrong > 0;
    });
}

// In how many of some wrong answers the symptom is seen. It is no longer looked for once it cannot be in `share` of
// them.
Sightings sightings(const Symptom& symptom, const std::vector<Case>& cases, std::span<const double> answers,
                    const std::vector<std::size_t>& wrong, RightAnswers& right, double share) {
    Sightings found;
    const double may_miss = (1 - share) * static_cast<double>(wrong.size());
    std::size_t missed = 0;
    for (const std::size_t i : wrong) {
        if (static_cast<double>(missed) > may_miss) return found;
        const auto& truth = right.of(i);
        const WrongAnswer answer{cases[i], truth, answers.subspan(i * truth.size(), truth.size())};
        if ((!symptom.where || symptom.where(cases[i])) && symptom.shows(answer)) {
            if (found.seen == 0) found.first = i;
            ++found.seen;
        } else if (symptom.allows && symptom.allows(answer)) {
            ++found.allowed;
        } else {
            ++missed;
        }
    }
    return found;
}

// How many of all cases it must show in, and how many of them are wrong.
void count_where(Sightings& found, const Symptom& symptom, const std::vector<Case>& cases, const Outcomes& outcomes) {
    const auto is_there = [&](std::size_t i) { return symptom.where(cases[i]); };
    found.wrong_there = static_cast<std::size_t>(std::ranges::count_if(outcomes.wrong, is_there));
    found.asked_there = found.wrong_there + static_cast<std::size_t>(std::ranges::count_if(outcomes.right, is_there));
    found.shows_in_every_group = shows_in_every_group(cases, outcomes, is_there);
}

std::string evidence(const Symptom& symptom, const Sightings& found, std::size_t wrong, const std::string& of) {
    auto text = fmt::format("In {} of {} wrong answers{} {}", found.seen, wrong, of, symptom.words);
    if (symptom.where && found.wrong_there < found.asked_there)
        text += fmt::format(" ({} of {} such cases are wrong)", found.wrong_there, found.asked_there);
    return text + fmt::format("; case {} is one.", found.first);
}

bool is_supported(const Sightings& found, std::size_t wrong, double share, std::size_t least) {
    const auto seen = static_cast<double>(found.seen), all = static_cast<double>(wrong);
    return found.seen >= least && seen >= speaks_in * all && seen + static_cast<double>(found.allowed) >= share * all;
}

bool shows_where_it_must(const Sightings& found) {
    return found.shows_in_every_group &&
           static_cast<double>(found.wrong_there) >= shows_where * static_cast<double>(found.asked_there);
}

// Whether the wrong answers might all be to this kind of case by chance. A symptom that the right answer to such a case
// would show as well speaks of the case alone, as "a coordinate is negative" does; where most cases are so, a few wrong
// ones are no evidence of it. (What is said of all cases is not chance.)
bool may_be_chance(const Symptom& symptom, const Sightings& found, const std::vector<std::size_t>& wrong,
                   const std::vector<Case>& cases, const Outcomes& outcomes, RightAnswers& right) {
    const auto is_of_kind = [&](std::size_t i) { return symptom.shows({cases[i], right.of(i), right.of(i)}); };
    if (!is_of_kind(found.first)) return false;
    const auto count = [&](const std::vector<std::size_t>& some) {
        return static_cast<std::size_t>(std::ranges::count_if(some, is_of_kind));
    };
    const std::size_t of_kind = count(outcomes.wrong) + count(outcomes.right);
    const std::size_t all = outcomes.wrong.size() + outcomes.right.size();
    const std::size_t seen = std::max(found.seen, count(wrong));  // some may only be allowed
    return of_kind < all && chance_of(seen, wrong.size(), of_kind, all) > by_chance;
}

// Of how many of these cases the right answer would show the symptom as well.
double share_of_right_ones(const Symptom& symptom, const std::vector<Case>& cases, const std::vector<std::size_t>& some,
                           RightAnswers& right) {
    const auto shown = std::ranges::count_if(some, [&](std::size_t i) {
        return symptom.shows({cases[i], right.of(i), right.of(i)});
    });
    return static_cast<double>(shown) / static_cast<double>(some.size());
}

// Whether what a group's wrong answers show may be the mistake of all of them: too few of the others must not show it.
// A group's cases are of one kind by themselves, so that a symptom which right answers to them would show as well is no
// evidence, unless it tells where nearly all wrong answers are.
bool may_be_of_all(const Symptom& symptom, const std::vector<Case>& cases, std::span<const double> answers,
                   const std::vector<std::size_t>& of_group, const Outcomes& outcomes, RightAnswers& right) {
    const auto found = sightings(symptom, cases, answers, outcomes.wrong, right, 0);
    const double share = static_cast<double>(found.seen) / static_cast<double>(outcomes.wrong.size());
    if (share_of_right_ones(symptom, cases, of_group, right) < of_right_ones) return share >= speaks_in;
    return symptom.where && share >= shows_where;
}

// What is asked of a symptom: in which share of the wrong answers it is seen, in how many at least, and of which group
// they are.
struct Sought {
    double share;
    std::size_t least;
    std::optional<std::string> group = {};  // absent: of all groups
};

// The first symptom that is seen in these wrong answers as is asked of it, and that no case contradicts, whichever
// group it is of.
std::optional<Found> find_in(std::span<const Symptom> symptoms, const std::vector<Case>& cases,
                             std::span<const double> answers, const std::vector<std::size_t>& wrong,
                             const Outcomes& outcomes, RightAnswers& right, const Sought& sought) {
    const std::string of = sought.group ? " of \"" + *sought.group + "\"" : "";
    for (const auto& symptom : symptoms) {
        auto found = sightings(symptom, cases, answers, wrong, right, sought.share);
        if (!is_supported(found, wrong.size(), sought.share, sought.least)) continue;
        if (symptom.where) count_where(found, symptom, cases, outcomes);
        if (!shows_where_it_must(found)) continue;
        if (sought.group && !may_be_of_all(symptom, cases, answers, wrong, outcomes, right)) continue;
        if (!may_be_chance(symptom, found, wrong, cases, outcomes, right))
            return Found{symptom.hint, evidence(symptom, found, wrong.size(), of), found.first};
    }
    return std::nullopt;
}

}  // namespace

std::vector<Symptom> of_numbers(std::vector<Symptom> symptoms, const std::vector<std::string>& but) {
    const auto is_no_number = [](const WrongAnswer& wrong) {
        return std::ranges::any_of(wrong.given, [](double value) { return std::isnan(value); });
    };
    for (auto& symptom : symptoms) {
        if (std::ranges::find(but, symptom.hint) != but.end()) continue;
        const auto shows = symptom.shows;
        symptom.shows = [=](const WrongAnswer& wrong) { return !is_no_number(wrong) && shows(wrong); };
        symptom.allows = [=, allows = symptom.allows](const WrongAnswer& wrong) {
            return (allows && allows(wrong)) || (is_no_number(wrong) && shows(wrong));
        };
    }
    return symptoms;
}

bool agree(double a, double b) {
    if (std::isinf(a) || std::isinf(b)) return a == b;
    return std::abs(a - b) <= digits * std::max({std::abs(a), std::abs(b), 1e-300});
}

bool agree(std::span<const double> a, std::span<const double> b) {
    double off = 0, size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        off = std::hypot(off, a[i] - b[i]);
        size = std::max(size, std::hypot(a[i], b[i]));
    }
    return off <= digits * size;
}

std::optional<Found> find_symptom(const Exercise& exercise, std::span<const Symptom> symptoms,
                                  const std::vector<Case>& cases, std::span<const double> answers,
                                  const Outcomes& outcomes) {
    RightAnswers right(exercise, cases);
    return find_in(symptoms, cases, answers, outcomes.wrong, outcomes, right,
                   {.share = seen_in, .least = std::min(at_least, outcomes.wrong.size())});
}

std::optional<Found> find_symptom_of_first_group(const Exercise& exercise, const std::vector<Case>& cases,
                                                 std::span<const double> answers, const Outcomes& outcomes) {
    if (outcomes.wrong.empty()) return std::nullopt;
    const auto& group = cases[outcomes.wrong.front()].group;
    auto of_group = outcomes.wrong;
    std::erase_if(of_group, [&](std::size_t i) { return cases[i].group != group; });
    RightAnswers right(exercise, cases);
    return find_in(exercise.symptoms, cases, answers, of_group, outcomes, right,
                   {.share = 1, .least = of_a_group, .group = group});
}

}  // namespace raylab::grading
