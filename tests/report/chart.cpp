#include "raylab/report/chart/chart.h"

#include "catch.h"
#include "report/on_path.h"

#include "raylab/base/file.h"
#include "raylab/report/chart/axis.h"
#include "raylab/report/chart/decision_chart.h"
#include "raylab/report/chart/gnuplot.h"
#include "raylab/report/chart/tradeoff_chart.h"
#include "raylab/report/chart/tradeoff_panels.h"

#include <stdlib.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <limits>
#include <set>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("raylab_chart_" + std::to_string(getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
};

Measurement row(const std::string& method, const std::string& number, const std::string& workload, double error,
                double time) {
    return {.method = method,
            .number = number,
            .workload = workload,
            .error = error,
            .error_bound = 30,
            .nanoseconds = {time, time * 0.95, time * 1.05},
            .queries = 100'000};
}

Experiment experiment() {
    return {"q",
            "Is it right?",
            "wrong [ppm]",
            {row("a", "float", "one", 500, 5), row("a", "double", "one", 0, 6), row("b", "float", "one", 800, 4),
             row("c", "double", "one", 0, 9)}};
}

const Dot& dot(const Tradeoffs& tradeoffs, const std::string& title) {
    for (const auto& one : tradeoffs.panels.front().dots)
        if (one.name == title) return one;
    throw std::runtime_error("no " + title);
}

std::set<std::string> extensions(const std::vector<fs::path>& files) {
    std::set<std::string> found;
    for (const auto& file : files) {
        CHECK(fs::exists(file));
        found.insert(file.extension());
    }
    return found;
}

}  // namespace

TEST_CASE("an axis holds its values, and a share of it is a place on it") {
    const auto axis = axis_for({3, 3000}, AxisKind::logarithmic, 0.1);
    CHECK_THAT(axis.share(3), WithinAbs(0.1, 1e-12));
    CHECK_THAT(axis.share(3000), WithinAbs(0.9, 1e-12));
    CHECK_THAT(axis.value(axis.share(77)), WithinRel(77.0, 1e-12));
    std::vector<std::string> texts;
    for (const auto& tick : axis.ticks) texts.push_back(tick.text);
    CHECK(texts == std::vector<std::string>{"10", "100", "1 000"});
}

TEST_CASE("an axis survives no values, one value, and values that are none") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const auto kind : {AxisKind::linear, AxisKind::logarithmic})
        for (const auto& values :
             std::vector<std::vector<double>>{{}, {7}, {nan}, {0, -1, 5}, {1e-300, 1e300}, {-3, -3}}) {
            const auto axis = axis_for(values, kind, 0.1);
            CHECK(axis.low < axis.high);
            CHECK(std::isfinite(axis.low));
            CHECK(std::isfinite(axis.high));
            CHECK(axis.ticks.size() < 20);
            if (kind == AxisKind::logarithmic) CHECK(axis.low > 0);
        }
}

TEST_CASE("a short logarithmic axis has more than one number") {
    for (const double low : {2.1, 5.2, 55.0, 85.0, 110.0, 230.0})
        CHECK(marks_with_room(axis_for({low, 2 * low}, AxisKind::logarithmic, 0.06), 220, 14).size() >= 2);
}

TEST_CASE("where there is no room for all marks, the powers of ten stay") {
    const auto axis = axis_for({20, 9000}, AxisKind::logarithmic, 0.1);
    CHECK(marks_with_room(axis, 2000, 14).size() == axis.ticks.size());
    std::vector<std::string> texts;
    for (const auto& tick : marks_with_room(axis, 260, 14)) texts.push_back(tick.text);
    CHECK(texts == std::vector<std::string>{"10", "100", "1 000", "10⁴"});
    CHECK(marks_with_room(axis, 10, 14).size() <= 2);
    CHECK(marks_with_room(axis_for({0, 1e6}, AxisKind::linear, 0.1), 100, 14).size() <= 3);
}

TEST_CASE("powers of ten are written as people write them") {
    CHECK(power_text(0.01) == "0.01");
    CHECK(power_text(500) == "500");
    CHECK(power_text(1000) == "1 000");
    CHECK(power_text(1e6) == "10⁶");
    CHECK(power_text(2e-12) == "2·10⁻¹²");
}

