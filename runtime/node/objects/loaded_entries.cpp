// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/objects/loaded_entries.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/dictionary/entry_value.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint32_t kAddressBytes = 3U; ///< Of an item of cia301::StoredEntries, in front of the value.
constexpr std::uint32_t kSubBits = 8U;
constexpr std::uint32_t kSubMask = 0xFFU;
constexpr std::uint16_t kHighResolution = 0x1013U; ///< A time that goes on.

ObjectAddress AddressOf(const std::uint32_t key)
{
    return {static_cast<std::uint16_t>(key >> kSubBits), static_cast<std::uint8_t>(key & kSubMask)};
}
} // namespace

LoadedEntries::LoadedEntries(cia301::StoredEntries& entries, const cia301::Dictionary& dictionary) noexcept
    : entries_(entries), dictionary_(dictionary)
{
}

std::uint32_t LoadedEntries::ItemCount() noexcept
{
    return entries_.ItemCount();
}

cia301::StoredItem LoadedEntries::Item(const std::uint32_t number, const cia301::Room& room) noexcept
{
    return entries_.Item(number, room);
}

void LoadedEntries::BeginLoad(const std::uint8_t groups) noexcept
{
    loaded_.clear();
    entries_.BeginLoad(groups);
}

bool LoadedEntries::LoadItem(const cia301::Bytes& item) noexcept
{
    const bool is_loaded = entries_.LoadItem(item);
    if (item.size_bytes >= kAddressBytes)
    {
        const auto index = static_cast<std::uint16_t>(cia301::FromLittleEndian(item.data, 2U));
        const std::uint8_t sub = item.data[2];
        if (is_loaded)
        {
            loaded_[cia301::KeyOf(index, sub)].assign(item.data + kAddressBytes, item.data + item.size_bytes);
        }
        else
        {
            refused_.push_back(cia306::ObjectName(index, sub));
        }
    }
    return is_loaded;
}

bool LoadedEntries::EndLoad(const std::uint8_t groups) noexcept
{
    return entries_.EndLoad(groups);
}

void LoadedEntries::Lose(const std::uint8_t groups) noexcept
{
    loaded_.clear();
    entries_.Lose(groups);
}

std::string LoadedEntries::TakeRefused()
{
    std::string text;
    for (const std::string& object : std::exchange(refused_, {}))
    {
        text += (text.empty() ? " (" : ", ") + object;
    }
    return text.empty() ? text : text + ")";
}

std::vector<std::string> LoadedEntries::NotTaken() const
{
    std::vector<std::string> objects;
    for (const auto& [key, value] : loaded_)
    {
        const ObjectAddress object = AddressOf(key);
        const cia301::Entry* const entry = dictionary_.Find(object);
        std::vector<std::uint8_t> now(entry == nullptr ? 0U : entry->size_bytes);
        const cia301::Reading reading =
            (entry == nullptr) ? cia301::Reading{cia301::SdoAbort::kObjectUnknown, 0U}
                               : cia301::ReadEntry(*entry, {now.data(), static_cast<std::uint32_t>(now.size())});
        now.resize(reading.size_bytes);
        const bool is_same = reading.abort == cia301::SdoAbort::kNone && now == value;
        if (!is_same && object.index != kHighResolution)
        {
            objects.push_back(cia306::ObjectName(object.index, object.sub));
        }
    }
    return objects;
}

bool LoadedEntries::Has(const ObjectAddress& object) const
{
    return loaded_.count(cia301::KeyOf(object.index, object.sub)) != 0U;
}
} // namespace counterpoint::runtime
