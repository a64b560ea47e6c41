// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/told.hpp"

#include <algorithm>
#include <sstream>

namespace counterpoint::third_voice
{
/// In an order of its own.
std::string TextOf(Seen seen, const Sparing& sparing)
{
    std::sort(seen.signals.begin(), seen.signals.end());
    std::sort(seen.events.begin(), seen.events.end());
    std::sort(seen.frames.begin(), seen.frames.end(),
              [](const Sent& left, const Sent& right) { return left.identifier < right.identifier; });
    std::ostringstream text;
    for (const auto& [number, cause] : seen.signals)
    {
        const bool is_between = sparing.frame_causes && cause <= SrdoCause::kSct;
        if (!is_between)
        {
            text << " cause " << static_cast<unsigned>(cause) << " of " << +number;
        }
    }
    for (const std::uint8_t number : seen.events)
    {
        text << " event of " << +number;
    }
    for (const std::uint8_t number : seen.refreshes)
    {
        text << " call of " << +number;
    }
    for (const Sent& frame : seen.frames)
    {
        text << " frame " << frame.identifier << std::hex;
        for (const std::uint8_t byte : frame.data)
        {
            text << ' ' << +byte;
        }
        text << std::dec;
    }
    text << ((seen.faults > 0) ? " device fault" : "");
    text << ((seen.unfollowed > 0) ? " GFC not followed" : "");
    text << ((seen.gfcs > 0 && !sparing.gfc) ? " GFC" : "")
         << (seen.is_configuration_invalid ? " configuration invalid" : "");
    return text.str();
}
} // namespace counterpoint::third_voice
