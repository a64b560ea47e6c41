// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/domain.hpp"

namespace counterpoint::proof
{

namespace
{
Letter Frame(const char* const text, const Act act, const std::uint32_t after_us, const std::uint8_t value)
{
    return Letter{text, act, after_us, value, 1U, FrameKind::kData, false, true, true, false};
}

Letter Call(const char* const text, const std::uint32_t after_us, const bool is_acknowledged)
{
    return Letter{text, Act::kCall, after_us, 0U, 0U, FrameKind::kData, is_acknowledged, true, true, false};
}

/// Right frames on the call and a microsecond behind it; calls on time and as late as allowed.
std::vector<Letter> Timing()
{
    return {Frame("normal", Act::kNormal, 0U, 1U),
            Frame("normal +1", Act::kNormal, 1U, 1U),
            Frame("inverse", Act::kInverse, 0U, 1U),
            Frame("inverse +1", Act::kInverse, 1U, 1U),
            Call("call", kCycleUs, false),
            Call("call, acknowledge", kCycleUs, true),
            Call("call +1", kCycleUs + kToleranceUs, false),
            Call("call +1, acknowledge", kCycleUs + kToleranceUs, true)};
}

/// Frames that are wrong, or of another value; calls on time.
std::vector<Letter> Frames()
{
    Letter empty = Frame("normal, too short", Act::kNormal, 0U, 1U);
    empty.length = 0U;
    Letter wide = Frame("inverse, too long", Act::kInverse, 0U, 1U);
    wide.length = 2U;
    Letter remote = Frame("normal, remote", Act::kNormal, 0U, 1U);
    remote.kind = FrameKind::kRemote;
    Letter gfc = Frame("global fail-safe command", Act::kGfc, 0U, 0U);
    gfc.length = 0U;
    return {Frame("normal", Act::kNormal, 0U, 1U),
            Frame("normal of another value", Act::kNormal, 0U, 2U),
            Frame("inverse", Act::kInverse, 0U, 1U),
            Frame("inverse of another value", Act::kInverse, 0U, 2U),
            empty,
            wide,
            remote,
            gfc,
            Call("call", kCycleUs, false),
            Call("call, acknowledge", kCycleUs, true)};
}

/// Right frames; calls of each kind.
std::vector<Letter> Calls()
{
    Letter leaves = Call("call, not OPERATIONAL", kCycleUs, false);
    leaves.is_operational = false;
    Letter leaves_high = Call("call, not OPERATIONAL, acknowledge", kCycleUs, true);
    leaves_high.is_operational = false;
    Letter lost = Call("call, queue overflow", kCycleUs, false);
    lost.is_intact = false;
    Letter lost_high = Call("call, queue overflow, acknowledge", kCycleUs, true);
    lost_high.is_intact = false;
    Letter demoted = Call("call, demoted", kCycleUs, false);
    demoted.is_demoted = true;
    Letter demoted_high = Call("call, demoted, acknowledge", kCycleUs, true);
    demoted_high.is_demoted = true;
    return {Frame("normal", Act::kNormal, 0U, 1U),
            Frame("inverse", Act::kInverse, 0U, 1U),
            Call("call", kCycleUs, false),
            Call("call, acknowledge", kCycleUs, true),
            Call("call, late", kCycleUs + kToleranceUs + 1U, false),
            Call("call, late, acknowledge", kCycleUs + kToleranceUs + 1U, true),
            leaves,
            leaves_high,
            lost,
            lost_high,
            demoted,
            demoted_high};
}
} // namespace

std::vector<Domain> MakeDomains()
{
    std::vector<Domain> domains{{"timing", Timing()}, {"frames", Frames()}, {"calls", Calls()}, {"all", {}}};
    for (std::size_t part = 0U; part < 3U; ++part)
    {
        for (const Letter& letter : domains[part].letters)
        {
            bool is_there = false;
            for (const Letter& other : domains[3U].letters)
            {
                is_there = is_there || (other.text == letter.text);
            }
            if (!is_there)
            {
                domains[3U].letters.push_back(letter);
            }
        }
    }
    return domains;
}

} // namespace counterpoint::proof
