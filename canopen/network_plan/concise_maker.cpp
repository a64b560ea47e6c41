// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/network_plan/concise_maker.hpp"

#include "canopen/cia306/file/string_value.hpp"
#include "canopen/cia306/safety/signature.hpp"

#include <optional>
#include <string>

namespace counterpoint::network_plan
{
namespace
{
using cia306::Device;
using cia306::Entry;
using cia306::LittleEndian;
using cia306::Object;

constexpr std::uint16_t kFirstObject = 0x1000U;
constexpr std::uint16_t kConfigurationDate = 0x1020U;
constexpr std::uint16_t kMappingOffset = 0x0200U;
constexpr std::uint32_t kBitsOfByte = 8U;
constexpr std::uint32_t kOff = 0x80000000U;

struct IndexRange
{
    std::uint16_t first;
    std::uint16_t last;
};

/// What is no configuration: commands (store, restore, programs, network management).
constexpr IndexRange kLeftOut[] = {{0x1010U, 0x1011U}, {0x1F50U, 0x1F5FU}, {0x1F80U, 0x1F91U}};

/// The safety configuration has a procedure of its own, and 5F00h to 5F05h of a safety device are a part of its
/// program.
bool IsLeftOut(const Entry& entry)
{
    bool is_left_out = entry.index < kFirstObject || entry.is_safety;
    for (const IndexRange& range : kLeftOut)
    {
        is_left_out = is_left_out || (entry.index >= range.first && entry.index <= range.last);
    }
    return is_left_out;
}

/// 1400h to 15FFh and 1800h to 19FFh.
bool IsPdo(const std::uint16_t index)
{
    constexpr std::uint16_t kBlock = 0xFE00U;
    return (index & kBlock) == 0x1400U || (index & kBlock) == 0x1800U;
}

bool IsPdoMapping(const std::uint16_t index)
{
    return IsPdo(static_cast<std::uint16_t>(index - kMappingOffset)); // Below 200h it is FE00h or more: none.
}

/// Neither by the device nor by its file.
bool IsRefused(const Entry& entry)
{
    return entry.IsFixed() || entry.is_download_refused;
}

/// A value that does not fit its type is none, as for the device itself. [SRS_EDS_032]
bool HasValue(const Device& device, const Entry& entry, const std::uint8_t node_id)
{
    return cia306::UsableValue(device.file, entry, node_id).has_value();
}

bool IsToBeWritten(const Device& device, const Entry& entry, const std::uint8_t node_id)
{
    const bool is_meant = entry.parameter_value.IsSet() && !IsRefused(entry) && !IsLeftOut(entry);
    return is_meant && HasValue(device, entry, node_id);
}

bool HasConfigured(const Device& device, const std::uint16_t index, const std::uint8_t node_id)
{
    const Object* const object = device.Find(index);
    bool has_one = false;
    if (object != nullptr)
    {
        for (const auto& [sub, entry] : object->entries)
        {
            has_one = has_one || IsToBeWritten(device, entry, node_id);
        }
    }
    return has_one;
}

class Maker
{
  public:
    Maker(const Device& device, const std::uint8_t node_id) : device_(device), node_id_(node_id)
    {
    }

    std::vector<ConciseEntry> Make()
    {
        for (const auto& [index, object] : device_.objects)
        {
            if (IsPdo(index))
            {
                AddPdo(index);
            }
        }
        for (const auto& [index, object] : device_.objects)
        {
            const auto communication = static_cast<std::uint16_t>(index - kMappingOffset);
            const bool is_done = IsPdo(index) || (IsPdoMapping(index) && device_.Find(communication) != nullptr);
            if (!is_done && index != kConfigurationDate)
            {
                AddObject(index, 0U);
            }
        }
        AddObject(kConfigurationDate, 0U); // Who reads the right date there may rely on all the rest.
        return entries_;
    }

  private:
    void Add(const Entry& entry)
    {
        entries_.push_back({entry.index, entry.sub, BytesOf(device_, entry, node_id_)});
    }
    void AddObject(const std::uint16_t index, const std::uint8_t from)
    {
        if (const Object* const object = device_.Find(index))
        {
            for (const auto& [sub, entry] : object->entries)
            {
                if (sub >= from && IsToBeWritten(device_, entry, node_id_))
                {
                    Add(entry);
                }
            }
        }
    }
    void AddPdo(const std::uint16_t index)
    {
        const auto mapping = static_cast<std::uint16_t>(index + kMappingOffset);
        const Entry* const identifier = device_.Find(index, 1U);
        if (!HasConfigured(device_, index, node_id_) && !HasConfigured(device_, mapping, node_id_))
        {
            return;
        }
        const bool can_switch =
            identifier != nullptr && !IsRefused(*identifier) && HasValue(device_, *identifier, node_id_);
        const std::uint32_t on = can_switch ? NumberOf(device_, node_id_, index, 1U, 0U) : 0U;
        if (can_switch)
        {
            entries_.push_back({index, 1U, LittleEndian(on | kOff, sizeof(on))});
        }
        AddObject(index, 2U);
        AddMapping(mapping);
        if (can_switch)
        {
            entries_.push_back({index, 1U, BytesOf(device_, *identifier, node_id_)});
        }
    }
    void AddMapping(const std::uint16_t mapping)
    {
        const Entry* const count = device_.Find(mapping, 0U);
        const bool is_counted = count != nullptr && !IsRefused(*count) &&
                                (!count->Configured().IsSet() || HasValue(device_, *count, node_id_));
        if (is_counted && HasConfigured(device_, mapping, node_id_))
        {
            entries_.push_back({mapping, 0U, LittleEndian(0U, 1U)});
            AddObject(mapping, 1U);
            Add(*count);
        }
    }

    const Device& device_;
    std::uint8_t node_id_;
    std::vector<ConciseEntry> entries_;
};
} // namespace

std::vector<std::uint8_t> BytesOf(const Device& device, const Entry& entry, const std::uint8_t node_id)
{
    const cia306::Value value = cia306::RequiredValue(device.file, entry, node_id);
    const std::uint32_t size = (entry.type.bits + kBitsOfByte - 1U) / kBitsOfByte;
    return (size > 0U) ? LittleEndian(value.bits, size) : cia306::BytesOfText(entry.data_type, value.text);
}

std::uint32_t NumberOf(const Device& device, const std::uint8_t node_id, const std::uint16_t index,
                       const std::uint8_t sub, const std::uint32_t usual)
{
    const Entry* const entry = device.Find(index, sub);
    const std::optional<cia306::Value> value =
        (entry == nullptr) ? std::nullopt : cia306::UsableValue(device.file, *entry, node_id);
    return value ? static_cast<std::uint32_t>(value->bits) : usual;
}

std::vector<ConciseEntry> MakeConcise(const Device& device, const std::uint8_t node_id)
{
    return Maker(device, node_id).Make();
}

std::vector<std::uint8_t> ConciseBytes(const std::vector<ConciseEntry>& entries)
{
    std::vector<std::uint8_t> bytes = LittleEndian(entries.size(), sizeof(std::uint32_t));
    for (const ConciseEntry& entry : entries)
    {
        for (const auto& part : {LittleEndian(entry.index, 2U), LittleEndian(entry.sub, 1U),
                                 LittleEndian(entry.value.size(), sizeof(std::uint32_t)), entry.value})
        {
            bytes.insert(bytes.end(), part.begin(), part.end());
        }
    }
    return entries.empty() ? std::vector<std::uint8_t>{} : bytes;
}
} // namespace counterpoint::network_plan
