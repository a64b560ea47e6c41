// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/objects/objects.hpp"

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/dictionary/entry_value.hpp"
#include "canopen/cia301/dictionary/object_kinds.hpp"
#include "canopen/cia306/file/saved.hpp"
#include "canopen/cia306/file/string_value.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/number.hpp"
#include "runtime/device/objects/cob_ids.hpp"
#include "runtime/device/objects/service_length.hpp"
#include "runtime/device/objects/service_objects.hpp"
#include "runtime/device/objects/value_limits.hpp"

#include <algorithm>
#include <array>

namespace counterpoint::runtime
{
namespace
{
using cia301::DataType;
using cia301::SdoAbort;

/// What a string that can be written has room for, at least.
constexpr std::size_t kTextRoom = 256U;
constexpr std::uint16_t kHighResolution = 0x1013U;
constexpr std::uint16_t kConsumerTimes = 0x1016U;
constexpr std::uint16_t kDefaultServer = 0x1200U;
constexpr std::uint16_t kFirstApplication = 0x2000U;

constexpr std::uint16_t kHighestPdo = 512U;
constexpr std::uint16_t kFirstRpdo = 0x1400U;
constexpr std::uint16_t kFirstRpdoMap = 0x1600U;
constexpr std::uint16_t kFirstTpdo = 0x1800U;
constexpr std::uint16_t kFirstTpdoMap = 0x1A00U;
constexpr std::uint16_t kLastTpdoMap = 0x1BFFU;
constexpr std::uint8_t kPdoEntries = 64U;
/// 254: source address mode of a multiplexed PDO; 255: destination address mode.
constexpr std::uint64_t kSourceMode = 254U;

/// Its data type for the dictionary. Types have the numbers of CiA 301 there, too; BIT1 to BIT8 become small
/// numbers.
DataType TypeOf(const cia306::Entry& entry)
{
    const bool is_known = entry.data_type != 0U && entry.data_type <= static_cast<std::uint16_t>(DataType::kUnsigned64);
    if (is_known && entry.type.kind != cia306::DataKind::kUnknown)
    {
        return static_cast<DataType>(entry.data_type);
    }
    return (entry.type.kind == cia306::DataKind::kUnsigned) ? DataType::kUnsigned8 : DataType::kOctetString;
}

/// Into which PDOs it may be mapped: process data are sent if they may be read, and received if they may be
/// written.
std::uint8_t UsesOf(const cia306::Entry& entry)
{
    const unsigned uses = (entry.IsInTpdo() ? cia301::kInTpdo : 0U) | (entry.IsInRpdo() ? cia301::kInRpdo : 0U);
    return static_cast<std::uint8_t>(uses | (cia306::IsSaved(entry) ? cia301::kStored : 0U));
}

/// Its access right for the dictionary.
cia301::Access AccessOf(const cia306::Entry& entry)
{
    switch (entry.access)
    {
    case cia306::Access::kConstant:
        return cia301::Access::kConstant;
    case cia306::Access::kReadOnly:
        return cia301::Access::kReadOnly;
    case cia306::Access::kWriteOnly:
        return cia301::Access::kWriteOnly;
    case cia306::Access::kReadWrite:
    case cia306::Access::kReadWriteInput:
    case cia306::Access::kReadWriteOutput:
        return cia301::Access::kReadWrite;
    case cia306::Access::kUnknown:
        break;
    }
    return cia301::Access::kInvalid;
}

/// The hook of an object whose value a service keeps; null: none does.
cia301::NumberHook* HookOf(const cia301::Entry& entry, device::Services& services,
                           const DeviceObjects::FindHook& further)
{
    if (cia301::NumberHook* const hook = further(entry.index))
    {
        return hook;
    }
    switch (entry.index)
    {
    case 0x1005U:
    case 0x1006U:
    case 0x1007U:
    case 0x1019U:
        return &services.sync;
    case 0x1029U:
        return &services.errors;
    case kDefaultServer:
        return &services.sdo_port;
    default:
        break;
    }
    return (entry.index >= kFirstRpdo && entry.index <= kLastTpdoMap) ? &services.pdos : nullptr;
}

bool HasValue(const cia301::Entry& entry, const std::vector<std::uint8_t>& value)
{
    std::vector<std::uint8_t> now(entry.size_bytes);
    const cia301::Reading reading = cia301::ReadEntry(entry, {now.data(), entry.size_bytes});
    now.resize(reading.size_bytes);
    return reading.abort == SdoAbort::kNone && now == value;
}
} // namespace

std::uint8_t LastSubOf(const cia306::Device& file, const std::uint16_t index)
{
    const cia306::Object* const object = file.Find(index);
    return (object == nullptr || object->entries.empty()) ? std::uint8_t{0U} : object->entries.rbegin()->first;
}

DeviceObjects::DeviceObjects(const cia306::Device& device, const std::uint8_t node_id, const IsKernels& is_kernels,
                             const std::uint32_t domain_bytes)
    : file_(device.file), domain_bytes_(domain_bytes)
{
    for (const auto& [index, object] : device.objects)
    {
        for (const auto& [sub, entry] : object.entries)
        {
            const bool has_value = entry.type.kind != cia306::DataKind::kStructure;
            const bool is_the_kernels = is_kernels(index, sub);
            if (has_value && index >= cia306::kFirstObjectIndex && !is_the_kernels)
            {
                Append(object, entry, node_id);
            }
            else if (is_the_kernels && IsOfAService(index))
            {
                left_out_.push_back(KeptByTheKernel(entry));
            }
        }
    }
    table_ = {entries_.data(), static_cast<std::uint32_t>(entries_.size())};
    std::uint32_t longest = kMaxPayloadBytes;
    for (const cia301::Entry& entry : entries_)
    {
        longest = std::max(longest, entry.size_bytes);
    }
    sdo_buffer_.resize(longest);
    supervised_.resize(LastSubOf(device, kConsumerTimes));
    AppendPdos(device);
}

const cia301::EntryTable& DeviceObjects::Table() const noexcept
{
    return table_;
}

device::ServiceRooms DeviceObjects::Rooms() noexcept
{
    return {{supervised_.data(), static_cast<std::uint8_t>(supervised_.size())},
            {tpdos_.data(), static_cast<std::uint16_t>(tpdos_.size())},
            {rpdos_.data(), static_cast<std::uint16_t>(rpdos_.size())},
            {sdo_buffer_.data(), static_cast<std::uint32_t>(sdo_buffer_.size())}};
}

void DeviceObjects::Connect(device::Services& services, const FindHook& further,
                            cia301::NumberHook* const store) noexcept
{
    services_ = &services;
    for (Stored& stored : stored_)
    {
        cia301::Entry& entry = entries_[stored.entry];
        const Keeper keeper = KeeperOf(entry, services, further, store);
        if (cia301::IsSubCount({entry.index, entry.sub}))
        {
            entry.write_hook = &count_;
        }
        else if (keeper.read != nullptr && cia301::HasObject(*keeper.read, {entry.index, entry.sub}))
        {
            entry.read_hook = keeper.read;
            entry.write_hook = keeper.write;
            entry.place = nullptr;
            entry.length_bytes = nullptr;
            const cia301::DataType type = entry.type;
            TakeServiceLength(entry);
            FitNumber(stored.value, type, entry.size_bytes);
        }
    }
}

DeviceObjects::Keeper DeviceObjects::KeeperOf(const cia301::Entry& entry, device::Services& services,
                                              const FindHook& further, cia301::NumberHook* const store)
{
    cia301::NumberHook* hook = IsOfServiceObjects(entry.index) ? &services.objects : HookOf(entry, services, further);
    if (cia301::IsStoreObject(entry.index))
    {
        hook = (store != nullptr && cia301::HasObject(*store, {entry.index, entry.sub})) ? store : nullptr;
        return (hook != nullptr) ? Keeper{hook, hook} : Keeper{&no_store_, &no_store_};
    }
    return {hook, hook};
}

void DeviceObjects::Append(const cia306::Object& object, const cia306::Entry& source, const std::uint8_t node_id)
{
    SetValue(source, node_id);
    Stored& stored = stored_.back();
    if (cia301::IsSubCount({source.index, source.sub}) && !stored.is_configured && !stored.value.empty())
    {
        stored.value.front() = object.entries.rbegin()->first;
    }
    cia301::Entry entry{};
    entry.index = source.index;
    entry.sub = source.sub;
    entry.type = TypeOf(source);
    entry.access = AccessOf(source);
    entry.readable_in = cia301::kInBoth;
    entry.writable_in = cia306::IsStoreCommand(source.index) ? cia301::kInPreOperational : cia301::kInBoth;
    entry.uses = UsesOf(source);
    entry.size_bytes = static_cast<std::uint32_t>((source.type.bits + 7U) / 8U);
    SetRoom(entry, source);
    stored.type_bytes = entry.size_bytes;
    // Of the safety objects 5F00h to 5F05h alone are in this table; the kernel takes them at its start.
    entry.write_hook = source.is_safety ? &fixed_ : nullptr;
    SetLimits(entry, source, node_id);
    entries_.push_back(entry);
}

/// A PDO for each object of communication parameters, with as many fields as its mapping has sub-indices.
void DeviceObjects::AppendPdos(const cia306::Device& device)
{
    for (std::uint16_t number = 1U; number <= kHighestPdo; ++number)
    {
        const auto step = static_cast<std::uint16_t>(number - 1U);
        if (device.Find(static_cast<std::uint16_t>(kFirstRpdo + step)) != nullptr)
        {
            rpdos_.push_back({number, MapOf(device, static_cast<std::uint16_t>(kFirstRpdoMap + step))});
        }
        if (device.Find(static_cast<std::uint16_t>(kFirstTpdo + step)) != nullptr)
        {
            tpdos_.push_back(
                {number, cia301::PdoTrigger::kChange, MapOf(device, static_cast<std::uint16_t>(kFirstTpdoMap + step))});
        }
    }
}

cia301::PdoMap DeviceObjects::MapOf(const cia306::Device& device, const std::uint16_t index)
{
    const cia306::Entry* const count = device.Find(index, 0U);
    if (count != nullptr && count->Configured().IsSet())
    {
        const cia306::ValueResult value = cia306::ConfiguredValue(*count, std::nullopt);
        if (value.value && value.value->bits >= kSourceMode)
        {
            throw cia306::InputError(file_, count->ValuePlace(),
                                     {cia306::ObjectName(index, 0U) + " = " + std::to_string(value.value->bits) +
                                          ", a multiplexed PDO, which is not built",
                                      "a count of mapped objects, 0 to 64"});
        }
    }
    const std::uint8_t room = std::min(LastSubOf(device, index), kPdoEntries);
    fields_.emplace_back(room);
    return {fields_.back().data(), room};
}

/// The value of the file as bytes, 0 where it gives none.
void DeviceObjects::SetValue(const cia306::Entry& source, const std::uint8_t node_id)
{
    Stored stored;
    stored.entry = entries_.size();
    stored.place = source.ValuePlace();
    stored.type_place = source.type_place;
    stored.value.resize((source.type.bits + 7U) / 8U);
    const std::optional<cia306::Value> value = cia306::UsableValue(file_, source, node_id);
    stored.is_configured = value.has_value();
    const auto formula = cia306::ParseFormula(source.Configured().text);
    stored.is_of_node = stored.is_configured && source.type.bits != 0U && formula && formula->has_node_id;
    if (value)
    {
        if (source.type.bits != 0U)
        {
            cia301::ToLittleEndian(value->bits, stored.value.data(), static_cast<std::uint32_t>(stored.value.size()));
        }
        else
        {
            stored.value = cia306::BytesOfText(source.data_type, value->text);
        }
    }
    else if (source.Configured().IsSet())
    {
        LeaveOut(source, source.Configured(), cia306::ConfiguredValue(source, node_id).problem);
    }
    stored_.push_back(stored);
}

void DeviceObjects::LeaveOut(const cia306::Entry& source, const cia306::Text& text, const cia306::Problem& problem)
{
    left_out_.push_back({cia306::Severity::kWarning, text.place, cia306::ObjectName(source.index, source.sub),
                         problem.wrong + " is left out, expected " + problem.expected});
}

void DeviceObjects::SetRoom(cia301::Entry& entry, const cia306::Entry& source)
{
    std::vector<std::uint8_t> room = stored_.back().value;
    if (source.type.bits == 0U)
    {
        lengths_.push_back(static_cast<std::uint32_t>(room.size()));
        entry.length_bytes = &lengths_.back();
        const std::size_t least = (source.data_type == cia306::kDomainType) ? domain_bytes_ : kTextRoom;
        room.resize(std::max(room.size(), source.IsFixed() ? std::size_t{1U} : least));
        entry.size_bytes = static_cast<std::uint32_t>(room.size());
    }
    memory_.push_back(std::move(room));
    entry.place = memory_.back().data();
}

/// Its limits, and what it begins with where they leave 0 out.
void DeviceObjects::SetLimits(cia301::Entry& entry, const cia306::Entry& source, const std::uint8_t node_id)
{
    const std::optional<cia301::ValueLimits> limits =
        LimitsOf(source, entry.type, node_id, [this, &source](const cia306::Text& text, const cia306::Problem& problem)
                 { LeaveOut(source, text, problem); });
    if (!limits)
    {
        return;
    }
    limits_.push_back(*limits);
    entry.limits = &limits_.back();
    Stored& stored = stored_.back();
    const bool is_count = cia301::IsSubCount({entry.index, entry.sub});
    if (!stored.is_configured && !is_count && cia301::IsNumber(entry.type))
    {
        cia301::ToLittleEndian(FirstValue(*limits, entry.type), stored.value.data(), entry.size_bytes);
        std::copy(stored.value.begin(), stored.value.end(), entry.place);
    }
}

void DeviceObjects::LoadApplication() noexcept
{
    for (const Stored& stored : stored_)
    {
        if (entries_[stored.entry].index >= kFirstApplication)
        {
            Load(stored);
        }
    }
}

void DeviceObjects::LoadCommunication() noexcept
{
    refusals_ = left_out_;
    for (const Stored& stored : stored_)
    {
        if (entries_[stored.entry].index < kFirstApplication)
        {
            Load(stored);
        }
    }
}

void DeviceObjects::Load(const Stored& stored) noexcept
{
    cia301::Entry& entry = entries_[stored.entry];
    const auto size = static_cast<std::uint32_t>(stored.value.size());
    if (entry.place != nullptr)
    {
        std::copy(stored.value.begin(), stored.value.end(), entry.place);
        if (entry.length_bytes != nullptr)
        {
            *entry.length_bytes = size;
        }
        return;
    }
    if (!stored.is_configured || cia301::IsOwnObject(entry.index))
    {
        return;
    }
    const SdoAbort abort = cia301::WriteEntry(entry, {stored.value.data(), size}, cia301::Attempt::kFirst);
    if (abort != SdoAbort::kNone)
    {
        const std::uint64_t number = cia301::FromLittleEndian(stored.value.data(), std::min(size, entry.size_bytes));
        const std::string expected = IsCobId(entry.index, entry.sub) ? ExpectedIdentifier(number) : "";
        refusals_.push_back({cia306::Severity::kWarning, stored.place, cia306::ObjectName(entry.index, entry.sub),
                             "the device refuses this value with abort code " +
                                 cia306::Hex(static_cast<std::uint32_t>(abort), 8) + ", expected " +
                                 (expected.empty() ? "one of the object's range" : expected)});
    }
}

/// The table has the order of `stored_`.
bool DeviceObjects::IsNodeDefault(const std::uint32_t number, const cia301::Bytes& value) const noexcept
{
    const Stored& stored = stored_[number];
    return stored.is_of_node &&
           std::equal(stored.value.begin(), stored.value.end(), value.data, value.data + value.size_bytes);
}

const std::vector<cia306::Finding>& DeviceObjects::Refusals() const noexcept
{
    return refusals_;
}

std::vector<cia306::Finding> DeviceObjects::NotTaken(const std::function<bool(const ObjectAddress&)>& is_replaced) const
{
    std::vector<cia306::Finding> findings;
    for (const Stored& stored : stored_)
    {
        const cia301::Entry& entry = entries_[stored.entry];
        const std::string object = cia306::ObjectName(entry.index, entry.sub);
        const bool is_refused = std::any_of(refusals_.begin(), refusals_.end(), [&](const cia306::Finding& refusal)
                                            { return refusal.place == stored.place && refusal.object == object; });
        if (entry.place != nullptr)
        {
            continue;
        }
        const bool is_own = cia301::IsOwnObject(entry.index) && entry.index != kDefaultServer;
        // 1013h is a time that goes on.
        const bool is_other = entry.index == kHighResolution || is_replaced({entry.index, entry.sub});
        if (entry.size_bytes != stored.type_bytes)
        {
            findings.push_back({cia306::Severity::kWarning, stored.type_place, object,
                                "data type of " + std::to_string(8U * stored.type_bytes) + " bit, expected one of " +
                                    std::to_string(8U * entry.size_bytes) + " bit, which the device has here"});
        }
        else if (!is_refused && stored.is_configured && !is_own && !is_other && !HasValue(entry, stored.value))
        {
            findings.push_back({cia306::Severity::kWarning, stored.place, object, ReasonOf(entry, stored.value)});
        }
    }
    AddShared(findings, is_replaced);
    return findings;
}

/// Objects of services with one identifier, but for those of which none is the file's.
void DeviceObjects::AddShared(std::vector<cia306::Finding>& findings,
                              const std::function<bool(const ObjectAddress&)>& is_replaced) const
{
    const bool is_connected = services_ != nullptr;
    const OwnIdentifiers own{is_connected ? services_->emergency.CobId() : cia301::kCobOff,
                             is_connected ? services_->node.value : std::uint8_t{0U}};
    for (const SharedIdentifier& shared : SharedIdentifiers(table_, own))
    {
        const cia301::Entry& entry = entries_[shared.entry];
        if (!is_replaced({entry.index, entry.sub}))
        {
            findings.push_back({cia306::Severity::kWarning, stored_[shared.entry].place,
                                cia306::ObjectName(entry.index, entry.sub),
                                shared.problem.wrong + ", expected " + shared.problem.expected});
        }
    }
}

/// Why a service has not this value; Connect has named the services.
std::string DeviceObjects::ReasonOf(const cia301::Entry& entry, const std::vector<std::uint8_t>& value) const
{
    constexpr std::uint32_t kByteBits = 8U;
    const bool is_mapping = cia301::IsPdoMapping(entry.index);
    const bool is_pdo = entry.index >= kFirstRpdo && entry.index < kFirstTpdoMap && !is_mapping && entry.sub == 1U;
    if (is_pdo)
    {
        const std::uint64_t cob_id = cia301::FromLittleEndian(value.data(), static_cast<std::uint32_t>(value.size()));
        const auto identifier = static_cast<std::uint32_t>(cob_id & cia301::kCobIdentifier);
        const bool is_taken = cia301::IsConfigurable(identifier) &&
                              !services_->Allows({entry.index, entry.sub}, static_cast<std::uint32_t>(cob_id));
        const std::string expected = ExpectedIdentifier(cob_id);
        return is_taken ? "the device has turned this PDO off, expected another identifier than " +
                              cia306::Hex(identifier, 3) + ", which is that of " + OwnerOf(table_, entry, identifier)
                        : "the device has turned this PDO off, expected " +
                              (expected.empty() ? "a mapping and settings that hold" : expected);
    }
    if (entry.index == kDefaultServer)
    {
        return "the device does without this value, expected the identifier of the default SDO";
    }
    const std::uint64_t mapping = cia301::FromLittleEndian(value.data(), static_cast<std::uint32_t>(value.size()));
    const auto index = static_cast<std::uint16_t>((mapping >> 16U) & 0xFFFFU);
    const auto sub = static_cast<std::uint8_t>((mapping >> kByteBits) & 0xFFU);
    const std::uint64_t bits = mapping & 0xFFU;
    const auto mapped = std::find_if(entries_.begin(), entries_.end(), [index, sub](const cia301::Entry& each)
                                     { return each.index == index && each.sub == sub; });
    if (!is_mapping || entry.sub == 0U)
    {
        return "the device does without this value, expected one that goes with the others";
    }
    const std::string name = cia306::ObjectName(index, sub);
    const bool is_there = mapped != entries_.end();
    const bool is_boolean = is_there && mapped->type == DataType::kBoolean;
    const std::uint32_t object_bits = is_there ? kByteBits * mapped->size_bytes : 0U;
    if (!is_there || bits == object_bits || (is_boolean && bits == 1U))
    {
        return "the device does without this field, expected an object that may be mapped here, which " + name +
               " may not";
    }
    return "the device does without this field of " + std::to_string(bits) + " bit, expected " +
           (is_boolean ? "1 or " : "") + std::to_string(object_bits) + " bit, the length of " + name;
}
} // namespace counterpoint::runtime
