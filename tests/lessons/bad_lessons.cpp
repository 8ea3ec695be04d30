#include "catch.h"

#include "glossary.h"

// The checks of lessons, asked about lessons that are made up: a good one, and what each check must find.

using namespace raylab;
using namespace raylab::lessons;

namespace {

const std::string good = R"(# 42 Answers: what is asked?

An introduction of six words.

![What to *see*](pictures/see.png)

## One

A **quark** is small, and $q$ is its charge.

## Two

## Three

```pseudo
ask the quark
```

## Four

<details><summary>Folded</summary>

Five words that do not count.
</details>

## Speed against accuracy

## Where it fails

## Deeper

## Try this

1. One.
2. Two.
3. Three.

## Questions

1. **Which?**

   <details><summary>Answer</summary>

   **This one.** It is.
   </details>
2. **What?**

   <details><summary>Answer</summary>

   **That.**
   </details>
3. **Why?**

   <details><summary>Answer</summary>

   **Because.**
   </details>

## Summary

- One.
- Two.
- Three.

## Words and symbols

- **quark**: a small thing.
- $q$: its charge.

## Sources and further reading
)";

std::string with(const std::string& from, const std::string& to) {
    std::string text = good;
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

NamedLesson named(const std::string& markdown, const std::string& name = "42") { return {name, lesson_text(markdown)}; }

}  // namespace

TEST_CASE("a good lesson has nothing to complain about") {
    const auto lesson = lesson_text(good);
    CHECK(title_complaints(lesson, "42", "Answers", "What is asked?").empty());
    CHECK(part_complaints(lesson).empty());
    CHECK(question_complaints(lesson).empty());
    CHECK(experiment_complaints(lesson).empty());
    CHECK(summary_complaints(lesson).empty());
    CHECK(figure_complaints(lesson).empty());
    CHECK(definition_complaints(named(good)).empty());
    CHECK(early_use_complaints({named(good)}).empty());
    CHECK(symbol_complaints({named(good)}).empty());
}

TEST_CASE("another title, question or number is found") {
    CHECK(title_complaints(lesson_text(good), "42", "Answers", "Who asks?").size() == 1);
    CHECK(title_complaints(lesson_text(good), "42", "Answer", "What is asked?").size() == 1);
    CHECK(title_complaints(lesson_text(good), "41", "Answers", "What is asked?").size() == 1);
}

TEST_CASE("a part that is missing, twice, or in another place is found, and so are too few sections") {
    CHECK(part_complaints(lesson_text(with("## Deeper\n", ""))).size() == 1);
    CHECK(part_complaints(lesson_text(with("## Deeper\n", "## Deeper\n\n## Deeper\n"))).size() == 1);
    CHECK(part_complaints(lesson_text(with("## Deeper", "## Summary"))).size() == 1);
    CHECK(part_complaints(lesson_text(good + "\n## One more\n")).size() == 1);
    CHECK(part_complaints(lesson_text(with("## Two\n", ""))).size() == 1);
}

TEST_CASE("questions without a question mark, answers that are open, late or missing are found") {
    CHECK(question_complaints(lesson_text(with("**Which?**", "**Which.**"))).size() == 1);
    CHECK(question_complaints(lesson_text(with("**Which?**", "Which?"))).size() == 2);
    CHECK(question_complaints(lesson_text(with("**Which?**", "**Which\n   one?**"))).empty());
    CHECK(question_complaints(lesson_text(with("**This one.** It is.", "It is this one."))).size() == 1);
    CHECK(question_complaints(lesson_text(with("<details><summary>Answer</summary>", ""))).size() == 1);
}

TEST_CASE("two experiments, and a summary of two points, are too few") {
    CHECK(experiment_complaints(lesson_text(with("3. Three.\n", ""))).size() == 1);
    CHECK(summary_complaints(lesson_text(with("- Three.\n", ""))).size() == 1);
}