TEST_CASE("no error seen is drawn at its 95 % bound, and marked") {
    const auto tradeoffs = tradeoffs_of(experiment());
    CHECK(dot(tradeoffs, "a, double").error == 30);
    CHECK(dot(tradeoffs, "a, double").kind == Dot::Kind::no_error_seen);
    CHECK(dot(tradeoffs, "a, float").error == 500);
    CHECK(dot(tradeoffs, "a, float").kind == Dot::Kind::error_seen);
}

TEST_CASE("no error and no bound is drawn a decade below all that was seen") {
    Experiment exact{"q", "Q?", "ulp", {row("a", "float", "w", 2, 5), row("b", "float", "w", 0, 6)}};
    for (auto& one : exact.rows) one.error_bound = 0;
    CHECK(dot(tradeoffs_of(exact), "b").error == 0.2);
}

TEST_CASE("the front is marked, and stands first so that its names choose first") {
    const auto dots = tradeoffs_of(experiment()).panels.front().dots;
    REQUIRE(dots.size() == 4);
    CHECK(dots[0].name == "a, double");
    CHECK(dots[1].name == "a, float");
    CHECK(dots[2].name == "b");
    CHECK(dots[2].place == Dot::Place::front);
    CHECK(dots[3].place == Dot::Place::behind);
}

TEST_CASE("a method looks the same in every number, and like no other; `yours` changes nobody's look") {
    auto with_yours = experiment();
    with_yours.rows.insert(with_yours.rows.begin(), row("yours", "double", "one", 1, 1));
    for (const std::string method : {"a", "b", "c"})
        CHECK(style_of(experiment(), method).color == style_of(with_yours, method).color);
    std::set<std::pair<std::string, MarkerStyle::Shape>> looks;
    for (std::size_t i = 0; i < 35; ++i) looks.insert({style_of(i).color, style_of(i).shape});
    looks.insert({style_of_yours().color, style_of_yours().shape});
    CHECK(looks.size() == 36);
}

TEST_CASE("what is no number is left out of the picture and named") {
    auto broken = experiment();
    broken.rows[0].error = std::numeric_limits<double>::quiet_NaN();
    broken.rows[1].nanoseconds.median = 0;
    const auto tradeoffs = tradeoffs_of(broken);
    CHECK(tradeoffs.panels.front().dots.size() == 2);
    CHECK(tradeoffs.left_out == std::vector<std::string>{"a, float on one", "a, double on one"});
}

TEST_CASE("a method swept by its knob is one curve a number; without a knob its numbers are the curve") {
    const auto by_number = tradeoffs_of(experiment()).panels.front();
    REQUIRE(by_number.curves.size() == 1);
    CHECK(by_number.dots[by_number.curves[0][0]].name == "a, float");
    CHECK(by_number.dots[by_number.curves[0][1]].name == "a, double");
    Experiment swept{"q", "Q?", "error", {}};
    for (const std::string number : {"float", "double"})
        for (const int rays : {1, 4, 16}) {
            swept.rows.push_back(row("m", number, "w", 100.0 / rays, rays));
            swept.rows.back().knob = std::to_string(rays) + " rays";
        }
    const auto by_knob = tradeoffs_of(swept).panels.front();
    REQUIRE(by_knob.curves.size() == 2);
    for (const auto& curve : by_knob.curves) CHECK(curve.size() == 3);
}

TEST_CASE("gnuplot gets names as text: quotes doubled, one line, bold words escaped") {
    CHECK(gnuplot_text("it's `x`\n$y") == "'it''s `x` $y'");
    CHECK(gnuplot_bold_text("a_b{c}@'") == "'{/:Bold a\\_b\\{c\\}\\@''}'");
}

TEST_CASE("a chart is data and pictures, whatever its names are and however many") {
    const Folder folder;
    const std::set<std::string> all = {".csv", ".json", ".svg", ".png"};
    auto hostile = experiment();
    hostile.title = "it's \"{/Bold x}\" `touch hacked` <&> \\ %s";
    hostile.rows[0].method = "a'; system('touch hacked') #\nEOD\n";
    CHECK(extensions(write_chart(hostile, folder.path, "hostile")) == all);
    CHECK(read_file(folder.path / "hostile.svg").find("<&>") == std::string::npos);

    Experiment many{"q", "Many?", "wrong [ppm]", {}};
    for (int w = 0; w < 10; ++w)
        for (int m = 0; m < 30; ++m)
            many.rows.push_back(row("method " + std::to_string(m), m % 2 ? "float" : "double", "w" + std::to_string(w),
                                    m % 7 * m, m + 1));
    CHECK(extensions(write_chart(many, folder.path, "many")) == all);
    many.error_axis = "error [ulp]";
    CHECK(extensions(write_chart(many, folder.path, "many")) == all);

    const Experiment one{"q", "One?", "wrong", {row("a", "float", "w", 0, 1)}};
    CHECK(extensions(write_chart(one, folder.path, "one")) == all);
    auto none = one;
    none.rows[0].error = std::numeric_limits<double>::infinity();
    CHECK(extensions(write_chart(none, folder.path, "none")) == all);
}

