#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 14` starts it and
// judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(contour::inputs, contour::outputs,
                        [](auto input, auto output) { contour::answer(&raylab::contour_form_factor, input, output); });
}
