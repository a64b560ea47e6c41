// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/dictionary.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/dictionary/entry_value.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/network_plan/concise_maker.hpp"
#include "runtime/manager/report/texts.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
using cia301::Access;
using cia301::DataType;
using cia301::SdoAbort;

constexpr std::uint32_t kConciseRoom = 65536U; ///< Of a concise DCF that a client downloads.
constexpr std::uint32_t kSdoTimeOutUs = 1000000U;
constexpr std::uint8_t kSdoBlock = 127U;
constexpr std::uint8_t kAllSub = 0x80U;
constexpr std::uint16_t kNmtIndex = 0x1F82U;

/// An array by node-ID.
struct Array
{
    std::uint16_t index;
    DataType type;
    Access access;
};
constexpr Array kArrays[] = {
    {0x1F20U, DataType::kDomain, Access::kReadOnly},      {0x1F21U, DataType::kUnsigned8, Access::kReadOnly},
    {0x1F22U, DataType::kDomain, Access::kReadWrite},     {0x1F25U, DataType::kUnsigned32, Access::kWriteOnly},
    {0x1F26U, DataType::kUnsigned32, Access::kReadWrite}, {0x1F27U, DataType::kUnsigned32, Access::kReadWrite},
    {0x1F53U, DataType::kUnsigned32, Access::kReadWrite}, {0x1F54U, DataType::kUnsigned32, Access::kReadWrite},
    {0x1F55U, DataType::kUnsigned32, Access::kReadWrite}, {0x1F58U, DataType::kDomain, Access::kReadOnly},
    {0x1F81U, DataType::kUnsigned32, Access::kReadWrite}, {0x1F82U, DataType::kUnsigned8, Access::kReadWrite},
    {0x1F83U, DataType::kUnsigned8, Access::kReadWrite},  {0x1F84U, DataType::kUnsigned32, Access::kReadWrite},
    {0x1F85U, DataType::kUnsigned32, Access::kReadWrite}, {0x1F86U, DataType::kUnsigned32, Access::kReadWrite},
    {0x1F87U, DataType::kUnsigned32, Access::kReadWrite}, {0x1F88U, DataType::kUnsigned32, Access::kReadWrite},
    {0x1F8AU, DataType::kUnsigned8, Access::kReadWrite}};

bool HasAllSub(const std::uint16_t index)
{
    return index == 0x1F25U || index == 0x1F82U || index == 0x1F83U;
}

/// An object as a person reads it: with its node, where the sub-index is one. [SRS_MGR_141]
std::string NameOf(const ObjectAddress& object)
{
    const bool is_of_nodes = std::any_of(std::begin(kArrays), std::end(kArrays),
                                         [&object](const auto& row) { return row.index == object.index; });
    const bool is_node = is_of_nodes && object.sub >= 1U && object.sub <= cia302::kLastNode;
    return cia306::ObjectName(object.index, object.sub) + (is_node ? " (node " + std::to_string(object.sub) + ")" : "");
}

/// What a person may do about a refusal.
std::string RemedyOf(const ObjectAddress& object, const SdoAbort abort)
{
    std::string remedy = "what the object takes";
    remedy = (abort == SdoAbort::kReadOnly) ? "an object that may change, and not of a safety slave" : remedy;
    remedy = (abort == SdoAbort::kDeviceState) ? "it in another state: docs/manager.md has the rules" : remedy;
    remedy = (abort == SdoAbort::kPending) ? "it later: too many commands wait" : remedy;
    remedy = (abort == SdoAbort::kValueRange) ? "another value, or another node" : remedy;
    const bool is_state = abort == SdoAbort::kValueRange && object.index == kNmtIndex;
    return is_state ? "4, 5, 6 (reset), 7 (reset-comm) or 127 of a node of the network" : remedy;
}

