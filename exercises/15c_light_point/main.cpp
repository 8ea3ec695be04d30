#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 15c` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(light::inputs, light::outputs,
                        [](auto input, auto output) { light::answer(&raylab::light_point, input, output); });
}
