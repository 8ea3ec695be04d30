#pragma once

#include "grade.h"

#include <string>
#include <vector>

// A result in the words of each course's machine. Numbers are finite and within their bounds, texts are valid UTF-8 of
// bounded length without control characters.

namespace raylab::grading {

struct Format {
    std::string name, about;
    std::string (*text_of)(const Grade& grade);
};

/// All formats, by their names on the command line.
const std::vector<Format>& formats();

/// A format by its name. An Error lists the known ones.
const Format& format_of(const std::string& name);

std::string as_text(const Grade& grade);          // for people
std::string as_json(const Grade& grade);          // everything; grade_json.h reads it again
std::string as_gradescope(const Grade& grade);    // results/results.json
std::string as_github(const Grade& grade);        // the result of a step of GitHub Classroom's autograding
std::string as_junit(const Grade& grade);         // JUnit's XML
std::string as_autolab(const Grade& grade);       // the last two lines of standard output
std::string as_prairielearn(const Grade& grade);  // results/results.json
std::string as_tap(const Grade& grade);           // Test Anything Protocol, version 14

}  // namespace raylab::grading
