#include "cases.h"

#include "case_examples.h"
#include "shadow_rays.h"

#include "raylab/base/number_text.h"
#include "raylab/experiment/measure/wrong_decisions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace raylab::shadows {

namespace {

const Situation& situation(const std::vector<Situation>& all, const std::string& name) {
    for (const auto& one : all)
        if (one.name == name) return one;
    assert(!"a situation with this name");
    std::abort();
}

std::string share(double ppm) { return ppm == 0 ? "none" : share_text(ppm / 1e6); }

/// One situation with its exact answers.
class Trial {
public:
    Trial(const ChapterRun& run, const std::string& name)
        : methods_(shadow_methods(run)),
          judged_(shadow_workload(situation(situations(), name), run.sized<std::size_t>(100'000, 10'000), run)) {}

    CaseRow acne_above(double smallest, const std::string& title) const {
        return with_example(fails(title, "acne", wrong(title).acne, smallest), title, Shade::lit);
    }
    CaseRow lost_above(double smallest, const std::string& title) const {
        return with_example(fails(title, "lost contact shadows", wrong(title).lost_contact, smallest), title,
                            Shade::blocked);
    }
    CaseRow never_wrong(const std::string& title) const {
        const auto found = wrong(title);
        return {row(title), "holds: no acne, no lost contact shadow",
                fmt::format("acne: {}, lost: {}", share(found.acne), share(found.lost_contact)), found.all() == 0};
    }
    CaseRow shown() const {
        const auto found = wrong_shadows(methods_.back(), judged_);
        return {row(methods_.back().title()), "nothing: shown, not judged",
                fmt::format("acne: {}, lost: {}", share(found.acne), share(found.lost_contact)), true};
    }

private:
    WrongShadows wrong(const std::string& title) const { return wrong_shadows(find_method(methods_, title), judged_); }
    std::string row(const std::string& title) const { return title + ": " + judged_.workload.name; }
    CaseRow fails(const std::string& title, const std::string& what, double seen, double smallest) const {
        return {row(title), fmt::format("fails: {} above {}", what, share(smallest)),
                fmt::format("{}: {}", what, share(seen)), seen > smallest};
    }

    // The first question with this truth that is answered wrongly. Only shadow rays of the tracer have a start.
    CaseRow with_example(CaseRow row, const std::string& title, Shade truth) const {
        const auto all = starts();
        const auto start = std::ranges::find_if(all, [&](const auto& one) { return one.name + ", float" == title; });
        if (start == all.end()) return row;
        const auto answers = answers_of(find_method(methods_, title), judged_.workload);
        for (std::size_t i = 0; i < answers.size() && !row.example; ++i)
            if (judged_.truth[i] == truth && answers[i] != truth)
                row.example = example_of(judged_.workload.data.front(), *start, judged_.workload.queries[i], truth);
        return row;
    }

    std::vector<ShadowMethod> methods_;
    JudgedWorkload judged_;
};

// Adds the rows that every situation must have, and the student's function where there is one.
std::vector<CaseRow> with_strong(std::vector<CaseRow> rows, const std::vector<const Trial*>& trials,
                                 const ChapterRun& run) {
    for (const Trial* trial : trials) {
        rows.push_back(trial->never_wrong("error-bounded + skip, float"));
        if (run.is_yours("in_shadow"))
            rows.push_back(trial->shown());
        else
            rows.push_back(trial->never_wrong("along the normal, double"));
    }
    return rows;
}

std::vector<CaseRow> acne(const ChapterRun& run) {
    const Trial metre(run, "a metre"), kilometre(run, "a kilometre"), away(run, "1 km away");
    return with_strong(
        {metre.acne_above(1e4, "none, O + t d, float"), metre.acne_above(1e4, "none, on the surface, float"),
         kilometre.acne_above(1e3, "fixed 1e-4, O + t d, float"), kilometre.acne_above(100, "fixed 1e-4, float"),
         away.acne_above(100, "fixed 1e-4, float")},
        {&metre, &kilometre, &away}, run);
}

std::vector<CaseRow> contact(const ChapterRun& run) {
    const Trial metre(run, "a metre"), millimetre(run, "a millimetre"), away(run, "1 km away");
    return with_strong({metre.lost_above(1e4, "fixed 1e-3, float"), millimetre.lost_above(1e4, "fixed 1e-4, float"),
                        millimetre.lost_above(1e5, "fixed 1e-3, float"), away.lost_above(1e4, "scaled 1e-5, float")},
                       {&metre, &millimetre, &away}, run);
}

// Doubles are no remedy: a sphere's t loses as many digits as the square of the eye's distance has (chapter 02), and an
// error larger than the offset gives acne.
std::vector<CaseRow> far_eye(const ChapterRun& run) {
    const Trial trial(run, "far eye");
    std::vector<CaseRow> rows{trial.acne_above(1e3, "fixed 1e-4, O + t d, float"),
                              trial.acne_above(1e4, "none, O + t d, float"),
                              trial.never_wrong("error-bounded + skip, float")};
    rows.push_back(run.is_yours("in_shadow") ? trial.shown() : trial.acne_above(100, "along the normal, double"));
    return rows;
}

std::vector<CaseRow> skip_alone(const ChapterRun& run) {
    const Trial trial(run, "a metre");
    return with_strong({trial.acne_above(100, "none + skip, float")}, {&trial}, run);
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun& run) {
    const auto of = [&run](std::vector<CaseRow> (*rows)(const ChapterRun&)) {
        return [run, rows] { return rows(run); };
    };
    return {{"ACNE",
             "A shadow ray hits the surface that it leaves: scenes of a metre, of a kilometre, and a "
             "kilometre away.",
             of(acne)},
            {"CONTACT",
             "What stands on a floor, or hovers a ten-thousandth above it, must shade it: a metre, a "
             "millimetre, away.",
             of(contact)},
            {"FAR-EYE", "Seen from kilometres away: the point O + t d is off by what t is off.", of(far_eye)},
            {"SKIP-ALONE",
             "The surface itself is skipped, its neighbours and round surfaces are "
             "not.",
             of(skip_alone)}};
}

}  // namespace raylab::shadows
