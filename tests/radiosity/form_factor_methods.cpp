#include "catch.h"
#include "radiosity/polygons.h"

#include "raylab/radiosity/form_factor/form_factor_methods.h"

#include <map>
#include <set>

using namespace raylab;

TEST_CASE("every method, at its greatest effort, knows two squares ten sides apart to half a percent") {
    constexpr double pixel =
        0.05;  // the square is 26 pixels wide in the hemicube, and each border is one pixel off at most
    const auto [from, to] = parallel_pair(1, 1, 10);
    for (const FormFactorMethod& method : form_factor_methods()) {
        INFO(method.name);
        const auto answer = method.answer(from, to, method.efforts.back());
        REQUIRE(answer);
        CHECK_THAT(answer->value, WithinRel(0.00316205683875760, method.name == "hemicube" ? pixel : 0.005));
        CHECK((answer->standard_error > 0) == (method.name.starts_with("area")));
    }
}

TEST_CASE("methods are told apart by their names, and name a source") {
    std::set<std::string> names;
    for (const FormFactorMethod& method : form_factor_methods()) {
        CHECK(names.insert(method.name).second);
        CHECK_FALSE(method.source.empty());
        CHECK(method.effort.empty() == (method.efforts.size() == 1));
        CHECK(std::ranges::is_sorted(method.efforts));
    }
}

TEST_CASE("a method's title counts its effort") {
    CHECK(form_factor_method_named("contour").title(1) == "contour, 1 point a side");
    CHECK(form_factor_method_named("contour").title(6) == "contour, 6 points a side");
    CHECK(form_factor_method_named("area").effort_text(1) == "1 pair");
    CHECK(form_factor_method_named("area").effort_text(16) == "16 pairs");
    CHECK(form_factor_method_named("polygon").title(1) == "polygon");
}

TEST_CASE("more effort helps where a method has any") {
    const auto [from, to] = parallel_pair(1, 1, 1);
    for (const FormFactorMethod& method : form_factor_methods()) {
        if (method.effort.empty() || method.name == "hemicube") continue;  // it knows no better than its centre
        INFO(method.name);
        const auto error = [&](int effort) {
            return std::abs(method.answer(from, to, effort)->value - 0.199824895698387);
        };
        CHECK(error(method.efforts.back()) < 0.2 * error(method.efforts.front()));
    }
}
