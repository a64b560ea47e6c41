// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MEMBERS_HPP
#define VERIFICATION_CAMPAIGN_MEMBERS_HPP

#include "safety_core/contract/channel.hpp"

#include <algorithm>
#include <iterator>
#include <type_traits>

/// What is kept in the region, member by member. Bytes between members hold whatever the stack held there, so that
/// memory which is compared would differ though nothing of the device does. [SRS_CMG_540]
namespace counterpoint::campaign
{
/// A type with such bytes needs a function of its own.
template <typename Value> void KeepMembers(Value& to, const Value& from) noexcept
{
    static_assert(std::is_empty_v<Value> || std::has_unique_object_representations_v<Value>,
                  "bytes between members would be kept");
    if constexpr (!std::is_empty_v<Value>)
    {
        to = from;
    }
}

inline void KeepMembers(CycleOutcome& to, const CycleOutcome& from) noexcept
{
    to.released = from.released;
    to.faulted = from.faulted;
    to.waiting = from.waiting;
    to.new_fault = from.new_fault;
    to.fresh = from.fresh;
    to.due = from.due;
    to.refresh = from.refresh;
    to.signalled = from.signalled;
    to.cycle = from.cycle;
    to.ordinal_sum = from.ordinal_sum;
    to.guard = from.guard;
    to.sct_checked = from.sct_checked;
    to.is_tx = from.is_tx;
    to.is_invalid = from.is_invalid;
    to.not_operational = from.not_operational;
}

inline void KeepMembers(CanFrame& to, const CanFrame& from) noexcept
{
    to.identifier = from.identifier;
    to.kind = from.kind;
    to.port = from.port;
    to.length_bytes = from.length_bytes;
    std::copy(std::begin(from.data), std::end(from.data), std::begin(to.data));
}

inline void KeepMembers(PreparedPair& to, const PreparedPair& from) noexcept
{
    KeepMembers(to.normal, from.normal);
    to.status = from.status;
}

inline void KeepMembers(Permit& to, const Permit& from) noexcept
{
    to.mask = from.mask;
    to.response = from.response;
}

inline void KeepMembers(ConfigItem& to, const ConfigItem& from) noexcept
{
    KeepMembers(to.address, from.address);
    to.value = from.value;
}

inline void KeepMembers(CheckResult& to, const CheckResult& from) noexcept
{
    to.fault = from.fault;
    to.signature = from.signature;
}
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_MEMBERS_HPP
