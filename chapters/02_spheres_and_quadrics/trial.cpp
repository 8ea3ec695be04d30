#include "trial.h"

#include <fmt/format.h>

namespace raylab {

namespace {

std::string in_words(const WrongDecisions& wrong) {
    if (wrong.all() == 0) return "none wrong";
    return fmt::format("{:.0f} ppm wrong ({:.0f} missed, {:.0f} false hits)", wrong.all(), wrong.misses,
                       wrong.false_hits);
}

std::string per_million(double share) { return fmt::format("{:g} ppm", 1e6 * share); }

}  // namespace

template <class Data, class Query>
CaseRow Trial<Data, Query>::more_wrong_than(double share, const std::string& title) const {
    const WrongDecisions wrong = wrong_decisions(answers(title), truth_);
    return {row_title(title), "fails: more than " + per_million(share) + " wrong", in_words(wrong),
            wrong.all() > 1e6 * share};
}

template <class Data, class Query>
CaseRow Trial<Data, Query>::less_wrong_than(double share, const std::string& title) const {
    const WrongDecisions wrong = wrong_decisions(answers(title), truth_);
    return {row_title(title), "holds: less than " + per_million(share) + " wrong", in_words(wrong),
            wrong.all() < 1e6 * share};
}

template <class Data, class Query>
CaseRow Trial<Data, Query>::never_wrong(const std::string& title) const {
    const WrongDecisions wrong = wrong_decisions(answers(title), truth_);
    return {row_title(title), "holds: none wrong", in_words(wrong), wrong.all() == 0};
}

template <class Data, class Query>
CaseRow Trial<Data, Query>::off_by_more_than(double length, const std::string& title) const {
    const double error = largest_error(answers(title), truth_);
    return {row_title(title), fmt::format("fails: t off by more than {:g}", length),
            fmt::format("off by up to {:.3g}", error), error > length};
}

template <class Data, class Query>
CaseRow Trial<Data, Query>::off_by_less_than(double length, const std::string& title) const {
    const double error = largest_error(answers(title), truth_);
    return {row_title(title), fmt::format("holds: t off by less than {:g}", length),
            fmt::format("off by up to {:.3g}", error), error < length};
}

template <class Data, class Query>
CaseRow Trial<Data, Query>::shown(const MethodType& method) const {
    const Answers given = answers_of(method, workload_);
    const std::string observed = fmt::format("{}, t off by up to {:.3g}", in_words(wrong_decisions(given, truth_)),
                                             largest_error(given, truth_));
    return {row_title(method.title()), "nothing: shown, not judged", observed, true};
}

template class Trial<std::monostate, SphereQuery>;
template class Trial<Quadric, QuadricQuery>;

}  // namespace raylab