/// Why a slave of the network does not take a command that 1F82h knows: its state does not allow it. Empty: another
/// reason. [SRS_MGR_474]
std::string StateReason(const ManagerAssembly& assembly, const ObjectAddress& object, const std::uint64_t value)
{
    constexpr std::uint64_t kCommands[] = {4U, 5U, 6U, 7U, 127U};
    const bool is_known = std::find(std::begin(kCommands), std::end(kCommands), value) != std::end(kCommands);
    const cia302::NodeId node{object.sub};
    std::string reason;
    if (object.index == kNmtIndex && is_known && object.sub == kAllSub)
    {
        reason = ", expected slaves in a state that allows it";
    }
    else if (object.index == kNmtIndex && is_known && assembly.Net().Setup().IsListed(node))
    {
        reason = ", node " + std::to_string(node.value) + " is in " +
                 StatusText(assembly.Net().Plan().manager.profile, assembly.Core().Status(node)) +
                 ", expected a state that allows it";
    }
    return reason;
}

std::uint32_t SizeOf(const DataType type)
{
    std::uint32_t size_bytes = 4U;
    size_bytes = (type == DataType::kUnsigned8) ? 1U : size_bytes;
    size_bytes = (type == DataType::kUnsigned16) ? 2U : size_bytes;
    return (type == DataType::kDomain) ? kConciseRoom : size_bytes;
}

NmtState StateOf(const cia301::NodeState state)
{
    NmtState known = NmtState::kInitialising;
    known = (state == cia301::NodeState::kPreOperational) ? NmtState::kPreOperational : known;
    known = (state == cia301::NodeState::kOperational) ? NmtState::kOperational : known;
    return (state == cia301::NodeState::kStopped) ? NmtState::kStopped : known;
}

/// As long as the longest object that is read or written.
std::size_t LongestDomain(const network_plan::LoadedNetwork& net)
{
    std::size_t longest = kConciseRoom;
    for (const auto& slave : net.Slaves())
    {
        longest = std::max({longest, slave->dcf_text.size(), slave->concise.size(), slave->program.size()});
    }
    return longest;
}
} // namespace

ManagerDictionary::ManagerDictionary(ManagerAssembly& assembly, network_plan::LoadedNetwork& net,
                                     cia301::FrameSink& sink)
    : assembly_(assembly), net_(net), objects_(assembly, net), buffer_(LongestDomain(net)),
      dictionary_(
          [this]
          {
              AddIdentity();
              AddConsumers();
              AddNetwork();
              AddFlying();
              Sort();
              return cia301::EntryTable{entries_.data(), static_cast<std::uint32_t>(entries_.size())};
          }(),
          no_safety_),
      server_({dictionary_, {buffer_.data(), static_cast<std::uint32_t>(buffer_.size())}, kSdoTimeOutUs, kSdoBlock}),
      port_(server_, sink, net.Setup().own)
{
}

void ManagerDictionary::AddBytes(const std::uint16_t index, const std::uint8_t sub, const DataType type,
                                 std::vector<std::uint8_t> value)
{
    values_.push_back(std::move(value));
    cia301::Entry entry{};
    entry.index = index;
    entry.sub = sub;
    entry.type = type;
    entry.access = Access::kReadOnly;
    entry.readable_in = cia301::kInBoth;
    entry.size_bytes = static_cast<std::uint32_t>(values_.back().size());
    entry.place = values_.back().data();
    entries_.push_back(entry);
}

void ManagerDictionary::AddValue(const std::uint16_t index, const std::uint8_t sub, const DataType type,
                                 const std::uint32_t value)
{
    std::vector<std::uint8_t> bytes(SizeOf(type));
    cia301::ToLittleEndian(value, bytes.data(), SizeOf(type));
    AddBytes(index, sub, type, std::move(bytes));
}

void ManagerDictionary::AddHook(const std::uint16_t index, const std::uint8_t sub, const DataType type,
                                const Access access)
{
    cia301::Entry entry{};
    entry.index = index;
    entry.sub = sub;
    entry.type = type;
    entry.access = access;
    entry.readable_in = cia301::kInBoth;
    entry.writable_in = cia301::kInBoth;
    entry.size_bytes = SizeOf(type);
    entry.length_bytes = (type == DataType::kDomain) ? &domain_length_ : nullptr;
    entry.read_hook = &objects_;
    entry.write_hook = &objects_;
    entries_.push_back(entry);
}

