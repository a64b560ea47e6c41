// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generated/stored_objects.hpp"

#include "canopen/cia301/dictionary/entry_value.hpp"
#include "canopen/cia301/dictionary/object_kinds.hpp"

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

/// The value of an entry as the file gives it: at its place, or a constant, which `room` takes.
Bytes FileValueOf(const Entry& entry, const Room& room) noexcept
{
    Bytes value{entry.place, LengthOf(entry)};
    if (entry.place == nullptr)
    {
        const Reading reading = cia301::ReadEntry(entry, room);
        value = Bytes{room.data, (reading.abort == SdoAbort::kNone) ? reading.size_bytes : 0U};
    }
    return value;
}

bool IsSame(const Bytes& left, const Bytes& right) noexcept
{
    bool is_same = left.size_bytes == right.size_bytes;
    for (std::uint32_t i = 0U; is_same && (i < left.size_bytes); ++i)
    {
        is_same = left.data[i] == right.data[i];
    }
    return is_same;
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
        const ObjectAddress object{entry.index, entry.sub};
        cia301::WriteHook* const hook = HooksOf(object).write;
        if ((hook != nullptr) && IsPreset(i, range))
        {
            std::uint8_t bytes[kLongestNumber] = {};
            Add(reply, object, hook->OnWrite(object, FileValueOf(entry, Room{bytes, kLongestNumber})));
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
        const ObjectAddress object{entry.index, entry.sub};
        cia301::ReadHook* const hook = HooksOf(object).read;
        if ((hook != nullptr) && IsPreset(i, range))
        {
            Add(reply, object, CompareEntry(entry, *hook));
        }
    }
    return reply;
}

/// kIncompatible: the hook has another value.
SdoAbort StoredObjects::CompareEntry(const Entry& entry, cia301::ReadHook& hook) noexcept
{
    std::uint8_t bytes[kLongestNumber] = {};
    const Bytes value = FileValueOf(entry, Room{bytes, kLongestNumber});
    if (value.size_bytes > kLongestNumber)
    {
        return SdoAbort::kNone; // No value that goes with others.
    }
    std::uint8_t now[kLongestNumber] = {};
    const Reading reading = hook.OnRead(ObjectAddress{entry.index, entry.sub}, Room{now, kLongestNumber});
    const bool is_same = (reading.abort == SdoAbort::kNone) && IsSame(Bytes{now, reading.size_bytes}, value);
    return is_same ? SdoAbort::kNone : SdoAbort::kIncompatible;
}

/// Whether the entry at this position has a value of the file that a hook wants to know.
bool StoredObjects::IsPreset(const std::uint32_t position, const IndexRange& range) const noexcept
{
    const Entry& entry = table_.entries[position];
    const bool is_inside = (entry.index >= range.first) && (entry.index <= range.last);
    const bool has_others = ((position + 1U) < table_.count) && (table_.entries[position + 1U].index == entry.index);
    const bool is_counter = (entry.sub == 0U) && has_others && !cia301::IsPdoMapping(entry.index);
    const bool is_stored = (entry.place != nullptr) && (entry.write_hook == this);
    const bool is_constant =
        (entry.access == Access::kConstant) && (entry.place == nullptr) && (entry.size_bytes <= kLongestNumber);
    const bool is_wanted = is_inside && !is_counter && !cia301::IsOwnObject(entry.index);
    return is_wanted && (is_stored || is_constant);
}

Reading StoredObjects::OnRead(const ObjectAddress& address, const Room& room) noexcept
{
    const ObjectHooks hooks = HooksOf(address);
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
    const ObjectHooks hooks = HooksOf(address);
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
    else if (cia301::IsSubCount(address))
    {
        abort = IsSame(Bytes{entry->place, entry->size_bytes}, value) ? SdoAbort::kNone : SdoAbort::kReadOnly;
    }
    else if (cia301::IsStoreObject(address.index) && (AttachedTo(address.index).write != nullptr))
    {
        abort = SdoAbort::kNotStored; // A group that the store has not.
    }
    else
    {
        // The stored value is all there is.
    }
    return abort;
}

/// Only a hook answers kPending.
SdoAbort StoredObjects::OnWriteAgain(const ObjectAddress& address, const Bytes& value) noexcept
{
    const ObjectHooks hooks = HooksOf(address);
    return (hooks.write != nullptr) ? hooks.write->OnWriteAgain(address, value) : OnWrite(address, value);
}

/// The hooks that have this object; null: the stored value is used.
ObjectHooks StoredObjects::HooksOf(const ObjectAddress& address) const noexcept
{
    const ObjectHooks hooks = AttachedTo(address.index);
    const bool is_missing = (hooks.read != nullptr) && !cia301::HasObject(*hooks.read, address);
    return (is_missing || cia301::IsSubCount(address)) ? ObjectHooks{nullptr, nullptr} : hooks;
}

ObjectHooks StoredObjects::AttachedTo(const std::uint16_t index) const noexcept
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
