// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_HASH_HPP
#define VERIFICATION_CONFORMANCE_HASH_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint::conformance
{

/// FNV-1a over 32-bit words: taken by value, so it is the same whatever the byte order. Members are added one by one,
/// never as memory: padding has no value.
class Hash
{
  public:
    void Add(std::uint32_t word) noexcept
    {
        value_ = (value_ ^ word) * 0x01000193U;
    }

    void AddMask(SrdoMask mask) noexcept
    {
        Add(static_cast<std::uint32_t>(mask & 0xFFFFFFFFU));
        Add(static_cast<std::uint32_t>(mask >> 32U));
    }

    void AddOutcome(const CycleOutcome& outcome) noexcept
    {
        AddMask(outcome.released);
        AddMask(outcome.faulted);
        AddMask(outcome.waiting);
        AddMask(outcome.new_fault);
        AddMask(outcome.fresh);
        AddMask(outcome.due);
        AddMask(outcome.refresh);
        AddMask(outcome.signalled);
        Add(outcome.cycle);
        Add(outcome.ordinal_sum);
        Add(static_cast<std::uint32_t>(outcome.guard));
        Add(outcome.sct_checked);
        Add(outcome.is_tx);
        Add(outcome.is_invalid);
        Add(outcome.not_operational);
    }

    void AddView(const SrdoView& view) noexcept
    {
        Add(view.data.low);
        Add(view.data.high);
        Add(view.ordinal);
        Add(view.signals);
        Add(view.error_count);
        Add(static_cast<std::uint32_t>(view.state));
        Add(static_cast<std::uint32_t>(view.first_cause));
        Add(view.holds_pair);
    }

    void AddHeld(const HeldPair& held) noexcept
    {
        Add(held.data.low);
        Add(held.data.high);
        Add(held.ordinal);
        Add(held.holds_pair);
    }

    void AddFrame(const CanFrame& frame) noexcept
    {
        Add(frame.identifier);
        Add(static_cast<std::uint32_t>(frame.kind));
        Add(static_cast<std::uint32_t>(frame.port));
        Add(frame.length_bytes);
        for (const std::uint8_t byte : frame.data)
        {
            Add(byte);
        }
    }

    [[nodiscard]] std::uint32_t Value() const noexcept
    {
        return value_;
    }

  private:
    std::uint32_t value_{0x811C9DC5U};
};

} // namespace counterpoint::conformance

#endif
