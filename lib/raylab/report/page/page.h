#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/image/image.h"
#include "raylab/report/chapter_run.h"
#include "raylab/report/chart/chart.h"
#include "raylab/report/diagram/diagram.h"
#include "raylab/report/page/lesson.h"
#include "raylab/report/plane/plane_drawing.h"
#include "raylab/report/stability.h"

#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace raylab {

/// The chapter's page in the lab book: its lesson, README.md, with what the chapter's program makes for it. The
/// lesson's text decides what stands where.
class Page {
public:
    Page(const ChapterTitle& title, const ChapterRun& run);

    /// What a figure may be made of: rendered, as .png, or drawn, as .svg.
    using Drawing = std::variant<Image, PlaneDrawing, Diagram, CurveChart>;
    enum class Keep {
        picture,
        floats  // the picture as .exr, too, where the chapter runs alone: for reference_images/. A book would be heavy
    };
    struct FigureOptions {
        std::string command = {};  // makes this figure alone; by default `./raylab chapter NN --figure NAME`
        Keep keep = Keep::picture;
    };
    /// A figure of the lesson, `![caption](pictures/NAME.png)`. `make` runs only where the figure is wanted.
    void figure(const std::string& name, const std::function<Drawing()>& make, const FigureOptions& options);
    void figure(const std::string& name, const std::function<Drawing()>& make) { figure(name, make, {}); }

    /// Lets the reader pick the pixels of a figure that was made before; `make` returns a script
    /// (ray_tree/pixel_trees.h).
    void pixel_trees(const std::string& figure, const std::function<std::string()>& make);

    /// Lets the reader walk through the scene of a figure that was made before; `make` returns a page.
    void walk_through(const std::string& figure, const std::function<std::string()>& make);

    using Rows = std::vector<std::vector<std::string>>;
    /// A table of the lesson, `<!-- table: NAME -->`. The cells are Markdown.
    void table(const std::string& name, const std::vector<std::string>& header, const std::function<Rows()>& make);

    void experiment(const Experiment& experiment, const std::string& chart_name);  // `<!-- chart: NAME -->`
    void stability(const std::vector<CaseOutcome>& outcomes);                      // `<!-- cases -->`

    /// Writes folder/index.html, and folder/page.json for the lab book's front page and its search. Pictures, and the
    /// sources to which the lesson links, are files beside it. It throws an Error where the lesson names what was not
    /// made, and where something was made that it does not show.
    void write(const std::filesystem::path& folder) const;

    /// The names of all figures that the program can make.
    const std::vector<std::string>& offered() const { return offered_; }

private:
    nlohmann::ordered_json summary() const;

    ChapterTitle title_;
    ChapterRun run_;
    std::chrono::steady_clock::time_point begun_;
    LessonParts parts_;
    std::vector<std::string> offered_;
    std::vector<std::string> charts_;
    std::vector<std::pair<std::string, std::string>> methods_;  // their names, and the charts that compare them
    std::vector<CaseOutcome> outcomes_;
};

}  // namespace raylab
