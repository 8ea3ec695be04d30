#include "formats.h"
#include "part_text.h"

#include <fmt/format.h>

#include <algorithm>

// The dialect that Jenkins reads (junit-10.xsd): a failure is a wrong answer, an error is a program or a grader that
// did not come to an end.

namespace raylab::grading {

namespace {

// XML 1.0 has no control characters, escaped or not; safe_text() has shown them otherwise.
std::string xml(const std::string& text, std::size_t longest) {
    std::string escaped;
    for (const char character : safe_text(text, longest)) {
        switch (character) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += character;
        }
    }
    return escaped;
}

std::string attribute(const std::string& text) {
    auto line = xml(text, longest_message);
    std::ranges::replace(line, '\n', ' ');
    return line;
}

bool is_error(Outcome outcome) {
    switch (outcome) {
        case Outcome::pass:
        case Outcome::wrong:
        case Outcome::nonfinite:
        case Outcome::too_much_work:
        case Outcome::unfinished:
            return false;
        default:
            return true;
    }
}

struct Counts {
    std::size_t tests = 0, failures = 0, errors = 0;
};

std::string case_of(const Grade& grade, const GradePart& part) {
    auto text = fmt::format(R"(    <testcase name="{}" classname="raylab.{}" time="{:.3f}")", attribute(part.name),
                            attribute(grade.exercise), grade.answer_seconds);
    if (part.passed()) return text + "/>\n";
    const auto* const element = is_error(grade.outcome) ? "error" : "failure";
    return text + fmt::format(">\n      <{} message=\"{}\" type=\"{}\">{}</{}>\n    </testcase>\n", element,
                              attribute(part.message.empty() ? grade.summary : part.message), to_string(grade.outcome),
                              xml(part_text(grade, part), longest_message), element);
}

}  // namespace

std::string as_junit(const Grade& grade) {
    auto parts = grade.parts;
    if (parts.empty()) parts.push_back({.name = grade.exercise, .right = 0, .total = 1, .message = grade.summary});
    Counts counts{.tests = parts.size()};
    for (const auto& part : parts)
        if (!part.passed()) ++(is_error(grade.outcome) ? counts.errors : counts.failures);
    std::string cases;
    for (const auto& part : parts) cases += case_of(grade, part);
    const auto property = [](const std::string& name, const std::string& value) {
        return fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", name, attribute(value));
    };
    // ISO 8601 without a zone, as the schema has it.
    const auto began = grade.began.substr(0, grade.began.find('Z'));
    return fmt::format(
               "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"{}\" tests=\"{}\" "
               "failures=\"{}\" errors=\"{}\" skipped=\"0\" time=\"{:.3f}\" timestamp=\"{}\" hostname=\"raylab\">\n"
               "    <properties>\n",
               attribute(grade.exercise), counts.tests, counts.failures, counts.errors,
               grade.compile_seconds + grade.answer_seconds, began.empty() ? "1970-01-01T00:00:00" : began) +
           property("verdict", to_string(grade.outcome)) + property("points", points_text(grade.points())) +
           property("max_points", points_text(grade.most)) + property("hint_id", grade.hint_id) +
           property("seed", grade.seed ? std::to_string(*grade.seed) : "") +
           property("isolation", grade.isolation ? to_string(*grade.isolation) : "") + "    </properties>\n" + cases +
           fmt::format("    <system-out>{}</system-out>\n  </testsuite>\n</testsuites>\n",
                       xml(whole_text(grade), longest_output));
}

}  // namespace raylab::grading
