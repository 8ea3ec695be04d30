#include "raylab/report/chapter.h"

#include "raylab/base/command_line.h"
#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/nearest_name.h"
#include "raylab/base/outputs.h"
#include "raylab/base/print.h"
#include "raylab/base/read_json.h"
#include "raylab/report/chart/chart.h"
#include "raylab/report/experiment.h"
#include "raylab/report/experiment_text.h"
#include "raylab/report/json_text.h"
#include "raylab/report/provenance.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace raylab {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

CommandLine command_line_of(const ChapterTitle& title) {
    return {.program = title.folder,
            .about = title.title + ": " + title.question,
            .options = {{"--out", "DIR", "the lab book's folder; the chapter's own is created inside", "out"},
                        {"--quick", "", "fewer samples, smaller pictures"},
                        threads_option(),
                        {"--seed", "S", "the seed of all random numbers", "1"},
                        {"--scene", "FILE", "use another scene than the chapter's own"},
                        {"--lesson", "FILE", "use another lesson than the chapter's README.md"},
                        {"--only", "PART", "run one part: story, charts or stability"},
                        {"--figure", "NAME", "make only this figure of the lesson"},
                        {"--question", "NAME", "draw only this question's chart"},
                        {"--rows", "", "print every measurement of the charts, and not one line a method"},
                        {"--case", "NAME", "run only this stability case; may be repeated", "", Option::Repeat::all},
                        {"--json", "FILE", "the charts' and cases' data as JSON; - is standard output"},
                        {"--yours", "SLOT", "the function of this slot is a student's: show it as `yours`"},
                        {"--list", "", "print the names of questions and cases as JSON and run nothing"},
                        {"--in-book", "", "link to the lab book's front page"},
                        {"--previous", "FOLDER", "the chapter before this one, for links"},
                        {"--next", "FOLDER", "the chapter after this one, for links"}}};
}

ChapterRun run_from(const Arguments& arguments, const ChapterTitle& title) {
    ChapterRun run;
    run.out = fs::path(arguments.text("--out")) / title.folder;
    run.scene = arguments.text_if_given("--scene").value_or(source_folder() / "chapters" / title.folder / "scene.toml");
    run.lesson =
        arguments.text_if_given("--lesson").value_or(source_folder() / "chapters" / title.folder / "README.md");
    run.figure = arguments.text_if_given("--figure").value_or("");
    run.effort = arguments.has("--quick") ? ChapterRun::Effort::quick : ChapterRun::Effort::full;
    run.threads = threads_of(arguments);
    run.seed = *seed_if_given(arguments);
    run.yours = arguments.text_if_given("--yours").value_or("");
    run.place = arguments.has("--in-book") ? ChapterRun::Place::in_book : ChapterRun::Place::alone;
    run.previous = arguments.text_if_given("--previous").value_or("");
    run.next = arguments.text_if_given("--next").value_or("");
    return run;
}

/// The parts of the chapter that are asked for.
struct Parts {
    bool story, charts, stability;
    bool all() const { return story && charts && stability; }
};

Parts parts_from(const Arguments& arguments) {
    if (const auto only = arguments.text_if_given("--only")) {
        const Parts parts{*only == "story", *only == "charts", *only == "stability"};
        if (parts.story || parts.charts || parts.stability) return parts;
        throw Error("expected --only story, charts or stability, found '" + *only + "'");
    }
    if (arguments.has("--figure")) return {true, false, false};
    const bool question = arguments.has("--question");
    const bool cases = arguments.has("--case");
    if (!question && !cases) return {true, true, true};
    return {false, question, cases};
}

std::vector<std::string> names_of(const std::vector<StabilityCase>& cases) {
    std::vector<std::string> names;
    for (const auto& stability_case : cases) names.push_back(stability_case.name);
    return names;
}

std::vector<std::string> names_of(const decltype(Chapter::questions)& questions) {
    std::vector<std::string> names;
    for (const auto& [name, ask] : questions) names.push_back(name);
    return names;
}

void refuse_unknown(const std::string& option, const std::string& name, const std::vector<std::string>& known) {
    if (std::ranges::find(known, name) != known.end()) return;
    throw Error(fmt::format("expected {} to be one of: {}; found {}", option,
                            known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", ")),
                            with_suggestion(name, known)));
}

std::vector<StabilityCase> cases_of(const Chapter& chapter, const ChapterRun& run) {
    return chapter.cases ? chapter.cases(run) : std::vector<StabilityCase>{};
}

