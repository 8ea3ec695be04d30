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

CaseExample LeakTrial::example(std::size_t shot) const {
    const auto& [name, about, triangles, queries] = shots_.workload;
    const Ray& ray = queries[shots_.first[shot]].ray;
    std::vector<TriangleOf<double>> asked;
    std::string numbers;
    for (auto i = shots_.first[shot]; i < shots_.first[shot + 1]; ++i) {
        asked.push_back(in<double>(triangles[queries[i].triangle]));
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(queries[i].triangle);
    }
    return {in_words(ray) + ", triangles " + numbers + " of the mesh",
            seen_along(in<double>(ray), asked, "In truth it hits one or more of them.")};
}

CaseRow LeakTrial::row(const std::string& title, const std::string& expected, const Expects& expects,
                       Leak shown) const {
    const auto answers = answers_of(method_called(title), shots_.workload);
    const auto found = count_leaks(shots_, answers);
    CaseRow row{row_title(title, shots_.workload.name), expected, in_words(found), expects(found)};
    if (const auto shot = first_leak(shots_, answers, shown)) row.example = example(*shot);
    return row;
}

CaseRow LeakTrial::leaks_more_than(double share, const std::string& title) const {
    return row(
        title, "fails: more than " + share_text(share) + " leak",
        [&](const Leaks& found) { return found.none > 1e6 * share; }, Leak::none);
}

CaseRow LeakTrial::never_leaks(const std::string& title) const {
    return row(
        title, "holds: none leak", [](const Leaks& found) { return found.none == 0; }, Leak::none);
}

CaseRow LeakTrial::doubles_more_than(double share, const std::string& title) const {
    return row(
        title, "fails: none leak, but more than " + share_text(share) + " hit twice",
        [&](const Leaks& found) { return found.none == 0 && found.many > 1e6 * share; }, Leak::many);
}

CaseRow LeakTrial::always_one_hit(const std::string& title) const {
    return row(
        title, "holds: every ray hits exactly one",
        [](const Leaks& found) { return found.none == 0 && found.many == 0; }, Leak::none);
}

void show_yours(const ChapterRun& run, const Trial& trial, std::vector<CaseRow>& rows) {
    if (run.is_yours("triangle_hit")) rows.push_back(trial.shown(your_triangle_method()));
}

void show_yours(const ChapterRun& run, const LeakTrial& trial, std::vector<CaseRow>& rows) {
    if (!run.is_yours("triangle_hit")) return;
    const auto yours = your_triangle_method();
    const auto found = leaks_of(yours, trial.shots());
    rows.push_back(
        {row_title(yours.title(), trial.shots().workload.name), "nothing: shown, not judged", in_words(found), true});
}

}  // namespace raylab
