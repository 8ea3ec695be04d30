#pragma once

#include "raylab/base/number_text.h"
#include "raylab/experiment/measure/wrong_decisions.h"
#include "raylab/report/stability.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raylab {

/// "Moeller-Trumbore, float: edge", the title of a row.
std::string row_title(const std::string& method, const std::string& workload);

/// A workload with its exact answers, from which the rows of a stability case are made.
template <class Data, class Query, class Result>
class DecisionTrial {
public:
    DecisionTrial(Workload<Data, Query> workload, std::vector<Method<Data, Query, Result>> methods, Truth truth)
        : workload_(std::move(workload)), methods_(std::move(methods)), truth_(std::move(truth)) {}

    /// How a query that is decided wrongly is shown. Without it rows have no examples.
    using Show = std::function<CaseExample(const Workload<Data, Query>&, const Query&, TrueAnswer)>;
    void show_wrong_ones(Show show) { show_ = std::move(show); }

    // Each of these makes a row that expects something of the method's decisions; `title` is the method's.
    CaseRow more_wrong_than(double share, const std::string& title) const {
        const auto found = wrong(title);
        return row(title, "fails: more than " + share_text(share) + " wrong", found, found.all() > 1e6 * share);
    }
    CaseRow more_missed_than(double share, const std::string& title) const {
        const auto found = wrong(title);
        return row(title, "fails: more than " + share_text(share) + " missed", found, found.misses > 1e6 * share);
    }
    CaseRow less_wrong_than(double share, const std::string& title) const {
        const auto found = wrong(title);
        return row(title, "holds: less than " + share_text(share) + " wrong", found, found.all() < 1e6 * share);
    }
    CaseRow never_wrong(const std::string& title) const {
        const auto found = wrong(title);
        return row(title, "holds: none wrong", found, found.all() == 0);
    }

    /// A row for a method of which nothing is expected: a student's.
    CaseRow shown(const Method<Data, Query, Result>& method) const {
        const auto found = wrong_decisions(answers_of(method, workload_), truth_);
        return {row_title(method.title(), workload_.name), "nothing: shown, not judged", in_words(found), true};
    }

    const Workload<Data, Query>& workload() const { return workload_; }
    const Truth& truth() const { return truth_; }

    std::vector<Result> answers(const std::string& title) const {
        return answers_of(find_method(methods_, title), workload_);
    }
    WrongDecisions wrong(const std::string& title) const { return wrong_decisions(answers(title), truth_); }

private:
    CaseRow row(const std::string& title, const std::string& expected, const WrongDecisions& found,
                bool as_expected) const {
        CaseRow row{row_title(title, workload_.name), expected, in_words(found), as_expected};
        if (show_ && found.all() > 0) row.example = first_wrong_one(answers(title));
        return row;
    }

    std::optional<CaseExample> first_wrong_one(const std::vector<Result>& answers) const {
        for (std::size_t i = 0; i < answers.size(); ++i)
            if (truth_[i].hit_kind != oracle::HitKind::within && answers[i].has_value() != truth_[i].hit())
                return show_(workload_, workload_.queries[i], truth_[i].hit() ? TrueAnswer::hit : TrueAnswer::miss);
        return std::nullopt;
    }

    Workload<Data, Query> workload_;
    std::vector<Method<Data, Query, Result>> methods_;
    Truth truth_;
    Show show_;
};

}  // namespace raylab
