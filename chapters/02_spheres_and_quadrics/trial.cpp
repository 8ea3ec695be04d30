#include "trial.h"

#include <fmt/format.h>

namespace raylab {

template <class Data, class Query>
CaseRow Trial<Data, Query>::off_by_more_than(double length, const std::string& title) const {
    const double error = largest_error(this->answers(title), this->truth());
    return {row_title(title, this->workload().name), fmt::format("fails: t off by more than {:g}", length),
            fmt::format("off by up to {:.3g}", error), error > length};
}

template <class Data, class Query>
CaseRow Trial<Data, Query>::off_by_less_than(double length, const std::string& title) const {
    const double error = largest_error(this->answers(title), this->truth());
    return {row_title(title, this->workload().name), fmt::format("holds: t off by less than {:g}", length),
            fmt::format("off by up to {:.3g}", error), error < length};
}

template <class Data, class Query>
CaseRow Trial<Data, Query>::shown(const Method<Data, Query, std::optional<double>>& method) const {
    const Answers given = answers_of(method, this->workload());
    const std::string observed =
        fmt::format("{}, t off by up to {:.3g}", in_words(wrong_decisions(given, this->truth())),
                    largest_error(given, this->truth()));
    return {row_title(method.title(), this->workload().name), "nothing: shown, not judged", observed, true};
}

template class Trial<std::monostate, SphereQuery>;
template class Trial<Quadric, QuadricQuery>;

}  // namespace raylab
