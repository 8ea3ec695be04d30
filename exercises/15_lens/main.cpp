#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 15` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(lens::inputs, lens::outputs,
                        [](auto input, auto output) { lens::answer(&raylab::lens_point, input, output); });
}