void ManagerDictionary::AddArray(const std::uint16_t index, const DataType type, const Access access)
{
    const std::uint8_t last = HasAllSub(index) ? kAllSub : cia302::kLastNode;
    AddValue(index, 0U, DataType::kUnsigned8, last);
    for (std::uint8_t sub = 1U; sub <= last; ++sub)
    {
        AddHook(index, sub, type, (sub == kAllSub) ? Access::kWriteOnly : access);
    }
}

/// Of its DCF; a manager without one is a device without a profile and a vendor. [SRS_MGR_150]
void ManagerDictionary::AddIdentity()
{
    constexpr std::uint16_t kIdentity = 0x1018U;
    const auto own = [this](const std::uint16_t index, const std::uint8_t sub)
    {
        const cia306::Entry* const entry = net_.Device().Find(index, sub);
        const bool is_there =
            entry != nullptr &&
            cia306::UsableValue(net_.Device().file, *entry, net_.Setup().own.value).has_value(); // [SRS_EDS_032]
        return is_there ? network_plan::BytesOf(net_.Device(), *entry, net_.Setup().own.value)
                        : std::vector<std::uint8_t>{};
    };
    const auto number = [&own](const std::uint16_t index, const std::uint8_t sub)
    {
        const std::vector<std::uint8_t> bytes = own(index, sub);
        return static_cast<std::uint32_t>(cia301::FromLittleEndian(
            bytes.data(), static_cast<std::uint32_t>(std::min<std::size_t>(bytes.size(), 4U))));
    };
    AddValue(0x1000U, 0U, DataType::kUnsigned32, number(0x1000U, 0U));
    AddValue(0x1001U, 0U, DataType::kUnsigned8, 0U);
    AddValue(0x1006U, 0U, DataType::kUnsigned32, net_.Setup().sync_period_us);
    for (const std::uint16_t index : {std::uint16_t{0x1008U}, std::uint16_t{0x1009U}, std::uint16_t{0x100AU}})
    {
        std::vector<std::uint8_t> text = own(index, 0U);
        if (!text.empty())
        {
            AddBytes(index, 0U, DataType::kVisibleString, std::move(text));
        }
    }
    AddHook(0x1017U, 0U, DataType::kUnsigned16, Access::kReadWrite);
    AddValue(kIdentity, 0U, DataType::kUnsigned8, 4U);
    for (std::uint8_t sub = 1U; sub <= 4U; ++sub)
    {
        AddValue(kIdentity, sub, DataType::kUnsigned32, number(kIdentity, sub));
    }
}

void ManagerDictionary::AddConsumers()
{
    constexpr std::uint16_t kConsumers = 0x1016U;
    AddValue(kConsumers, 0U, DataType::kUnsigned8, cia302::kLastNode);
    for (std::uint8_t sub = 1U; sub <= cia302::kLastNode; ++sub)
    {
        AddHook(kConsumers, sub, DataType::kUnsigned32, Access::kReadWrite);
    }
}

void ManagerDictionary::AddNetwork()
{
    AddHook(0x102AU, 0U, DataType::kUnsigned16, Access::kReadWrite);
    AddHook(0x1F80U, 0U, DataType::kUnsigned32, Access::kReadWrite);
    AddHook(0x1F89U, 0U, DataType::kUnsigned32, Access::kReadWrite);
    for (const Array& array : kArrays)
    {
        AddArray(array.index, array.type, array.access);
    }
}

void ManagerDictionary::AddFlying()
{
    constexpr std::uint8_t kLastSub = 6U;
    if (assembly_.Core().Role().Flying() != nullptr)
    {
        AddValue(cia302::kFlyingMasterIndex, 0U, DataType::kUnsigned8, kLastSub);
        for (std::uint8_t sub = 1U; sub <= kLastSub; ++sub)
        {
            AddHook(cia302::kFlyingMasterIndex, sub, DataType::kUnsigned16, Access::kReadWrite);
        }
    }
}

