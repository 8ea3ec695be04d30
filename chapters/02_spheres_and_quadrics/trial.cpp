#include "trial.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab {

template <class Data, class Query>
CaseRow Trial<Data, Query>::off_by_more_than(double length, const std::string& title) const {
    const double error = largest_error(this->answers(title), this->truth());
    return {row_title(title, this->workload().name), fmt::format("fails: t off by more than {:g}", length),
            fmt::format("off by up to {:.3g}", error), error > length, first_off_by(length, title)};
}

template <class Data, class Query>
std::optional<CaseExample> Trial<Data, Query>::first_off_by(double length, const std::string& title) const {
    if constexpr (std::same_as<Query, SphereQuery>) {
        const auto given = this->answers(title);
        for (std::size_t i = 0; i < given.size(); ++i) {
            if (!this->truth()[i].hit() || !given[i]) continue;
            const double t = this->truth()[i].t->nearest();
            const SphereQuery& query = this->workload().queries[i];
            if (std::abs(*given[i] - t) > length) return example_of_floor(query.ray, query.sphere, t, *given[i]);
        }
    }
    return std::nullopt;
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
