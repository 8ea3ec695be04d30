#include "course/idle_options.h"

#include "raylab/base/error.h"

#include <string>
#include <vector>

namespace raylab {

namespace {

struct IdleOption {
    std::string name, instead;
};

// With which other option (or without which) the options would do nothing.
struct IdleOptions {
    std::string condition;
    std::vector<IdleOption> options;
};

const IdleOptions in_a_class{"with --class",
                             {{"--submission", "whose entries are the submissions"},
                              {"--student", "whose entries are named as the students are"},
                              {"--format", "whose report is pages, grades.csv, grades.json and a result each in JSON"},
                              {"--scene", "which is graded for exercises"},
                              {"--reference-dir", "which is graded for exercises"},
                              {"--picture", "which is graded for exercises"},
                              {"--renderer", "which is graded for exercises"}}};

const std::string of_gradings = "which gathers what is graded: give it to the grading";
const IdleOptions in_a_merger{"with --merge",
                              {{"--class", of_gradings},
                               {"--submission", of_gradings},
                               {"--student", of_gradings},
                               {"--format", "whose report is pages, grades.csv and grades.json"},
                               {"--seed", of_gradings},
                               {"--key", of_gradings},
                               {"--part", of_gradings},
                               {"--regrade", of_gradings},
                               {"--pseudonyms", of_gradings}}};

const IdleOptions alone{"without --class",
                        {{"--part", "of which it is a share"},
                         {"--regrade", "whose report has earlier results: --seed repeats a single one"},
                         {"--pseudonyms", "of whose students it is"},
                         {"--jobs", "of which it is the submissions at a time"}}};

const IdleOptions of_one{
    "with --submission",
    {{"--picture", "which is a source file: pictures are graded with --scene or --reference-dir"},
     {"--renderer", "which is a source file: renderers are graded with --scene or --reference-dir"}}};

void refuse(const Arguments& arguments, const IdleOptions& idle) {
    for (const auto& [name, instead] : idle.options)
        if (arguments.has(name)) throw Error("expected no " + name + " " + idle.condition + ", " + instead);
}

}  // namespace

void refuse_idle_options(const Arguments& arguments) {
    if (arguments.has("--merge")) return refuse(arguments, in_a_merger);
    if (arguments.has("--class")) return refuse(arguments, in_a_class);
    refuse(arguments, alone);
    if (arguments.has("--submission")) refuse(arguments, of_one);
}

}  // namespace raylab
