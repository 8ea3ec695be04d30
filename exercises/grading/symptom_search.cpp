#include "symptom_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace raylab::grading {

namespace {

constexpr double digits = 1e-7;
constexpr double seen_in = 0.95;        // of the wrong answers; a second mistake, or rounding, may spoil a few
constexpr double shows_where = 0.75;    // of the cases in which it must show; in some it is right by chance
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
    std::size_t seen = 0, wrong_there = 0, asked_there = 0, first = 0;
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

// In how many wrong answers the symptom is seen. It is no longer looked for once it cannot be in `share` of them.
Sightings sightings(const Symptom& symptom, const std::vector<Case>& cases, std::span<const double> answers,
                    const Outcomes& outcomes, RightAnswers& right, double share) {
    Sightings found;
    const double may_miss = (1 - share) * static_cast<double>(outcomes.wrong.size());
    std::size_t missed = 0;
    const auto is_there = [&](std::size_t i) { return !symptom.where || symptom.where(cases[i]); };
    for (const std::size_t i : outcomes.wrong) {
        if (static_cast<double>(missed) > may_miss) return found;
        ++missed;
        if (!is_there(i)) continue;
        ++found.wrong_there;
        const auto& truth = right.of(i);
        if (!symptom.shows({cases[i], truth, answers.subspan(i * truth.size(), truth.size())})) continue;
        if (found.seen == 0) found.first = i;
        ++found.seen;
        --missed;
    }
    found.asked_there = found.wrong_there;
    if (!symptom.where) return found;
    found.asked_there += static_cast<std::size_t>(std::ranges::count_if(outcomes.right, is_there));
    found.shows_in_every_group = shows_in_every_group(cases, outcomes, is_there);
    return found;
}

std::string evidence(const Symptom& symptom, const Sightings& found, std::size_t wrong, const std::string& of) {
    auto text = fmt::format("In {} of {} wrong answers{} {}", found.seen, wrong, of, symptom.words);
    if (symptom.where && found.wrong_there < found.asked_there)
        text += fmt::format(" ({} of {} such cases are wrong)", found.wrong_there, found.asked_there);
    return text + fmt::format("; case {} is one.", found.first);
}

bool is_supported(const Sightings& found, std::size_t wrong, double share, std::size_t least) {
    return found.shows_in_every_group && found.seen >= least &&
           static_cast<double>(found.seen) >= share * static_cast<double>(wrong) &&
           static_cast<double>(found.wrong_there) >= shows_where * static_cast<double>(found.asked_there);
}

}  // namespace

bool agree(double a, double b) { return std::abs(a - b) <= digits * std::max({std::abs(a), std::abs(b), 1e-300}); }

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
    for (const auto& symptom : symptoms) {
        const auto found = sightings(symptom, cases, answers, outcomes, right, seen_in);
        if (is_supported(found, outcomes.wrong.size(), seen_in, std::min(at_least, outcomes.wrong.size())))
            return Found{symptom.hint, evidence(symptom, found, outcomes.wrong.size(), ""), found.first};
    }
    return std::nullopt;
}

std::optional<Found> find_symptom_of_first_group(const Exercise& exercise, const std::vector<Case>& cases,
                                                 std::span<const double> answers, const Outcomes& outcomes) {
    if (outcomes.wrong.empty()) return std::nullopt;
    const auto& group = cases[outcomes.wrong.front()].group;
    Outcomes of_group = outcomes;
    std::erase_if(of_group.wrong, [&](std::size_t i) { return cases[i].group != group; });
    std::erase_if(of_group.right, [&](std::size_t i) { return cases[i].group != group; });
    RightAnswers right(exercise, cases);
    for (const auto& symptom : exercise.symptoms) {
        const auto found = sightings(symptom, cases, answers, of_group, right, 1);
        if (is_supported(found, of_group.wrong.size(), 1, of_a_group))
            return Found{symptom.hint, evidence(symptom, found, of_group.wrong.size(), " of \"" + group + "\""),
                         found.first};
    }
    return std::nullopt;
}

}  // namespace raylab::grading
