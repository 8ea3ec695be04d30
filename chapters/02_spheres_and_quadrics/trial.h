#pragma once

#include "case_examples.h"
#include "judge.h"

#include "raylab/report/case_drawings.h"
#include "raylab/report/decision_trial.h"

#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raylab {

/// A workload whose rows expect something of decisions, or of t.
template <class Data, class Query>
class Trial : public DecisionTrial<Data, Query, std::optional<double>> {
public:
    Trial(const Workload<Data, Query>& workload, std::vector<Method<Data, Query, std::optional<double>>> methods,
          int threads)
        : Trial::DecisionTrial(workload, std::move(methods), truth_of(workload, threads)) {
        this->show_wrong_ones([](const auto& all, const Query& query, TrueAnswer truth) {
            if constexpr (std::same_as<Query, SphereQuery>)
                return example_of(query.ray, query.sphere, truth);
            else
                return example_of(query.ray, all.data[query.quadric], truth);
        });
    }

    // Each of these makes a row that expects something of the largest |t - exact t|.
    CaseRow off_by_more_than(double length, const std::string& title) const;
    CaseRow off_by_less_than(double length, const std::string& title) const;

    /// A row for a method of which nothing is expected: a student's.
    CaseRow shown(const Method<Data, Query, std::optional<double>>& method) const;

private:
    std::optional<CaseExample> first_off_by(double length, const std::string& title) const;
};

using SphereTrial = Trial<std::monostate, SphereQuery>;
using QuadricTrial = Trial<Quadric, QuadricQuery>;

}  // namespace raylab
