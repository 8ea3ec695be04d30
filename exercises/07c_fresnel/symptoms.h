#pragma once

#include "symptom.h"
#include "truth.h"

#include <algorithm>
#include <cmath>
#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::fresnel_share {

inline Arguments of(const Case& question) { return arguments(question.input); }
inline bool is_total(const Case& question) { return sine_behind(of(question)) >= 1; }

/// The two amplitudes, with any cosine behind the surface.
struct Amplitudes {
    double s, p;
};
inline Amplitudes amplitudes(const Arguments& g, double behind) {
    const double a = g.ior_before * g.cosine, b = g.ior_behind * behind, c = g.ior_behind * g.cosine,
                 d = g.ior_before * behind;
    return {(a - b) / (a + b), (c - d) / (c + d)};
}
inline Amplitudes amplitudes(const Arguments& g) {
    const auto sine = static_cast<double>(sine_behind(g));
    return amplitudes(g, std::sqrt(1 - sine * sine));
}
inline double mean_square(const Amplitudes& a) { return (a.s * a.s + a.p * a.p) / 2; }
inline double head_on(const Arguments& g) {
    const double r = (g.ior_before - g.ior_behind) / (g.ior_before + g.ior_behind);
    return r * r;
}
inline double schlick(const Arguments& g, double cosine) {
    return head_on(g) + (1 - head_on(g)) * std::pow(1 - cosine, 5);
}

/// Whether light gets through and this is not its share.
inline bool is_another(double share, const Case& question) {
    return !is_total(question) && std::abs(share - mean_square(amplitudes(of(question)))) > 1e-6;
}

