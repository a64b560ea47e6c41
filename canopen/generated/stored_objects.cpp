// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generated/stored_objects.hpp"

#include "canopen/cia301/dictionary/entry_value.hpp"

namespace counterpoint::generated
{

using cia301::Access;
using cia301::Bytes;
using cia301::Entry;
using cia301::KeyOf;
using cia301::Reading;
using cia301::Room;
using cia301::SdoAbort;

namespace
{

constexpr std::uint32_t kLongestNumber = 8U;

std::uint32_t LengthOf(const Entry& entry) noexcept
{
    return (entry.length_bytes == nullptr) ? entry.size_bytes : *entry.length_bytes;
}

void Add(PresetReply& reply, const ObjectAddress& object, const SdoAbort abort) noexcept
{
    if (abort != SdoAbort::kNone)
    {
        const bool is_first = reply.refused == 0U;
        reply.abort = is_first ? abort : reply.abort;
        reply.object = is_first ? object : reply.object;
        ++reply.refused;
    }
}

} // namespace

AttachResult StoredObjects::Attach(const IndexRange& range, const ObjectHooks& hooks) noexcept
{
    AttachResult result = (count_ < kMaxHookedRanges) ? AttachResult::kAttached : AttachResult::kFull;
    for (std::uint8_t i = 0U; i < count_; ++i)
    {
        const IndexRange& other = ranges_[i].range;
        const bool is_apart = (range.last < other.first) || (range.first > other.last);
        result = is_apart ? result : AttachResult::kOverlap;
    }
    result = (range.first <= range.last) ? result : AttachResult::kOverlap;
    if (result == AttachResult::kAttached)
    {
        ranges_[count_] = HookedRange{range, hooks};
        ++count_;
    }
    return result;
}

PresetReply StoredObjects::Preset(const IndexRange& range) noexcept
{
    PresetReply reply{SdoAbort::kNone, ObjectAddress{0U, 0U}, 0U};
    for (std::uint32_t i = 0U; i < table_.count; ++i)
    {
        const Entry& entry = table_.entries[i];
        cia301::WriteHook* const hook = HooksOf(entry.index).write;
        if ((hook != nullptr) && IsPreset(i, range))
        {
            const ObjectAddress object{entry.index, entry.sub};
            Add(reply, object, hook->OnWrite(object, Bytes{entry.place, LengthOf(entry)}));
        }
    }
    return reply;
}

PresetReply StoredObjects::Compare(const IndexRange& range) noexcept
{
    PresetReply reply{SdoAbort::kNone, ObjectAddress{0U, 0U}, 0U};
    for (std::uint32_t i = 0U; i < table_.count; ++i)
    {
        const Entry& entry = table_.entries[i];
        cia301::ReadHook* const hook = HooksOf(entry.index).read;
        if ((hook != nullptr) && IsPreset(i, range))
        {
            Add(reply, ObjectAddress{entry.index, entry.sub}, CompareEntry(entry, *hook));
        }
    }
    return reply;
}

/// kIncompatible: the hook has another value.
SdoAbort StoredObjects::CompareEntry(const Entry& entry, cia301::ReadHook& hook) noexcept
{
    const std::uint32_t length = LengthOf(entry);
    if (length > kLongestNumber)
    {
        return SdoAbort::kNone; // No value that goes with others.
    }
    std::uint8_t now[kLongestNumber] = {};
    const Reading reading = hook.OnRead(ObjectAddress{entry.index, entry.sub}, Room{now, kLongestNumber});
    bool is_same = (reading.abort == SdoAbort::kNone) && (reading.size_bytes == length);
    for (std::uint32_t i = 0U; is_same && (i < length); ++i)
    {
        is_same = now[i] == entry.place[i];
    }
    return is_same ? SdoAbort::kNone : SdoAbort::kIncompatible;
}

/// Whether the entry at this position has a stored value that a hook wants to know.
bool StoredObjects::IsPreset(const std::uint32_t position, const IndexRange& range) const noexcept
{
    const Entry& entry = table_.entries[position];
    const bool is_inside = (entry.index >= range.first) && (entry.index <= range.last);
    const bool is_writable = (entry.access == Access::kReadWrite) || (entry.access == Access::kWriteOnly);
    const bool is_counter =
        (entry.sub == 0U) && ((position + 1U) < table_.count) && (table_.entries[position + 1U].index == entry.index);
    const bool is_stored = (entry.place != nullptr) && (entry.write_hook == this);
    const bool is_wanted = is_inside && is_writable && !is_counter;
    return is_wanted && is_stored;
}

Reading StoredObjects::OnRead(const ObjectAddress& address, const Room& room) noexcept
{
    const ObjectHooks hooks = HooksOf(address.index);
    const Entry* const entry = Find(address);
    Reading reading{SdoAbort::kObjectUnknown, 0U};
    if (hooks.read != nullptr)
    {
        reading = hooks.read->OnRead(address, room);
    }
    else if (entry != nullptr)
    {
        Entry stored = *entry;
        stored.read_hook = nullptr;
        reading = cia301::ReadEntry(stored, room);
    }
    else
    {
        // Nobody asks for what is not in the table.
    }
    return reading;
}

/// The dictionary stores what is accepted here; without a place there must be somebody who takes it.
SdoAbort StoredObjects::OnWrite(const ObjectAddress& address, const Bytes& value) noexcept
{
    const ObjectHooks hooks = HooksOf(address.index);
    const Entry* const entry = Find(address);
    SdoAbort abort = SdoAbort::kNone;
    if (hooks.write != nullptr)
    {
        abort = hooks.write->OnWrite(address, value);
    }
    else if ((entry == nullptr) || (entry->place == nullptr))
    {
        abort = SdoAbort::kGeneral;
    }
    else
    {
        // The stored value is all there is.
    }
    return abort;
}

ObjectHooks StoredObjects::HooksOf(const std::uint16_t index) const noexcept
{
    ObjectHooks hooks{nullptr, nullptr};
    for (std::uint8_t i = 0U; i < count_; ++i)
    {
        if ((index >= ranges_[i].range.first) && (index <= ranges_[i].range.last))
        {
            hooks = ranges_[i].hooks;
        }
    }
    return hooks;
}

const Entry* StoredObjects::Find(const ObjectAddress& address) const noexcept
{
    const std::uint32_t wanted = KeyOf(address.index, address.sub);
    const Entry* found = nullptr;
    std::uint32_t low = 0U;
    std::uint32_t high = table_.count;
    while (low < high)
    {
        const std::uint32_t middle = low + ((high - low) / 2U);
        const Entry& entry = table_.entries[middle];
        const std::uint32_t key = KeyOf(entry.index, entry.sub);
        found = (key == wanted) ? &entry : found;
        low = (key < wanted) ? (middle + 1U) : low;
        high = (key < wanted) ? high : middle;
    }
    return found;
}

} // namespace counterpoint::generated
