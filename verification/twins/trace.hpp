// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWINS_TRACE_HPP
#define VERIFICATION_TWINS_TRACE_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>
#include <initializer_list>

namespace counterpoint::twins
{

/// Everything that one channel showed, in order, as one number.
class Trace
{
  public:
    void Add(std::uint64_t word) noexcept
    {
        value_ = (value_ ^ word) * 0x9E3779B97F4A7C15U;
        value_ ^= value_ >> 29U;
    }
    void Add(const Payload& data) noexcept
    {
        Add((static_cast<std::uint64_t>(data.high) << 32U) | data.low);
    }
    void Add(const CanFrame& frame) noexcept
    {
        Add((static_cast<std::uint64_t>(frame.identifier) << 32U) | (static_cast<std::uint64_t>(frame.kind) << 16U) |
            (static_cast<std::uint64_t>(frame.port) << 8U) | frame.length_bytes);
        for (const std::uint8_t byte : frame.data)
        {
            Add(byte);
        }
    }
    void Add(const CheckResult& result) noexcept
    {
        Add((static_cast<std::uint64_t>(result.fault) << 16U) | result.signature);
    }
    void Add(const HeldPair& held) noexcept
    {
        Add(held.data);
        Add(held.ordinal);
        Add(held.holds_pair);
    }
    void Add(const SrdoView& view) noexcept
    {
        Add(view.data);
        Add(view.ordinal);
        Add(view.signals);
        Add(view.error_count);
        Add((static_cast<std::uint64_t>(view.state) << 16U) | (static_cast<std::uint64_t>(view.first_cause) << 8U) |
            view.holds_pair);
    }
    void Add(const CycleOutcome& outcome) noexcept
    {
        for (const SrdoMask mask : {outcome.released, outcome.faulted, outcome.waiting, outcome.new_fault,
                                    outcome.fresh, outcome.due, outcome.refresh, outcome.signalled})
        {
            Add(mask);
        }
        Add(outcome.cycle);
        Add(outcome.ordinal_sum);
        Add(static_cast<std::uint64_t>(outcome.guard));
        Add((static_cast<std::uint64_t>(outcome.sct_checked) << 24U) |
            (static_cast<std::uint64_t>(outcome.is_tx) << 16U) |
            (static_cast<std::uint64_t>(outcome.is_invalid) << 8U) | outcome.not_operational);
    }
    [[nodiscard]] std::uint64_t Value() const noexcept
    {
        return value_;
    }

  private:
    std::uint64_t value_{0xCBF29CE484222325U};
};

} // namespace counterpoint::twins

#endif
