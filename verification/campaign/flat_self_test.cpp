// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/flat_self_test.hpp"

#include <stdexcept>
#include <string>

namespace counterpoint::campaign
{
FlatSelfTest::FlatSelfTest(Region& region, const hal::SafetyOutput& output)
    : test_(region.Make<simulator::NodeSelfTest>(memory_, image_, output, faults_))
{
}

void FlatSelfTest::Start(const Channel& channel_a, const Channel& channel_b, const std::uint32_t cycles)
{
    image_.TakeProgram(channel_a, channel_b);
    if (!test_.Settle(cycles))
    {
        throw std::runtime_error("the self tests do not fit into the diagnostic interval of " + std::to_string(cycles) +
                                 " cycles");
    }
    test_.Start();
}

void FlatSelfTest::Stick(std::uint8_t* const byte, const std::uint8_t bit, const bool level)
{
    memory_.Stick({byte, bit, level, 0U});
}
} // namespace counterpoint::campaign
