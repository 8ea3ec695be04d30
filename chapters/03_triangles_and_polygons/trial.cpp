#include "trial.h"

namespace raylab {

namespace {

Leaks leaks_of(const TriangleMethod& method, const Shots& shots) {
    return count_leaks(shots, answers_of(method, shots.workload));
}

}  // namespace

TriangleMethod method_called(const std::string& title) { return find_method(ray_triangle_methods(), title); }

std::string in_words(const Leaks& leaks) {
    const std::string none = leaks.none == 0 ? "none leak" : share_text(leaks.none / 1e6) + " leak";
    const std::string many = leaks.many == 0 ? "none hit twice" : share_text(leaks.many / 1e6) + " hit twice";
    return none + ", " + many;
}

Leaks LeakTrial::leaks(const std::string& title) const { return leaks_of(method_called(title), shots_); }

CaseRow LeakTrial::leaks_more_than(double share, const std::string& title) const {
    const auto found = leaks(title);
    return {row_title(title, shots_.workload.name), "fails: more than " + share_text(share) + " leak", in_words(found),
            found.none > 1e6 * share};
}

CaseRow LeakTrial::never_leaks(const std::string& title) const {
    const auto found = leaks(title);
    return {row_title(title, shots_.workload.name), "holds: none leak", in_words(found), found.none == 0};
}

CaseRow LeakTrial::doubles_more_than(double share, const std::string& title) const {
    const auto found = leaks(title);
    return {row_title(title, shots_.workload.name),
            "fails: none leak, but more than " + share_text(share) + " hit twice", in_words(found),
            found.none == 0 && found.many > 1e6 * share};
}

CaseRow LeakTrial::always_one_hit(const std::string& title) const {
    const auto found = leaks(title);
    return {row_title(title, shots_.workload.name), "holds: every ray hits exactly one", in_words(found),
            found.none == 0 && found.many == 0};
}

void show_yours(const ChapterRun& run, const Trial& trial, std::vector<CaseRow>& rows) {
    if (run.slot == ChapterRun::Slot::yours) rows.push_back(trial.shown(your_triangle_method()));
}

void show_yours(const ChapterRun& run, const LeakTrial& trial, std::vector<CaseRow>& rows) {
    if (run.slot != ChapterRun::Slot::yours) return;
    const auto yours = your_triangle_method();
    const auto found = leaks_of(yours, trial.shots());
    rows.push_back(
        {row_title(yours.title(), trial.shots().workload.name), "nothing: shown, not judged", in_words(found), true});
}

}  // namespace raylab
