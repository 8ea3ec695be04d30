#include "raylab/report/structure/structure_trial.h"

#include "raylab/report/decision_trial.h"
#include "raylab/report/structure/wrong_hit.h"

#include <utility>

namespace raylab {

StructureTrial::StructureTrial(StructureWorkload workload)
    : workload_(std::move(workload)), truth_(true_answers(workload_)) {}

CaseRow StructureTrial::row(const StructureMethod& method, const std::string& expected,
                            const std::function<bool(double wrong)>& expects) const {
    Traversal traversal;
    const auto answers = answers_of(*method.make(*workload_.scene), workload_, traversal);
    const double wrong = static_cast<double>(wrong_answers(answers, truth_, workload_.question)) /
                         static_cast<double>(workload_.rays.size());
    CaseRow row{row_title(method.name + ", " + method.number, workload_.name), expected,
                wrong == 0 ? "none wrong" : share_text(wrong) + " wrong", expects(wrong)};
    for (std::size_t i = 0; i < answers.size() && wrong > 0 && !row.example; ++i)
        if (!same_answer(answers[i], truth_[i], workload_.question))
            row.example = wrong_hit(workload_.rays[i], *workload_.scene, workload_.question, answers[i]);
    return row;
}

CaseRow StructureTrial::more_wrong_than(double share, const StructureMethod& method) const {
    return row(method, "fails: more than " + share_text(share) + " wrong", [&](double wrong) { return wrong > share; });
}

CaseRow StructureTrial::never_wrong(const StructureMethod& method) const {
    return row(method, "holds: none wrong", [](double wrong) { return wrong == 0; });
}

CaseRow StructureTrial::shown(const StructureMethod& method) const {
    return row(method, "nothing: shown, not judged", [](double) { return true; });
}

}  // namespace raylab
