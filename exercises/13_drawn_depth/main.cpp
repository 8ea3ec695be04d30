#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 13` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(drawing_depth::inputs, drawing_depth::outputs,
                        [](auto input, auto output) { drawing_depth::answer(&raylab::drawn_depth, input, output); });
}
