#include "trial.h"

#include <fmt/format.h>

namespace raylab {

namespace {

std::string percent(double share) { return fmt::format("{:g} %", 100 * share); }

Leaks leaks_of(const TriangleMethod& method, const Shots& shots) {
    return count_leaks(shots, answers_of(method, shots.workload));
}

std::string row_title(const std::string& title, const std::string& workload) { return title + ": " + workload; }

}  // namespace

TriangleMethod method_called(const std::string& title) { return find_method(ray_triangle_methods(), title); }

std::string in_words(const Leaks& leaks) {
    const std::string none = leaks.none == 0 ? "none leak" : fmt::format("{:.0f} ppm leak", leaks.none);
    const std::string many = leaks.many == 0 ? "none hit twice" : fmt::format("{:.0f} ppm hit twice", leaks.many);
    return none + ", " + many;
}

WrongDecisions Trial::wrong(const std::string& title) const {
    const auto answers = answers_of(method_called(title), workload_);
    return wrong_decisions(std::span<const std::optional<TriangleHit>>(answers), truth_);
}

CaseRow Trial::more_wrong_than(double share, const std::string& title) const {
    const auto found = wrong(title);
    return {row_title(title, workload_.name), "fails: more than " + percent(share) + " wrong", in_words(found),
            found.all() > 1e6 * share};
}

CaseRow Trial::less_wrong_than(double share, const std::string& title) const {
    const auto found = wrong(title);
    return {row_title(title, workload_.name), "holds: less than " + percent(share) + " wrong", in_words(found),
            found.all() < 1e6 * share};
}

CaseRow Trial::more_missed_than(double share, const std::string& title) const {
    const auto found = wrong(title);
    return {row_title(title, workload_.name), "fails: more than " + percent(share) + " missed", in_words(found),
            found.misses > 1e6 * share};
}

CaseRow Trial::never_wrong(const std::string& title) const {
    const auto found = wrong(title);
    return {row_title(title, workload_.name), "holds: none wrong", in_words(found), found.all() == 0};
}

Leaks LeakTrial::leaks(const std::string& title) const { return leaks_of(method_called(title), shots_); }

CaseRow LeakTrial::leaks_more_than(double share, const std::string& title) const {
    const auto found = leaks(title);
    return {row_title(title, shots_.workload.name), "fails: more than " + percent(share) + " leak", in_words(found),
            found.none > 1e6 * share};
}

CaseRow LeakTrial::never_leaks(const std::string& title) const {
    const auto found = leaks(title);
    return {row_title(title, shots_.workload.name), "holds: none leak", in_words(found), found.none == 0};
}

CaseRow LeakTrial::doubles_more_than(double share, const std::string& title) const {
    const auto found = leaks(title);
    return {row_title(title, shots_.workload.name), "none leak, but more than " + percent(share) + " hit twice",
            in_words(found), found.none == 0 && found.many > 1e6 * share};
}

CaseRow LeakTrial::always_one_hit(const std::string& title) const {
    const auto found = leaks(title);
    return {row_title(title, shots_.workload.name), "holds: every ray hits exactly one", in_words(found),
            found.none == 0 && found.many == 0};
}

void show_yours(const ChapterRun& run, const Trial& trial, std::vector<CaseRow>& rows) {
    if (run.slot != ChapterRun::Slot::yours) return;
    const auto yours = your_triangle_method();
    const auto answers = answers_of(yours, trial.workload());
    const auto wrong = wrong_decisions(std::span<const std::optional<TriangleHit>>(answers), trial.truth());
    rows.push_back(
        {row_title(yours.title(), trial.workload().name), "nothing: shown, not judged", in_words(wrong), true});
}

void show_yours(const ChapterRun& run, const LeakTrial& trial, std::vector<CaseRow>& rows) {
    if (run.slot != ChapterRun::Slot::yours) return;
    const auto yours = your_triangle_method();
    const auto found = leaks_of(yours, trial.shots());
    rows.push_back(
        {row_title(yours.title(), trial.shots().workload.name), "nothing: shown, not judged", in_words(found), true});
}

}  // namespace raylab