/// The share is this one, wherever light gets through. Elsewhere many formulas give no number, this one among them.
inline Symptom instead(const std::string& hint, const std::string& words, double (*other)(const Arguments&)) {
    return {hint, words, [other](const WrongAnswer& w) { return std::abs(w.given[0] - other(of(w.question))) <= 1e-7; },
            [other](const Case& question) { return is_another(other(of(question)), question); },
            [other](const WrongAnswer& w) {
                const double value = other(of(w.question));
                return std::isnan(value) ? !std::isfinite(w.given[0]) : std::abs(w.given[0] - value) <= 1e-7;
            }};
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"total_reflection", "all light is reflected, and you give no number",
         [](const WrongAnswer& w) { return is_total(w.question) && std::isnan(w.given[0]); }, is_total});
    // Along the surface many a formula gives 1 by itself.
    add({"total_is_all", "all light is reflected, and you give another share than 1",
         [](const WrongAnswer& w) { return is_total(w.question) && !std::isnan(w.given[0]); },
         [](const Case& q) { return is_total(q) && of(q).cosine > 0; },
         [](const WrongAnswer& w) { return is_total(w.question); }});
    add({"total_too_early",
         "light gets out of the denser medium, and you say that all is reflected",
         [](const WrongAnswer& w) {
             return !is_total(w.question) && w.given[0] == 1 && of(w.question).ior_before > of(w.question).ior_behind;
         },
         {},
         [](const WrongAnswer& w) {
             return w.given[0] == 1 && of(w.question).ior_before == of(w.question).ior_behind;
         }});
    const auto is_total_turned = [](const Case& q) {
        const auto g = of(q);
        return g.cosine > 0 && !is_total(q) && sine_behind(Arguments{g.cosine, g.ior_behind, g.ior_before}) >= 1;
    };
    add({"indices", "into the denser medium you say that all is reflected",
         [is_total_turned](const WrongAnswer& w) { return is_total_turned(w.question) && w.given[0] == 1; },
         is_total_turned, [](const WrongAnswer& w) { return is_total(w.question); }});
    const auto one_angle = [](const Arguments& g, double index) {  // the critical angle of this index, for all media
        const double sine = std::sqrt(1 - g.cosine * g.cosine);
        return g.ior_before > g.ior_behind && sine > 1 / index;
    };
    for (const double index : {1.5, 1.33, 1.52})
        add({"one_critical_angle", "you say that all is reflected, or do not, by one and the same angle for all media",
             [one_angle, index](const WrongAnswer& w) {
                 const bool is_kept = one_angle(of(w.question), index);
                 return is_kept != is_total(w.question) && (is_kept ? w.given[0] == 1 : !std::isfinite(w.given[0]));
             },
             [one_angle, index](const Case& q) { return one_angle(of(q), index) != is_total(q); }});
    add(instead("one_polarization", "you give the share of one polarisation",
                [](const Arguments& g) { return amplitudes(g).s * amplitudes(g).s; }));
    add(instead("one_polarization", "you give the share of one polarisation",
                [](const Arguments& g) { return amplitudes(g).p * amplitudes(g).p; }));
    add(instead("not_squared", "you give the mean of the amplitudes' sizes",
                [](const Arguments& g) { return (std::abs(amplitudes(g).s) + std::abs(amplitudes(g).p)) / 2; }));
    add(instead("not_squared", "you give the size of the amplitudes' mean",
                [](const Arguments& g) { return std::abs(amplitudes(g).s + amplitudes(g).p) / 2; }));
    add(instead("not_squared", "you give the mean of the amplitudes",
                [](const Arguments& g) { return (amplitudes(g).s + amplitudes(g).p) / 2; }));
    add(instead("mean", "you give the sum of both shares",
                [](const Arguments& g) { return 2 * mean_square(amplitudes(g)); }));
    add(instead("mean", "you give half of one share, without the other",
                [](const Arguments& g) { return amplitudes(g).s * amplitudes(g).s / 2; }));
    add(instead("mean", "you give half of one share, without the other",
                [](const Arguments& g) { return amplitudes(g).p * amplitudes(g).p / 2; }));
    const auto half_and_whole = [](double half, double whole) { return half * half / 2 + whole * whole; };
    const auto weighted = [&](const std::string& words, double (*weight)(double cosine)) {
        all.push_back({"mean", words, [weight](const WrongAnswer& w) {
                           const auto g = of(w.question);
                           const auto [s, p] = amplitudes(g);
                           const double x = weight(g.cosine), one = x * s * s + (1 - x) * p * p;
                           return std::abs(w.given[0] - one) <= 1e-7 ||
                                  std::abs(w.given[0] - (s * s + p * p - one)) <= 1e-7;
                       }});
    };
    weighted("the two shares have the weights cos^2 and sin^2", [](double cosine) { return cosine * cosine; });
    weighted("the two shares have the weights cos and 1 - cos", [](double cosine) { return cosine; });
    add({"mean", "you give half of one share and the whole of the other", [half_and_whole](const WrongAnswer& w) {
             const auto [s, p] = amplitudes(of(w.question));
             const auto is = [&](double value) { return std::abs(w.given[0] - value) <= 1e-7; };
             return is(half_and_whole(s, p)) || is(half_and_whole(p, s));
         }});
    add({"transmitted", "you give what gets through",
         [](const WrongAnswer& w) { return std::abs(w.given[0] + w.right[0] - 1) < 1e-7; }});
    add(instead("no_refraction", "both cosines are the one before the surface",
                [](const Arguments& g) { return mean_square(amplitudes(g, g.cosine)); }));
    add(instead("angle_forgotten", "you give the share of light along the normal", head_on));
    add(instead("schlick", "you give Schlick's approximation",
                [](const Arguments& g) { return schlick(g, g.cosine); }));
    add(instead("schlick", "you give Schlick's approximation", [](const Arguments& g) {
        const auto sine = static_cast<double>(sine_behind(g));
        return schlick(g, g.ior_before > g.ior_behind ? std::sqrt(1 - sine * sine) : g.cosine);
    }));
    add(instead("not_squared", "one of the two amplitudes is not squared",
                [](const Arguments& g) { return (amplitudes(g).s * amplitudes(g).s + amplitudes(g).p) / 2; }));
    add(instead("not_squared", "one of the two amplitudes is not squared",
                [](const Arguments& g) { return (amplitudes(g).s + amplitudes(g).p * amplitudes(g).p) / 2; }));
    add(instead("not_squared", "you give the square of the amplitudes' mean", [](const Arguments& g) {
        const double mean = (amplitudes(g).s + amplitudes(g).p) / 2;
        return mean * mean;
    }));
    add(instead("mean", "you give the geometric mean of both shares",
                [](const Arguments& g) { return std::abs(amplitudes(g).s * amplitudes(g).p); }));
    add(instead("mean", "you give the root of the mean of both shares",
                [](const Arguments& g) { return std::sqrt(mean_square(amplitudes(g))); }));
    const auto another_cosine = [&](const std::string& words, double (*behind)(double sine)) {
        const auto value = [behind](const Arguments& g) {
            return mean_square(amplitudes(g, behind(static_cast<double>(sine_behind(g)))));
        };
        all.push_back({"cosine_behind", words,
                       [value](const WrongAnswer& w) {
                           return !is_total(w.question) && std::abs(w.given[0] - value(of(w.question))) <= 1e-7;
                       },
                       [value](const Case& q) { return is_another(value(of(q)), q); }});
    };
    another_cosine("the sine behind stands for its cosine", [](double sine) { return sine; });
    another_cosine("the cosine behind is taken without its root", [](double sine) { return 1 - sine * sine; });
    another_cosine("the cosine behind is taken to be 1 minus the sine", [](double sine) { return 1 - sine; });
    another_cosine("the cosine behind is taken to be the root of 1 minus the sine",
                   [](double sine) { return std::sqrt(1 - sine); });
    const auto another_sine = [&](const std::string& words, double (*square_of)(double cosine)) {
        const auto value = [square_of](const Arguments& g) {  // no number where the sine would be more than 1
            const double eta = g.ior_before / g.ior_behind;
            return mean_square(amplitudes(g, std::sqrt(1 - eta * eta * square_of(g.cosine))));
        };
        const auto is_it = [value](const WrongAnswer& w) {
            const double other = value(of(w.question));
            return std::isnan(other) ? w.given[0] == 1 || !std::isfinite(w.given[0])
                                     : std::abs(w.given[0] - other) <= 1e-7;
        };
        all.push_back({"sine_before", words, is_it,
                       [value](const Case& q) {
                           const double other = value(of(q));
                           return std::isnan(other) ? !is_total(q) : is_another(other, q);
                       },
                       is_it});
    };
    another_sine("the cosine stands for the sine before the surface", [](double cosine) { return cosine * cosine; });
    another_sine("the square of the sine is taken to be 1 - cosine", [](double cosine) { return 1 - cosine; });
    another_sine("the sine is taken to be 1 - cosine", [](double cosine) { return (1 - cosine) * (1 - cosine); });
    add({"denominators", "one amplitude has the other's denominator, or their denominators have changed places",
         [](const WrongAnswer& w) {
             const auto g = of(w.question);
             const auto sine = static_cast<double>(sine_behind(g));
             const double behind = std::sqrt(1 - sine * sine);
             const double across = g.ior_before * g.cosine + g.ior_behind * behind,
                          within = g.ior_behind * g.cosine + g.ior_before * behind;
             const Amplitudes right = amplitudes(g);
             const double s = right.s * across / within, p = right.p * within / across;
             for (const Amplitudes& other : {Amplitudes{s, right.p}, Amplitudes{right.s, p}, Amplitudes{s, p}})
                 if (std::abs(w.given[0] - mean_square(other)) <= 1e-7) return !is_total(w.question);
             return false;
         }});
    add({"indices", "the share is that of the two media exchanged, or of an angle by their ratio turned round",
         [](const WrongAnswer& w) {
             const auto g = of(w.question);
             const Arguments turned{g.cosine, g.ior_behind, g.ior_before};
             const auto sine = static_cast<double>(sine_behind(turned));
             const double behind = std::sqrt(1 - sine * sine);
             const auto is = [&](double value) {
                 return std::isnan(value) ? !std::isfinite(w.given[0]) || w.given[0] == 1
                                          : std::abs(w.given[0] - value) <= 1e-7;
             };
             return is(mean_square(amplitudes(turned, behind))) || is(mean_square(amplitudes(g, behind)));
         }});
    add({"eta_squared", "the ratio of the indices is not squared under the root", [](const WrongAnswer& w) {
             const auto g = of(w.question);
             const double square = g.ior_before / g.ior_behind * (1 - g.cosine * g.cosine);
             const double value = square >= 1 ? 1 : mean_square(amplitudes(g, std::sqrt(1 - square)));
             return std::abs(w.given[0] - value) <= 1e-7;
         }});
    return of_numbers(std::move(all), {"total_reflection", "one_critical_angle", "sine_before"});
}

}  // namespace raylab::grading::fresnel_share