void ManagerDictionary::Sort()
{
    std::sort(entries_.begin(), entries_.end(), [](const cia301::Entry& left, const cia301::Entry& right)
              { return cia301::KeyOf(left.index, left.sub) < cia301::KeyOf(right.index, right.sub); });
}

cia301::Moment ManagerDictionary::Begin(const Instant now)
{
    const cia301::NodeState state = assembly_.Core().OwnState();
    objects_.SetNow(now);
    dictionary_.SetNmtState(StateOf(state));
    return {state, now};
}

void ManagerDictionary::OnFrame(const CanFrame& frame, const Instant now)
{
    if (port_.Wants(frame.identifier))
    {
        port_.OnFrame(frame, Begin(now));
    }
}

void ManagerDictionary::OnCycle(const Instant now)
{
    port_.OnCycle(Begin(now));
}

std::string ManagerDictionary::Get(const ObjectAddress& object, const Instant now)
{
    static_cast<void>(Begin(now));
    const cia301::Entry* const entry = dictionary_.Find(object);
    const std::string name = NameOf(object);
    if (entry == nullptr)
    {
        return "no object " + name + ", expected one of the manager";
    }
    const cia301::Room room{buffer_.data(), static_cast<std::uint32_t>(buffer_.size())};
    const bool is_busy = server_.IsBusy() && !cia301::IsNumber(entry->type);
    std::array<std::uint8_t, kMaxPayloadBytes> bytes{};
    const bool is_number = cia301::IsNumber(entry->type);
    const cia301::Room place = is_number ? cia301::Room{bytes.data(), kMaxPayloadBytes} : room;
    cia301::Reading reading{SdoAbort::kDeviceState, 0U};
    reading = is_busy ? reading : cia301::ReadEntry(*entry, place);
    reading.abort = (entry->access == Access::kWriteOnly) ? SdoAbort::kWriteOnly : reading.abort;
    if (reading.abort != SdoAbort::kNone)
    {
        return name + ": " + AbortText(reading.abort) + ", expected an object that can be read now";
    }
    const std::uint64_t number = cia301::FromLittleEndian(bytes.data(), is_number ? reading.size_bytes : 0U);
    return name + " = " +
           (is_number ? std::to_string(number) + " (" + cia306::Hex(number, 1) + ")"
                      : std::to_string(reading.size_bytes) + " bytes");
}

bool ManagerDictionary::CanSet(const ObjectAddress& object) const noexcept
{
    const cia301::Entry* const entry = dictionary_.Find(object);
    return entry != nullptr && cia301::IsNumber(entry->type) &&
           (entry->access == Access::kReadWrite || entry->access == Access::kWriteOnly);
}

std::string ManagerDictionary::Set(const ObjectAddress& object, const std::uint64_t value, const Instant now)
{
    static_cast<void>(Begin(now));
    const cia301::Entry* const entry = dictionary_.Find(object);
    const std::string name = NameOf(object);
    if (!CanSet(object))
    {
        return "no number " + name + " that can be written, expected one of the manager";
    }
    constexpr std::uint32_t kBitsOfByte = 8U;
    if ((value >> (kBitsOfByte * entry->size_bytes)) != 0U)
    {
        return name + " = " + std::to_string(value) + ", expected at most " + std::to_string(entry->size_bytes) +
               " bytes";
    }
    const SdoAbort abort = dictionary_.WriteNumber(object, value, entry->size_bytes);
    // No other answer of the active master to a command is this one.
    if (abort == SdoAbort::kDeviceState && object.index == kNmtIndex && assembly_.Core().IsActive())
    {
        return WordOf(cia302::NmtAnswer::kOtherDevice);
    }
    const std::string state = (abort == SdoAbort::kValueRange) ? StateReason(assembly_, object, value) : "";
    return (abort == SdoAbort::kNone) ? "taken"
                                      : name + " = " + std::to_string(value) + ": " + AbortText(abort) +
                                            (state.empty() ? ", expected " + RemedyOf(object, abort) : state);
}
} // namespace counterpoint::runtime
