#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 05` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(highlight::inputs, highlight::outputs,
                        [](auto input, auto output) { highlight::answer(&raylab::phong_specular, input, output); });
}