TEST_CASE("a figure that is none is found, with its line") {
    for (const std::string bad : {"![](pictures/see.png)", "![See](see.png)", "![See](pictures/see.jpg)",
                                  "![See](pictures/see.png) and more"}) {
        const auto complaints = figure_complaints(lesson_text(with("![What to *see*](pictures/see.png)", bad)));
        REQUIRE(complaints.size() == 1);
        CHECK(complaints[0].starts_with("line 5: "));
    }
    CHECK(figure_files(lesson_text(good)) == std::vector<std::string>{"pictures/see.png"});
}

TEST_CASE("a formula's number that is out of order, or left out, is found") {
    const auto numbered = [](const std::string& first, const std::string& second) {
        const auto formula = [](const std::string& number) { return "```math\nq \\tag{" + number + "}\n```\n"; };
        return numbering_complaints(lesson_text(good + formula(first) + formula(second)));
    };
    CHECK(numbered("1", "2").empty());
    CHECK(numbered("2", "1").size() == 2);
    CHECK(numbered("1", "3").size() == 1);
}

TEST_CASE("the core's words are those of its text and headings") {
    // An introduction (5), One, Two, Three, Four (4), and 'A quark is small, and q is its charge' (9).
    CHECK(core_words(lesson_text(good)) == 18);
}

TEST_CASE("a bold word without an entry, and an entry without a definition, are found") {
    CHECK(definition_complaints(named(with("is small", "is **small**"))).size() == 1);
    CHECK(definition_complaints(named(with("A **quark**", "A quark"))).size() == 1);
    CHECK(definition_complaints(named(with("## Two\n", "## Two\n\nA **quark** again.\n"))).size() == 1);
}

TEST_CASE("a term that is used too early is found: in text, in a heading, in a caption, in an earlier lesson") {
    CHECK(early_use_complaints({named(with("An introduction of", "A QUARK of"))}).size() == 1);
    CHECK(early_use_complaints({named(with("## One\n", "## One quark\n"))}).size() == 1);
    CHECK(early_use_complaints({named(with("What to *see*", "What quarks do"))}).size() == 1);
    const std::string earlier = "# 41 Before: what?\n\n```pseudo\nask the quark\n```\n";
    const auto complaints = early_use_complaints({named(earlier, "41"), named(good)});
    REQUIRE(complaints.size() == 1);
    CHECK(complaints[0] == "41, line 4: uses 'quark', which 42 defines in line 9");
}

TEST_CASE("a term that stands across the end of a line is defined, and used, all the same") {
    const auto two_words = [](std::string text) {
        text.replace(text.find("**quark**"), 9, "**up\nquark**");
        text.replace(text.find("- **quark**"), 11, "- **up quark**");
        return text;
    };
    CHECK(definition_complaints(named(two_words(good))).empty());
    const std::string early = with("An introduction of", "An up\nquark of");
    CHECK(early_use_complaints({named(two_words(early))}).size() == 1);
}

TEST_CASE("titles, code, links' targets, sources and longer words are no uses") {
    const std::string earlier =
        "# 41 Quark: why?\n\nSay `quark`, [there](../quark/README.md), or quarkly.\n\n```sh\nquark\n```\n\n"
        "## Sources and further reading\n\n- A quark's book.\n";
    CHECK(early_use_complaints({named(earlier, "41"), named(good)}).empty());
}

TEST_CASE("a symbol that no list has is found, once") {
    CHECK(symbol_complaints({named(with("$q$ is", "$q = \\rho$ and $\\rho$ is"))}).size() == 1);
    CHECK(symbol_complaints({named(with("- $q$: its charge.\n", ""))}).size() == 1);
    CHECK(symbol_complaints({named(good, "41"), named(with("- $q$: its charge.\n", ""))}).empty());
}

TEST_CASE("symbols are letters without indices, words and functions") {
    CHECK(symbols(R"(\mathbf{N} \cdot L_i = \cos \theta_1 \text{ if } k_{r} \le 2^n)") ==
          std::vector<std::string>{"N", "L", "\\theta", "k", "n"});
}
