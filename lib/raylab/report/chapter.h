#pragma once

#include "raylab/base/program.h"
#include "raylab/experiment/measure/measure.h"
#include "raylab/report/stability.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// The common main program of all chapters: options, output folder, page of the lab book.

namespace raylab {

/// The title of a chapter and the question it answers.
struct ChapterTitle {
    std::string folder;    // "02_spheres_and_quadrics"
    std::string title;     // "Spheres and quadrics"
    std::string question;  // "Where does a ray hit an implicit surface?"
};

/// The options of a chapter: --out DIR, --quick, --threads N, --seed S, --scene FILE, --only PART, --case NAME, --json
/// FILE, --yours.
struct ChapterRun {
    enum class Effort { full, quick };
    // The folder for its files, which are moved to DIR/02_spheres_and_quadrics in the end.
    std::filesystem::path out = {};
    std::filesystem::path scene = {};  // the chapter's scene.toml unless --scene names another
    Effort effort = Effort::full;
    int threads = 0;  // 0: all cores
    std::uint64_t seed = 1;
    // Yours: the slot holds a student's function, which is shown among the methods as `yours`.
    enum class Slot { reference, yours } slot = Slot::reference;

    /// Whether the chapter is part of the lab book: `tour` sets it, with the folders of the neighbouring chapters
    /// (empty: none).
    enum class Place { alone, in_book } place = Place::alone;
    std::string previous, next;

    /// `full` in a full run, `quick` in a quick one.
    template <class T>
    T sized(T full_size, T quick_size) const {
        return effort == Effort::full ? full_size : quick_size;
    }

    /// How methods are timed: a quick run is just accurate enough to tell the fast ones from the slow ones.
    MeasureOptions timing() const { return sized<MeasureOptions>({}, {.repeats = 3, .shortest = 0.0005}); }
};

/// The chapter's page in the lab book, built from the parts in the order in which they are added. Paths are relative to
/// the chapter's folder.
class Page {
public:
    explicit Page(const ChapterTitle& title);

    void heading(const std::string& text);
    void text(const std::string& markdown);  // paragraphs, `code`, *emphasis*, links; HTML is escaped
    /// Shows pictures side by side. Each is a .png or .svg file beside the page, with a caption.
    struct Figure {
        std::string file, caption;
    };
    void figures(const std::vector<Figure>& figures);
    void table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
               const std::string& caption = "");
    void experiment(const Experiment& experiment, const std::string& chart_name);  // the chart and its numbers
    void stability(const std::vector<CaseOutcome>& outcomes);

    /// Writes folder/index.html, and folder/page.json for the lab book's front page. Only the pictures are files of
    /// their own.
    void write(const std::filesystem::path& folder, const ChapterRun& run) const;

private:
    struct Heading {
        std::string words, anchor;
    };
    // Renders HTML when the pictures exist.
    using Block = std::function<std::string(const std::filesystem::path& folder)>;

    ChapterTitle title_;
    std::chrono::steady_clock::time_point begun_;
    std::vector<Block> blocks_;
    std::vector<Heading> headings_;
    std::vector<std::string> charts_;
    Figure first_picture_;
    int steps_ = 0;
    std::size_t cases_ = 0, cases_as_expected_ = 0;
};

/// The parts of a chapter: one program tells the story, measures the questions and runs the stability cases.
struct Chapter {
    ChapterTitle title;
    // Pictures, diagrams and text: everything except the two parts below.
    std::function<void(const ChapterRun&, Page&)> story;
    std::vector<std::pair<std::string, std::function<Experiment(const ChapterRun&)>>> questions;  // "ray_triangle"
    std::function<std::vector<StabilityCase>(const ChapterRun&)> cases;
};

/// The main program of a chapter: reads the options, runs the parts that they ask for (all of them by default), and
/// writes the page.
///   --list             prints {"folder", "title", "question", "questions": [...], "cases": [...]} as JSON and
///                      runs nothing
///   --only story|charts|stability   runs one part; the page is written only with the story
///   --question NAME    draws one question's chart;  --case NAME (repeatable): runs some cases
///   --json FILE        {"chapter": {...}, "questions": [...], "stability": [...]}; "-": stdout, and no other
///                      text there
/// A chapter prints nothing to stdout itself: its text goes to the page. The exit code is 1 where a stability case is
/// not as expected.
int run_chapter(const Chapter& chapter, int argc, char** argv);

}  // namespace raylab
