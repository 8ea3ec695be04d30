#pragma once

#include "raylab/report/chapter_run.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

// A chapter's README.md is its lesson. Here it becomes the body of the page: what its text names (figures, tables,
// charts, cases, sources, the exercise) is put where it is named. CONTRIBUTING.md says how a lesson names them.

namespace raylab {

/// What a chapter's program made for its lesson, by the names that the lesson uses.
struct LessonParts {
    struct Figure {
        std::string file;    // beside the page
        std::string floats;  // the same picture as EXR; empty: none
        std::string command;
        std::string trees = {};  // a script with the ray trees of its pixels; empty: none
        std::string walk = {};   // a page in which one walks through what it shows; empty: none
    };
    std::map<std::string, Figure> figures = {};
    std::map<std::string, std::string> tables = {};  // as HTML
    std::map<std::string, std::string> charts = {};  // as HTML
    std::string cases = {};                          // as HTML; empty: they did not run
};

/// The lesson as HTML, and its contents as data.
struct Lesson {
    std::string introduction;  // the text before the first heading
    std::string body;
    struct Heading {
        std::string html, anchor;
    };
    std::vector<Heading> headings;
    struct Figure {
        std::string name, file, caption, anchor;  // the caption as plain text
    };
    std::vector<Figure> figures;
    struct Word {
        std::string term, html, anchor;  // HTML both: the term or symbol, and what it means
    };
    std::vector<Word> words;
    std::vector<std::filesystem::path> sources;  // files to which it links, for the page's folder source/, as NAME.txt
};

/// Reads a lesson; `folder` is the page's. It throws an Error where the lesson names what the program did not make, or
/// what is not there, and where it leaves out a figure or table that was made.
Lesson read_lesson(const std::filesystem::path& readme, const LessonParts& parts, const std::filesystem::path& folder,
                   ChapterRun::Place place);

}  // namespace raylab