void refuse_unknown_names(const Chapter& chapter, const ChapterRun& run, const Arguments& arguments) {
    if (const auto question = arguments.text_if_given("--question"))
        refuse_unknown("--question", *question, names_of(chapter.questions));
    for (const auto& name : arguments.all("--case")) refuse_unknown("--case", name, names_of(cases_of(chapter, run)));
}

/// A running chapter: it collects results and writes them to the page, the terminal or JSON.
class Telling {
public:
    Telling(const Chapter& chapter, const ChapterRun& run, const Arguments& arguments, Outputs& outputs)
        : chapter_(chapter),
          run_(run),
          arguments_(arguments),
          outputs_(outputs),
          page_(chapter.title, run),
          silent_(arguments.text_if_given("--json") == "-") {}

    void story() {
        say(chapter_.title.title + ": " + chapter_.title.question + "\n");
        if (chapter_.story) chapter_.story(run_, page_);
        if (!run_.figure.empty()) refuse_unknown("--figure", run_.figure, page_.offered());
    }

    void charts() {
        const auto wanted = arguments_.text_if_given("--question");
        for (const auto& [name, ask] : chapter_.questions) {
            if (wanted && name != *wanted) continue;
            const auto experiment = ask(run_);
            write_chart(experiment, run_.out, name);
            page_.experiment(experiment, name);
            questions_.push_back(to_json(experiment));
            say("\n" + (arguments_.has("--rows") ? rows_text(experiment) : summary_text(experiment)));
        }
    }

    void stability() {
        const auto all = cases_of(chapter_, run_);
        const auto& wanted = arguments_.all("--case");
        for (const auto& stability_case : all)
            if (wanted.empty() || std::ranges::find(wanted, stability_case.name) != wanted.end())
                outcomes_.push_back(raylab::run(stability_case));
        if (outcomes_.empty()) return;
        if (wanted.empty()) write_file(run_.out / "stability.json", to_json(outcomes_));
        page_.stability(outcomes_);
        say("\n" + to_text(outcomes_));
    }

    void write_page(const fs::path& folder) {
        page_.write(run_.out);
        if (!silent_) outputs_.say("\n" + (folder / "index.html").string() + "\n");
    }

    ExitCode finish() const {
        if (const auto file = arguments_.text_if_given("--json")) {
            const auto& [folder, title, question] = chapter_.title;
            write_json(json_text({{"chapter", {{"folder", folder}, {"title", title}, {"question", question}}},
                                  {"questions", questions_},
                                  {"stability", json_from_text(to_json(outcomes_), "the outcomes")}}),
                       outputs_[*file]);
        }
        outputs_.commit();
        return std::ranges::all_of(outcomes_, &CaseOutcome::as_expected) ? ExitCode::as_it_should_be
                                                                         : ExitCode::negative;
    }

private:
    void say(const std::string& text) const {
        if (!silent_) print_text(text);
    }

    const Chapter& chapter_;
    const ChapterRun& run_;
    const Arguments& arguments_;
    Outputs& outputs_;
    Page page_;
    bool silent_;
    ordered_json questions_ = ordered_json::array();
    std::vector<CaseOutcome> outcomes_;
};

std::string list_of(const Chapter& chapter, const ChapterRun& run) {
    const auto& [folder, title, question] = chapter.title;
    return json_text({{"folder", folder},
                      {"title", title},
                      {"question", question},
                      {"questions", names_of(chapter.questions)},
                      {"cases", names_of(cases_of(chapter, run))}});
}

}  // namespace

int run_chapter(const Chapter& chapter, int argc, char** argv) {
    return run_program([&] {
        const auto arguments = parse(command_line_of(chapter.title), words(argc, argv));
        auto run = run_from(arguments, chapter.title);
        if (arguments.has("--list")) {
            print_data(list_of(chapter, run));
            return ExitCode::as_it_should_be;
        }
        const auto parts = parts_from(arguments);
        refuse_unknown_names(chapter, run, arguments);
        Outputs outputs({.files = arguments.given({"--json"}), .folders = {run.out}, .inputs = {run.scene}});
        const auto folder = outputs.staged(run.out);
        run.out = folder.path;
        Telling telling(chapter, run, arguments, outputs);
        outputs.naming_folders([&] {
            if (parts.story) telling.story();
            if (parts.charts) telling.charts();
            if (parts.stability) telling.stability();
            if (parts.story && run.figure.empty()) telling.write_page(folder.named);
        });
        return telling.finish();
    });
}

}  // namespace raylab
