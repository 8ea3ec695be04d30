#pragma once

#include "raylab/base/program.h"
#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chapter_run.h"
#include "raylab/report/page/page.h"
#include "raylab/report/stability.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

// The common main program of all chapters: options, output folder, page of the lab book.

namespace raylab {

/// The parts of a chapter: one program tells the story, measures the questions and runs the stability cases.
struct Chapter {
    ChapterTitle title;
    // The lesson's figures and tables.
    std::function<void(const ChapterRun&, Page&)> story;
    std::vector<std::pair<std::string, std::function<Experiment(const ChapterRun&)>>> questions;  // "ray_triangle"
    std::function<std::vector<StabilityCase>(const ChapterRun&)> cases;
};

/// The main program of a chapter: reads the options, runs the parts that they ask for (all of them by default), and
/// writes the page.
///   --list             prints {"folder", "title", "question", "questions": [...], "cases": [...]} as JSON and
///                      runs nothing
///   --only story|charts|stability   runs one part; the page is written only with the story
///   --figure NAME      makes one figure of the lesson
///   --question NAME    draws one question's chart;  --case NAME (repeatable): runs some cases
///   --json FILE        {"chapter": {...}, "questions": [...], "stability": [...]}; "-": stdout, and no other
///                      text there
/// A chapter prints nothing to stdout itself: its text goes to the page. The exit code is 1 where a stability case is
/// not as expected.
int run_chapter(const Chapter& chapter, int argc, char** argv);

}  // namespace raylab
