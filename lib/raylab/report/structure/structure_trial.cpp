#include "raylab/report/structure/structure_trial.h"

#include "raylab/report/decision_trial.h"

#include <utility>

namespace raylab {

StructureTrial::StructureTrial(StructureWorkload workload)
    : workload_(std::move(workload)), truth_(true_answers(workload_)) {}

double StructureTrial::wrong_share(const StructureMethod& method) const {
    Traversal traversal;
    const auto answers = answers_of(*method.make(*workload_.scene), workload_, traversal);
    return static_cast<double>(wrong_answers(answers, truth_, workload_.question)) /
           static_cast<double>(workload_.rays.size());
}

CaseRow StructureTrial::row(const StructureMethod& method, const std::string& expected, double wrong,
                            bool as_expected) const {
    return {row_title(method.name + ", " + method.number, workload_.name), expected,
            wrong == 0 ? "none wrong" : share_text(wrong) + " wrong", as_expected};
}

CaseRow StructureTrial::more_wrong_than(double share, const StructureMethod& method) const {
    const double wrong = wrong_share(method);
    return row(method, "fails: more than " + share_text(share) + " wrong", wrong, wrong > share);
}

CaseRow StructureTrial::never_wrong(const StructureMethod& method) const {
    const double wrong = wrong_share(method);
    return row(method, "holds: none wrong", wrong, wrong == 0);
}

CaseRow StructureTrial::shown(const StructureMethod& method) const {
    return row(method, "nothing: shown, not judged", wrong_share(method), true);
}

}  // namespace raylab
