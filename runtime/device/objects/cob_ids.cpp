// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/objects/cob_ids.hpp"

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/dictionary/entry_value.hpp"
#include "canopen/cia301/dictionary/object_kinds.hpp"

#include <algorithm>
#include <array>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint16_t kSync = 0x1005U;
constexpr std::uint16_t kTime = 0x1012U;
constexpr std::uint16_t kEmergency = 0x1014U;
constexpr std::uint16_t kSources = 0x1028U;
constexpr std::uint16_t kDefaultServer = 0x1200U;
constexpr std::uint16_t kFirstRpdo = 0x1400U;
constexpr std::uint16_t kFirstRpdoMap = 0x1600U;
constexpr std::uint16_t kFirstTpdoMap = 0x1A00U;
constexpr std::uint32_t kDefaultSync = 0x80U;
constexpr std::uint32_t kDefaultRequests = 0x600U;
constexpr std::uint32_t kDefaultAnswers = 0x580U;

std::uint32_t NumberNow(const cia301::Entry& entry)
{
    std::array<std::uint8_t, sizeof(std::uint64_t)> bytes{};
    const auto room = static_cast<std::uint32_t>(bytes.size());
    const bool has_number =
        entry.read_hook != nullptr && cia301::ReadEntry(entry, {bytes.data(), room}).abort == cia301::SdoAbort::kNone;
    return has_number ? static_cast<std::uint32_t>(cia301::FromLittleEndian(bytes.data(), sizeof(std::uint32_t)))
                      : cia301::kCobOff;
}

bool IsPdo(const std::uint16_t index) noexcept
{
    return index >= kFirstRpdo && index < kFirstTpdoMap && !cia301::IsPdoMapping(index);
}

/// Whether this object has a COB-ID, which is on with the value that it has now.
bool HasCobId(const cia301::Entry& entry)
{
    const bool has_it = IsCobId(entry.index, entry.sub);
    const std::uint32_t value = has_it ? NumberNow(entry) : cia301::kCobOff;
    const bool is_time = entry.index == kTime;
    return entry.index == kSync ||
           (is_time ? (value & (cia301::kCobOff | cia301::kCobBit30)) != 0U : (value & cia301::kCobOff) == 0U);
}

bool IsThere(const cia301::EntryTable& table, const std::uint16_t index)
{
    return std::any_of(table.entries, table.entries + table.count,
                       [index](const cia301::Entry& entry) { return entry.index == index; });
}

/// Who has this identifier without an object of the file that says so; empty: nobody.
std::string OwnerWithout(const cia301::EntryTable& table, const cia301::Entry& entry, const std::uint32_t identifier,
                         const OwnIdentifiers& own)
{
    const bool is_of_emergency = entry.index == kEmergency || entry.index == kSources;
    if (identifier == kDefaultSync && entry.index != kSync && !IsThere(table, kSync))
    {
        return "SYNC";
    }
    if (identifier == own.emergency && !is_of_emergency && !IsThere(table, kEmergency))
    {
        return "the emergencies of this device";
    }
    const bool is_server = identifier == kDefaultRequests + own.node_id || identifier == kDefaultAnswers + own.node_id;
    return is_server ? "the default SDO server of this device" : "";
}

/// The objects of services before this one that have its identifier now, and who has it without an object.
std::vector<std::string> OwnersBefore(const cia301::EntryTable& table, const std::size_t place,
                                      const OwnIdentifiers& own)
{
    const cia301::Entry& entry = table.entries[place];
    const std::uint32_t identifier = NumberNow(entry) & cia301::kCobIdentifier;
    std::vector<std::string> owners;
    const std::string unnamed = OwnerWithout(table, entry, identifier, own);
    if (!unnamed.empty())
    {
        owners.push_back(unnamed);
    }
    for (std::size_t other = 0U; other < place; ++other)
    {
        const cia301::Entry& each = table.entries[other];
        // 1028h may be a list of all devices, this one among them.
        const bool may_share = each.index == kEmergency && entry.index == kSources;
        const bool is_on = !may_share && HasCobId(each); // None of them is a PDO: those are behind all others.
        if (is_on && (NumberNow(each) & cia301::kCobIdentifier) == identifier)
        {
            owners.push_back(cia306::ObjectName(each.index, each.sub));
        }
    }
    return owners;
}
} // namespace

bool IsCobId(const std::uint16_t index, const std::uint8_t sub) noexcept
{
    const bool is_first = sub == 1U;
    const bool is_sdo = index > kDefaultServer && index < kFirstRpdo && (is_first || sub == 2U);
    const bool is_source = index == kSources && sub > 0U;
    return is_sdo || is_source || (is_first && IsPdo(index)) || index == kSync || index == kTime || index == kEmergency;
}

std::vector<SharedIdentifier> SharedIdentifiers(const cia301::EntryTable& table, const OwnIdentifiers& own)
{
    std::vector<SharedIdentifier> shared;
    for (std::size_t place = 0U; place < table.count; ++place)
    {
        const cia301::Entry& entry = table.entries[place];
        const bool is_on = !IsPdo(entry.index) && HasCobId(entry);
        std::string names;
        for (const std::string& owner : is_on ? OwnersBefore(table, place, own) : std::vector<std::string>{})
        {
            names += (names.empty() ? "" : " and ") + owner;
        }
        if (!names.empty())
        {
            const std::string identifier = cia306::Hex(NumberNow(entry) & cia301::kCobIdentifier, 3);
            shared.push_back({place,
                              {"COB-ID " + identifier + " is in use by " + names + ", too, and the device keeps all",
                               "an identifier of its own"}});
        }
    }
    return shared;
}

std::string OwnerOf(const cia301::EntryTable& table, const cia301::Entry& pdo, const std::uint32_t identifier)
{
    const auto is_rpdo = [](const cia301::Entry& each)
    { return each.index >= kFirstRpdo && each.index < kFirstRpdoMap; };
    for (std::size_t place = 0U; place < table.count; ++place)
    {
        const cia301::Entry& each = table.entries[place];
        const bool is_other = each.index != pdo.index && !(is_rpdo(each) && is_rpdo(pdo));
        if (is_other && HasCobId(each) && (NumberNow(each) & cia301::kCobIdentifier) == identifier)
        {
            return cia306::ObjectName(each.index, each.sub);
        }
    }
    return identifier == kDefaultSync ? "SYNC" : "the emergencies of this device";
}

std::string ExpectedIdentifier(const std::uint64_t cob_id)
{
    struct Range
    {
        std::uint64_t last;
        const char* owner;
    };
    // What CiA 301 keeps from configurable objects, and whose it is.
    constexpr std::array<Range, 6U> kOwners{{{0x07FU, "of NMT and GFC"},
                                             {0x180U, "of SRDOs"},
                                             {0x5FFU, "of the default SDOs"},
                                             {0x67FU, "of the default SDOs"},
                                             {0x6FFU, "that CiA 301 reserves"},
                                             {0x7FFU, "of error control and LSS"}}};
    const std::uint64_t identifier = cob_id & cia301::kCobIdentifier;
    const auto owner = std::find_if(kOwners.begin(), kOwners.end(),
                                    [identifier](const Range& range) { return identifier <= range.last; });
    if ((cob_id & cia301::kCobExtended) != 0U || owner == kOwners.end())
    {
        return "an identifier of 11 bit";
    }
    if (cia301::IsConfigurable(static_cast<std::uint32_t>(identifier)))
    {
        return "";
    }
    return "another identifier than " + cia306::Hex(identifier, 3) + ", which is one " + owner->owner;
}
} // namespace counterpoint::runtime
