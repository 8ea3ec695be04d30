#pragma once

#include "judge.h"

#include "raylab/report/chapter.h"
#include "raylab/report/stability.h"

#include <string>
#include <vector>

namespace raylab {

/// A workload with its truth: what the rows of a stability case are made from.
template <class Data, class Query>
class Trial {
public:
    using MethodType = Method<Data, Query, std::optional<double>>;

    Trial(Workload<Data, Query> workload, std::vector<MethodType> methods, int threads)
        : workload_(std::move(workload)), methods_(std::move(methods)), truth_(truth_of(workload_, threads)) {}

    // Each expects something of the decisions of the method with this title.
    CaseRow more_wrong_than(double share, const std::string& title) const;
    CaseRow less_wrong_than(double share, const std::string& title) const;
    CaseRow never_wrong(const std::string& title) const;

    // Each expects something of the largest |t - exact t|.
    CaseRow off_by_more_than(double length, const std::string& title) const;
    CaseRow off_by_less_than(double length, const std::string& title) const;

    /// What a method that nothing is expected of does: a student's.
    CaseRow shown(const MethodType& method) const;

private:
    Answers answers(const std::string& title) const { return answers_of(find_method(methods_, title), workload_); }
    std::string row_title(const std::string& title) const { return title + ": " + workload_.name; }

    Workload<Data, Query> workload_;
    std::vector<MethodType> methods_;
    Truth truth_;
};

using SphereTrial = Trial<std::monostate, SphereQuery>;
using QuadricTrial = Trial<Quadric, QuadricQuery>;

}  // namespace raylab
