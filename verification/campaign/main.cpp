// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line/run.hpp"
#include "verification/campaign/command.hpp"

int main(const int count, const char* const* const arguments)
{
    return counterpoint::tools::RunProgram(
        count, arguments,
        {{"campaign", "Hit a device with a million faults and account for each of them",
          &counterpoint::campaign::MakeCampaign}});
}
