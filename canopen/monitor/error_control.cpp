// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/error_control.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::monitor
{
namespace
{
constexpr std::uint32_t kNodes = 0x7FU;
constexpr std::uint8_t kStateMask = 0x7FU;
constexpr std::uint32_t kToggleBit = 7U;
constexpr std::array<std::uint8_t, 3U> kStates{4U, 5U, 127U};
} // namespace

ErrorControlFrame ErrorControl::Take(const LogFrame& frame) noexcept
{
    ErrorControlFrame told;
    told.node_id = static_cast<std::uint8_t>(frame.identifier & kNodes);
    told.is_request = frame.is_remote;
    told.has_length = frame.length == 1U;
    Guarding& guarding = guarding_[told.node_id];
    if (told.is_request || !told.has_length)
    {
        guarding.is_asked = guarding.is_asked || told.is_request;
        return told;
    }
    told.state = static_cast<std::uint8_t>(frame.data[0] & kStateMask);
    told.toggle = static_cast<std::uint8_t>(frame.data[0] >> kToggleBit);
    told.is_boot_up = frame.data[0] == 0U;
    told.is_state = told.is_boot_up || std::find(kStates.begin(), kStates.end(), told.state) != kStates.end();
    told.is_answer = std::exchange(guarding.is_asked, false) && !told.is_boot_up;
    told.is_alternated = !told.is_answer || guarding.toggle != told.toggle;
    if (told.is_boot_up)
    {
        guarding.toggle.reset();
    }
    else if (told.is_answer)
    {
        guarding.toggle = told.toggle;
    }
    return told;
}
} // namespace counterpoint::monitor
