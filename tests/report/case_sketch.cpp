#include "raylab/report/case_sketch.h"

#include "catch.h"
#include "raylab/report/page/page_parts.h"

using namespace raylab;

namespace {

CaseSketch two_words() {
    PlaneSketch sketch;
    sketch.words({0, 0}, "a hair");
    return case_sketch("Between < and >.", sketch, {-1, -1}, {1, 1});
}

const CaseRow row{"a method", "holds: always", "so it did", true};

std::string html_of(std::vector<StabilityCase> cases) {
    std::vector<CaseOutcome> outcomes;
    for (const auto& each : with_sketches(std::move(cases), {{"HAIR", two_words}})) outcomes.push_back(run(each));
    return stability_html(outcomes);
}

}  // namespace

TEST_CASE("a case is shown with the sketch of its name, others without") {
    const auto rows = [] { return std::vector{row}; };
    const auto html = html_of({{"BARE", "about", rows}, {"HAIR", "about", rows}});
    CHECK_THAT(html, Catch::Contains("id=\"hair\""));
    CHECK(html.find("thumbnail") > html.find("id=\"hair\""));
    CHECK_THAT(html,
               Catch::Contains("a hair</text>") && Catch::Contains("<figcaption>Between &lt; and &gt;.</figcaption>"));
}

TEST_CASE("an example of a row stands before the case's sketch") {
    const auto rows = [] {
        auto with_example = row;
        with_example.example = {"a ray", {}};
        return std::vector{with_example};
    };
    const auto html = html_of({{"HAIR", "about", rows}});
    const auto example = html.find("a method is wrong about this ray.");
    CHECK(example < html.find("a hair</text>"));
    CHECK(html.find("a hair</text>") != std::string::npos);
}

TEST_CASE("the example is one of a row that fails, where there is one") {
    const auto rows = [] {
        std::vector made(2, row);
        made[0].expected = "nothing: shown, not judged";
        made[1].expected = "fails: more than 1 % wrong";
        made[1].method = "a method that fails";
        for (auto& one : made) one.example = {"a ray", {}};
        return made;
    };
    CHECK_THAT(html_of({{"HAIR", "about", rows}}), Catch::Contains("a method that fails is wrong about this ray."));
}