TEST_CASE("curves are data, a script and pictures, gaps and empty curves included") {
    const Folder folder;
    if (gnuplot_program().empty()) return;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const CurveChart chart{
        "Curves",
        "x",
        "y",
        AxisKind::logarithmic,
        AxisKind::logarithmic,
        {{"a", {1, 10, 100}, {1, nan, 3}}, {"b_{x}", {1, 10}, {2, 0}, {1, 0}, {3, 0}}, {"none", {}, {}}}};
    CHECK(extensions(write_chart(chart, folder.path, "curves")).size() == 5);
    const auto json = nlohmann::json::parse(read_file(folder.path / "curves.json"));
    CHECK(json["curves"][0]["y"][1].is_null());
    const CurveChart nothing{"Nothing", "x", "y", AxisKind::linear, AxisKind::linear, {{"none", {}, {}}}};
    CHECK(extensions(write_chart(nothing, folder.path, "nothing")).size() == 5);
}

TEST_CASE("beyond what was measured a curve is dashed") {
    const Folder folder;
    if (gnuplot_program().empty()) return;
    CurveChart chart{"Curves", "x", "y", AxisKind::linear, AxisKind::linear, {{"a", {1, 10, 100}, {1, 2, 3}}}};
    const auto script = [&] {
        CHECK(extensions(write_chart(chart, folder.path, "curves")).size() == 5);
        return read_file(folder.path / "curves.gp");
    };
    CHECK_THAT(script(), !Catch::Contains("dashtype"));
    chart.curves[0].measured_to = 10;
    CHECK_THAT(script(), Catch::Contains("($1>=10 ? $1 : NaN):2 with lines dashtype 2") &&
                             Catch::Contains("($1<=10 ? $1 : NaN):2 every 1 with points"));
}

TEST_CASE("a gnuplot that does not end is ended, and the message names the picture and the limit") {
    const Folder folder;
    const OnPath gnuplot(folder.path / "programs", "gnuplot", "sleep 77");
    CHECK_THROWS_WITH(
        draw({.width = 100, .height = 100, .script = "plot x", .timeout = 0.2}, folder.path, "a"),
        (folder.path / "a.svg").string() + ": expected a picture, found gnuplot did not end within 0.2 seconds");
    CHECK_FALSE(fs::exists(folder.path / "a.svg"));
}

TEST_CASE("what gnuplot refuses is one line that names the picture, the line and the cause") {
    if (gnuplot_program().empty()) return;
    const Folder folder;
    CHECK_THROWS_WITH(draw({.width = 100, .height = 100, .script = "plot wishful(x)\n"}, folder.path, "a"),
                      (folder.path / "a.svg").string() +
                          ": expected a picture, found gnuplot: exit code 1: line 0: undefined function: wishful");
    CHECK_FALSE(fs::exists(folder.path / "a.svg"));
}

TEST_CASE("without gnuplot there are the data and the script, and no picture") {
    const Folder folder;
    const std::string path = getenv("PATH");
    setenv("PATH", "/nonexistent", 1);
    const CurveChart curve{"C", "x", "y", AxisKind::linear, AxisKind::linear, {{"a", {1, 2}, {1, 2}}}};
    const auto files = write_chart(curve, folder.path, "data");
    setenv("PATH", path.c_str(), 1);
    CHECK(extensions(files) == std::set<std::string>{".csv", ".json", ".gp"});
}

TEST_CASE("the same experiment is the same drawing") {
    CHECK(to_svg(tradeoff_chart(experiment())) == to_svg(tradeoff_chart(experiment())));
    CHECK(to_svg(decision_chart(experiment())) == to_svg(decision_chart(experiment())));
}
