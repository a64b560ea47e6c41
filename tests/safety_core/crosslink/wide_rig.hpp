// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_SAFETY_CORE_CROSSLINK_WIDE_RIG_HPP
#define TESTS_SAFETY_CORE_CROSSLINK_WIDE_RIG_HPP

#include "tests/safety_core/crosslink/peer_rig.hpp"

#include <algorithm>
#include <cstdint>
#include <initializer_list>

namespace counterpoint
{

inline SrdoMask MaskOf(const std::initializer_list<SlotIndex> slots)
{
    SrdoMask mask = 0U;
    for (const SlotIndex slot : slots)
    {
        mask |= SrdoMask{1U} << slot;
    }
    return mask;
}

inline SlotReport PairReport(const SlotIndex slot, const std::uint32_t age_us, const std::uint32_t low)
{
    return SlotReport{slot, Holding::kPair, SrdoState::kReleased, SrdoCause::kNone, 9U, age_us, Payload{low, 0U}};
}

/// Slot 1 is a producer, slot 2 off, every other a consumer; slot n has the identifiers 101h + 2n and the next one.
class WideRig : public PeerRig
{
  public:
    explicit WideRig(const PeerRole role) : PeerRig{role}
    {
        config.srdo_count = 64U;
        Own().Restart(config);
        Remote().Restart(config);
        for (SlotIndex slot = 0U; slot < 64U; ++slot)
        {
            channel.cob_id_1[slot] = 0x101U + (2U * slot);
            channel.direction[slot] = 2U;
            static_cast<void>(Own().Validate(slot));
        }
        channel.direction[1] = 1U;
        channel.direction[2] = 0U;
        channel.outcome.waiting = 0U;
    }
    /// The inverse frame of a slot is on the bus, and its pair is held from the next cycle on.
    void Hold(const SlotIndex slot, const std::uint32_t at_us, const std::uint32_t ordinal)
    {
        Own().OnFrame(Frame(0x102U + (2U * slot)), Instant{at_us});
        channel.held[slot] = HeldPair{Payload{0x100U + slot, 0U}, ordinal, 1U};
        channel.outcome.fresh |= SrdoMask{1U} << slot;
        channel.outcome.released |= SrdoMask{1U} << slot;
    }
    /// The peer tells this between 11 and 12 ms.
    void Tell(const std::initializer_list<SlotReport> reports, const SrdoMask released)
    {
        LinkMessage word = AnswerTo(10000U);
        std::copy(reports.begin(), reports.end(), &word.reports[0]);
        word.released = released;
        Hear(word, 12000U);
    }
};

} // namespace counterpoint

#endif
