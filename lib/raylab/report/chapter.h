#pragma once

#include "raylab/base/program.h"
#include "raylab/report/measure.h"
#include "raylab/report/stability.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// The frame every chapter's main.cpp stands in: its options, its folder, its page of the lab book.

namespace raylab {

/// What a chapter says of itself.
struct ChapterTitle {
    std::string folder;    // "02_spheres_and_quadrics"
    std::string title;     // "Spheres and quadrics"
    std::string question;  // "Where does a ray meet an implicit surface?"
};

/// How a chapter is to run: --out DIR, --quick, --threads N, --seed S, --scene FILE, --only PART, --case NAME,
/// --json FILE, --yours.
struct ChapterRun {
    enum class Effort { full, quick };
    std::filesystem::path out = {};    // where its files are written; in the end they are in DIR/02_spheres_and_quadrics
    std::filesystem::path scene = {};  // the chapter's scene.toml unless --scene says otherwise
    Effort effort = Effort::full;
    int threads = 0;              // 0: all cores
    std::uint64_t seed = 1;
    enum class Slot { reference, yours } slot = Slot::reference;  // yours: the slot holds a student's function: show it among the methods as `yours`

    /// Its place in the lab book: `tour` says so, with the folders of its neighbours (empty: none).
    enum class Place { alone, in_book } place = Place::alone;
    std::string previous, next;

    /// `full` in a full run, `quick` in a quick one.
    template <class T>
    T sized(T full_size, T quick_size) const {
        return effort == Effort::full ? full_size : quick_size;
    }

    /// How methods are timed: in a quick run just well enough to tell the fast from the slow.
    MeasureOptions timing() const { return sized<MeasureOptions>({}, {.repeats = 3, .shortest = 0.0005}); }
};

/// The chapter's page in the lab book, written in the order it is told. Paths are relative to the chapter's folder.
class Page {
public:
    explicit Page(const ChapterTitle& title);

    void heading(const std::string& text);
    void text(const std::string& markdown);  // paragraphs, `code`, *emphasis*, links; no HTML passes through
    /// Pictures side by side, as steps: each a .png or .svg beside the page and what it shows.
    struct Figure {
        std::string file, caption;
    };
    void figures(const std::vector<Figure>& figures);
    void table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
               const std::string& caption = "");
    void experiment(const Experiment& experiment, const std::string& chart_name);  // chart and its numbers
    void stability(const std::vector<CaseOutcome>& outcomes);

    /// folder/index.html, and folder/page.json for the lab book's front page. Self-contained but for its pictures.
    void write(const std::filesystem::path& folder, const ChapterRun& run) const;

private:
    struct Heading {
        std::string words, anchor;
    };
    using Block = std::function<std::string(const std::filesystem::path& folder)>;  // HTML, once the pictures are there

    ChapterTitle title_;
    std::chrono::steady_clock::time_point begun_;
    std::vector<Block> blocks_;
    std::vector<Heading> headings_;
    std::vector<std::string> charts_;
    Figure first_picture_;
    int steps_ = 0;
    std::size_t cases_ = 0, cases_as_expected_ = 0;
};

/// A chapter's parts: the same program tells its story, charts its questions and runs its stability cases.
struct Chapter {
    ChapterTitle title;
    std::function<void(const ChapterRun&, Page&)> story;  // pictures, diagrams, text: everything but the two below
    std::vector<std::pair<std::string, std::function<Experiment(const ChapterRun&)>>> questions;  // "ray_triangle"
    std::function<std::vector<StabilityCase>(const ChapterRun&)> cases;
};

/// The whole program of a chapter: reads the options, runs what they ask for (all of it by default), writes the page.
///   --list             {"folder", "title", "question", "questions": [...], "cases": [...]} as JSON, nothing is run
///   --only story|charts|stability   a part; a page is written where the story is told
///   --question NAME    one question's chart;  --case NAME (repeatable): some cases
///   --json FILE        {"chapter": {...}, "questions": [...], "stability": [...]}; "-": stdout, and no other text there
/// A chapter prints nothing to stdout itself: what it has to say goes to the page.
/// Exit 1 where a stability case is not as expected.
int run_chapter(const Chapter& chapter, int argc, char** argv);

}  // namespace raylab
