#include "grade_json.h"

#include "formats.h"
#include "isolation_json.h"
#include "part_text.h"

#include "raylab/base/error.h"
#include "raylab/report/json_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "raylab.result/1";

Json to_json(const GradePart& part) {
    return {{"name", safe_text(part.name, longest_message)},
            {"verdict", part.passed() ? "pass" : "wrong"},
            {"right", part.right},
            {"total", part.total},
            {"score", points_number(part.points)},
            {"max_score", points_number(part.most)},
            {"message", safe_text(part.message, longest_message)}};
}

Json to_json(const FirstWrong& wrong) {
    return {{"case", wrong.index},
            {"group", safe_text(wrong.group, longest_message)},
            {"story", safe_text(wrong.story, longest_message)},
            {"expected", safe_text(wrong.expected, longest_message)},
            {"got", safe_text(wrong.got, longest_message)}};
}

Hundredths hundredths(const Json& points) { return static_cast<Hundredths>(std::lround(100 * points.get<double>())); }

Outcome outcome_named(const std::string& name, const std::string& source) {
    std::string known;
    for (int i = 0; i <= static_cast<int>(Outcome::internal); ++i) {
        const auto outcome = static_cast<Outcome>(i);
        if (to_string(outcome) == name) return outcome;
        known += (i ? ", " : "") + to_string(outcome);
    }
    throw Error({.file = source, .inside = "/verdict"}, "one of " + known, name);
}

GradePart part_from(const Json& json) {
    return {.name = json.at("name").get<std::string>(),
            .right = json.at("right").get<std::size_t>(),
            .total = json.at("total").get<std::size_t>(),
            .points = hundredths(json.at("score")),
            .most = hundredths(json.at("max_score")),
            .message = json.at("message").get<std::string>()};
}

Grade grade_from(const Json& json, const std::string& source) {
    const auto text = [](const Json& in, const char* key) { return in.at(key).get<std::string>(); };
    if (const auto format = text(json, "format"); format != format_name)
        throw Error({.file = source, .inside = "/format"}, format_name, format);
    Grade grade{.exercise = text(json, "exercise"),
                .student = text(json, "student"),
                .outcome = outcome_named(text(json, "verdict"), source),
                .summary = text(json, "summary"),
                .details = text(json, "details"),
                .parts = {},
                .most = hundredths(json.at("max_score")),
                .first_wrong = {},
                .hint_id = text(json, "hint_id"),
                .hint = text(json, "hint")};
    for (const auto& part : json.at("tests")) grade.parts.push_back(part_from(part));
    if (const auto& wrong = json.at("first_wrong"); !wrong.is_null())
        grade.first_wrong = FirstWrong{wrong.at("case").get<std::size_t>(), text(wrong, "group"), text(wrong, "story"),
                                       text(wrong, "expected"), text(wrong, "got")};
    const auto& submitted = json.at("submission");
    grade.submitted = {text(submitted, "file"), text(submitted, "sha256"), text(submitted, "modified"),
                       submitted.at("bytes").get<std::uintmax_t>(),
                       submitted.at("notes").get<std::vector<std::string>>()};
    grade.compiler = text(json.at("build"), "diagnostics");
    grade.printed = text(json, "printed");
    if (const auto& seed = json.at("seed"); !seed.is_null()) grade.seed = seed.get<std::uint64_t>();
    if (const auto& isolation = json.at("isolation"); !isolation.is_null())
        grade.isolation = Isolation{static_cast<Level>(isolation.at("level").get<int>()),
                                    isolation.at("landlock").get<int>(), isolation.at("own_user").get<bool>()};
    grade.cases_sha256 = text(json, "cases_sha256");
    grade.fingerprint = text(json, "fingerprint");
    const auto& times = json.at("times");
    grade.began = text(times, "began");
    grade.ended = text(times, "ended");
    grade.compile_seconds = times.at("compile_s").get<double>();
    grade.answer_seconds = times.at("answer_cpu_s").get<double>();
    grade.lab = text(json, "lab");
    return grade;
}

std::string build_status(Outcome outcome) {
    if (outcome == Outcome::internal || outcome == Outcome::no_submission) return "not compiled";
    const bool failed = outcome == Outcome::does_not_compile || outcome == Outcome::refused;
    return failed ? to_string(outcome) : "compiled";
}

}  // namespace

Json to_json(const Grade& grade) {
    const auto safe = [](const std::string& text) { return safe_text(text, longest_output); };
    Json json{{"format", format_name},
              {"exercise", grade.exercise},
              {"student", safe(grade.student)},
              {"verdict", to_string(grade.outcome)},
              {"summary", safe(grade.summary)},
              {"score", points_number(grade.points())},
              {"max_score", points_number(grade.most)},
              {"tests", Json::array()},
              {"first_wrong", nullptr},
              {"hint_id", grade.hint_id},
              {"hint", safe(grade.hint)},
              {"details", safe(grade.details)},
              {"submission",
               {{"file", safe(grade.submitted.file)},
                {"sha256", grade.submitted.sha256},
                {"modified", grade.submitted.modified},
                {"bytes", grade.submitted.bytes},
                {"notes", Json::array()}}},
              {"build", {{"status", build_status(grade.outcome)}, {"diagnostics", safe(grade.compiler)}}},
              {"printed", safe(grade.printed)},
              {"seed", nullptr},
              {"isolation", nullptr},
              {"cases_sha256", grade.cases_sha256},
              {"fingerprint", grade.fingerprint},
              {"times",
               {{"began", grade.began},
                {"ended", grade.ended},
                {"compile_s", grade.compile_seconds},
                {"answer_cpu_s", grade.answer_seconds}}},
              {"lab", grade.lab}};
    for (const auto& part : grade.parts) json["tests"].push_back(to_json(part));
    for (const auto& note : grade.submitted.notes) json["submission"]["notes"].push_back(safe(note));
    if (grade.first_wrong) json["first_wrong"] = to_json(*grade.first_wrong);
    if (grade.seed) json["seed"] = *grade.seed;
    if (grade.isolation) json["isolation"] = to_json(*grade.isolation);
    return json;
}

Grade grade_from_json(const Json& json, const std::string& source) {
    try {
        return grade_from(json, source);
    } catch (const nlohmann::json::exception& error) {
        throw Error({source}, std::string("a result (") + format_name + ")", error.what());
    }
}

std::string as_json(const Grade& grade) { return json_text(to_json(grade)); }

}  // namespace raylab::grading
