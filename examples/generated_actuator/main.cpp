// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/generated_actuator/run.hpp"

#include <cstdio>

int main()
{
    return (std::fputs(counterpoint::examples::RunGeneratedActuator().c_str(), stdout) < 0) ? 1 : 0;
}
