#include "raylab/report/page/formula.h"

#include "catch.h"
#include "raylab/base/process.h"

using namespace raylab;

namespace {

bool has_blahtexml() { return !find_program("blahtexml").empty(); }

}  // namespace

TEST_CASE("a formula becomes MathML") {
    if (!has_blahtexml()) {
        WARN("blahtexml is not installed");
        return;
    }
    CHECK(formula_html("a^2", FormulaPlace::in_line) == "<math><msup><mi>a</mi><mn>2</mn></msup></math>");
    CHECK(formula_html("a", FormulaPlace::displayed).starts_with("<math display=\"block\">"));
    CHECK(formula_html("a - b", FormulaPlace::in_line).find(">&#x2212;</mo>") != std::string::npos);
    CHECK_THROWS_WITH(formula_html("\\notacommand x", FormulaPlace::in_line), Catch::Contains("\\notacommand"));
}

TEST_CASE("the number of a displayed formula is its anchor") {
    if (!has_blahtexml()) {
        WARN("blahtexml is not installed");
        return;
    }
    const auto html = equation_html("a = b \\tag{3}\n");
    CHECK(html.find("id=\"eq-3\"") != std::string::npos);
    CHECK(html.find("<span class=\"tag\">(3)</span>") != std::string::npos);
    CHECK(html.find("tag{") == std::string::npos);
    CHECK(equation_html("a = b").find("id=") == std::string::npos);
}

TEST_CASE("formulas are taken out of text and put back, and code and prices are left alone") {
    InlineFormulas formulas;
    const auto marked = formulas.take_from("with $N_a * L_b$ and `$x$`, $5 or $6, ``` $y$ ``` and $\\alpha$.");
    CHECK(marked.find("N_a") == std::string::npos);
    CHECK(marked.find("alpha") == std::string::npos);
    CHECK(marked.find("`$x$`, $5 or $6, ``` $y$ ```") != std::string::npos);
    CHECK(formulas.put_tex_into(marked) == "with N_a * L_b and `$x$`, $5 or $6, ``` $y$ ``` and \\alpha.");
    CHECK_FALSE(InlineFormulas::begins_with_formula(marked));
    CHECK(InlineFormulas::begins_with_formula(formulas.take_from("$a$, $b$: two")));
}

TEST_CASE("a formula is not parted from the full stop behind it and the bracket before it") {
    const auto html = [](const std::string& text) {
        InlineFormulas formulas;
        return formulas.put_into(formulas.take_from(text));
    };
    const std::string x = formula_html("x", FormulaPlace::in_line);
    CHECK(html("Say $x$.") == "Say <span class=\"unparted\">" + x + ".</span>");
    CHECK(html("Say ($x$), too") == "Say <span class=\"unparted\">(" + x + "),</span> too");
    CHECK(html("$x$'s own") == "<span class=\"unparted\">" + x + "'</span>s own");
    CHECK(html("$x$ and $x$") == x + " and " + x);
}

TEST_CASE("a dollar opens a formula only as on GitHub") {
    for (const std::string text : {"$ a$", "$a $", "$a\n\nb$", "$a$1", "$a", "$$a"}) {
        INFO(text);
        InlineFormulas formulas;
        CHECK(formulas.take_from(text) == text);
    }
}
