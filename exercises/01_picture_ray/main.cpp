#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 01` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(picture_rays::inputs, picture_rays::outputs,
                        [](auto input, auto output) { picture_rays::answer(&raylab::picture_ray, input, output); });
}
