#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 07` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(refraction::inputs, refraction::outputs, [](auto input, auto output) {
        refraction::answer(&raylab::refracted_direction, input, output);
    });
}
