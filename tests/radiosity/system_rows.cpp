#include "raylab/radiosity/system/reciprocity.h"
#include "raylab/radiosity/system/row_sums.h"
#include "raylab/radiosity/system/symmetric_rows.h"

#include "catch.h"
#include "systems.h"

using namespace raylab;

namespace {

// A closed room whose form factors were estimated: each is up to `error` of itself too large or too small.
FormFactors estimated(FormFactors form_factors, double error, std::uint64_t seed) {
    RandomSequence random(seed, 0);
    for (std::size_t i = 0; i < form_factors.patches(); ++i)
        for (double& f : form_factors.row(i)) f *= random.between(1 - error, 1 + error);
    return form_factors;
}

}  // namespace

TEST_CASE("row sums: least, largest and mean") {
    FormFactors form_factors(2);
    form_factors.at(0, 1) = 0.5;
    form_factors.at(1, 0) = 0.25;
    form_factors.at(1, 1) = 0.5;
    const RowSums sums = row_sums(form_factors, 1);
    CHECK(sums.least == 0.5);
    CHECK(sums.largest == 0.75);
    CHECK(sums.mean == 0.625);
    CHECK(row_sums(FormFactors(0), 1).mean == 1);
    for (const double sum : each_row_sum(cube(0).form_factors, 1)) CHECK_THAT(sum, WithinAbs(1, 1e-12));
}

TEST_CASE("contraction is the largest reflectance times row sum, in each channel") {
    RadiositySystem system = with_form_factors_times(cube(0.5), 0.8);
    system.reflectance[3] = {0.1, 0.9, 0.5};
    const Color rate = contraction(system, 1);
    CHECK_THAT(rate.r, WithinAbs(0.4, 1e-12));
    CHECK_THAT(rate.g, WithinAbs(0.72, 1e-12));
}

TEST_CASE("reciprocity is measured: of pairs, and as a share of what a patch sends out") {
    FormFactors form_factors(3);
    form_factors.at(0, 1) = 0.4;
    form_factors.at(1, 0) = 0.1;  // 2 * 0.1 for 1 * 0.4
    form_factors.at(1, 2) = 0.3;
    form_factors.at(2, 1) = 0.15;
    const std::vector<double> areas{1, 2, 4};
    const Reciprocity error = reciprocity_error(form_factors, areas);
    CHECK_THAT(error.largest_relative, WithinAbs(0.5, 1e-12));
    CHECK_THAT(error.largest_share, WithinAbs(0.2, 1e-12));
    CHECK(error.patch == 0);
    CHECK_FALSE(is_reciprocal(error));
    const Reciprocity of_the_second = reciprocity_error(form_factors, std::vector<double>{8, 2, 4});
    CHECK_THAT(of_the_second.largest_share, WithinAbs(1.5, 1e-12));  // 8 * 0.4 for 2 * 0.1
    CHECK(of_the_second.patch == 1);
    CHECK(is_reciprocal(reciprocity_error(any_system(70, 1, 8).form_factors, any_system(70, 1, 8).area)));
}

TEST_CASE("symmetric rows bring rows over 1 to 1 and keep reciprocity") {
    const RadiositySystem system = with_form_factors_times(cube(0.9), 1.02);
    const SymmetricRows rows = symmetric_rows(system.form_factors, system.area, 0, 1);
    CHECK_THAT(rows.before.largest, WithinAbs(1.02, 1e-12));
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j)
            CHECK_THAT(rows.form_factors.at(i, j), WithinAbs(cube(0.9).form_factors.at(i, j), 1e-12));
}

TEST_CASE("symmetric rows keep what looks into the void") {
    const RadiositySystem open = with_form_factors_times(cube(0.9), 0.7);
    const SymmetricRows rows = symmetric_rows(open.form_factors, open.area, 0.01, 1);
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j)
            CHECK_THAT(rows.form_factors.at(i, j), WithinAbs(open.form_factors.at(i, j), 1e-15));
    CHECK(rows.before.mean == rows.after.mean);
}

TEST_CASE("rows of an estimated matrix come to 1 where their stated error says so, and never over it") {
    const RadiositySystem system = sphere({1, 4, 2, 0.5, 3, 3, 7}, 0);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        const FormFactors noisy = estimated(system.form_factors, 0.05, seed);
        const SymmetricRows mended = symmetric_rows(noisy, system.area, 0.05, 1);
        CHECK_THAT(mended.after.least, WithinAbs(1, 1e-10));
        CHECK_THAT(mended.after.largest, WithinAbs(1, 1e-10));
        CHECK(is_reciprocal(reciprocity_error(mended.form_factors, system.area)));
        const SymmetricRows only_cut = symmetric_rows(noisy, system.area, 0, 1);
        CHECK(only_cut.after.largest <= 1 + 1e-12);
        CHECK(is_reciprocal(reciprocity_error(only_cut.form_factors, system.area)));
    }
}

TEST_CASE("rows that cannot all be 1 stay at most 1") {
    FormFactors form_factors(2);  // two patches that see nothing else, of unequal areas
    form_factors.at(0, 1) = 1.02;
    form_factors.at(1, 0) = 0.99;
    const std::vector<double> areas{1, 1.03};
    const SymmetricRows rows = symmetric_rows(form_factors, areas, 0.05, 1);
    CHECK(rows.after.largest <= 1 + 1e-12);
    CHECK(rows.after.least > 0.95);
    form_factors.at(0, 1) = 1.00001;  // nearly: the scales then move on and on
    form_factors.at(1, 0) = 0.99999;
    CHECK(symmetric_rows(form_factors, std::vector<double>{1, 1.00002}, 0.05, 1).after.largest <= 1 + 1e-12);
    CHECK(symmetric_rows(FormFactors(0), {}, 0.05, 1).after.mean == 1);
    const SymmetricRows blind = symmetric_rows(FormFactors(2), areas, 0.05, 1);
    CHECK(blind.after.largest == 0);
}
