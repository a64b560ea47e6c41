// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/objects.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/network_plan/start_up_bits.hpp"

#include <algorithm>
#include <string>

namespace counterpoint::runtime
{
namespace
{
using cia301::SdoAbort;
using cia302::NodeId;

constexpr std::uint16_t kConsumers = 0x1016U;
constexpr std::uint16_t kProducer = 0x1017U;
constexpr std::uint16_t kInhibit = 0x102AU;
constexpr std::uint16_t kDcf = 0x1F20U;
constexpr std::uint16_t kFormat = 0x1F21U;
constexpr std::uint16_t kConcise = 0x1F22U;
constexpr std::uint16_t kConfigure = 0x1F25U;
constexpr std::uint16_t kProgram = 0x1F58U;
constexpr std::uint16_t kStartUp = 0x1F80U;
constexpr std::uint16_t kAssignment = 0x1F81U;
constexpr std::uint16_t kNmt = 0x1F82U;
constexpr std::uint16_t kGuarding = 0x1F83U;
constexpr std::uint16_t kBootTime = 0x1F89U;
constexpr std::uint32_t kReservedAssignment = 0x02U;
constexpr std::uint32_t kFixedBits = cia302::kIsMaster | cia302::kFlyingMaster;

bool IsDomain(const std::uint16_t index)
{
    return index == kDcf || index == kConcise || index == kProgram;
}

/// A number of this device, as bytes.
cia301::Reading Number(const std::uint32_t value, const std::uint32_t size_bytes, const cia301::Room& room)
{
    cia301::Reading reading{SdoAbort::kOutOfMemory, size_bytes};
    if (size_bytes <= room.size_bytes)
    {
        cia301::ToLittleEndian(value, room.data, size_bytes);
        reading.abort = SdoAbort::kNone;
    }
    return reading;
}

cia301::Reading Text(const std::string& text, const cia301::Room& room)
{
    cia301::Reading reading{SdoAbort::kOutOfMemory, static_cast<std::uint32_t>(text.size())};
    if (text.size() <= room.size_bytes)
    {
        std::copy(text.begin(), text.end(), room.data);
        reading.abort = SdoAbort::kNone;
    }
    return reading;
}
} // namespace

ManagerObjects::ManagerObjects(ManagerAssembly& assembly, network_plan::LoadedNetwork& net)
    : assembly_(assembly), net_(net), objects_({net.Setup(), &net.SetupRoom(), net.SlaveRoom(),
                                                assembly.Core().ProfileParts().table, assembly.Profile()}),
      domains_(net.Setup()), flying_(assembly.FlyingTimes()), consumers_(assembly, net)
{
}

void ManagerObjects::SetNow(const Instant now) noexcept
{
    now_ = now;
    objects_.OnCycle(now);
}

cia301::Reading ManagerObjects::OnRead(const ObjectAddress& address, const cia301::Room& room) noexcept
{
    if (IsDomain(address.index))
    {
        return ReadDomain(address, room);
    }
    if (address.index == kProducer)
    {
        return Number(assembly_.Core().Heartbeat().PeriodMs(), 2U, room);
    }
    if (address.index == kConsumers)
    {
        return Number(consumers_.Value(address.sub), 4U, room);
    }
    if (address.index == kNmt && address.sub == net_.Setup().own.value)
    {
        return Number(cia301::StateByte(assembly_.Core().OwnState()), 1U, room); // Nobody hears itself.
    }
    if (address.index == kFormat)
    {
        return Number(0U, 1U, room); // Text, not compressed.
    }
    return (address.index == cia302::kFlyingMasterIndex) ? flying_.OnRead(address, room)
                                                         : objects_.OnRead(address, room);
}

/// What is not there is no empty domain.
cia301::Reading ManagerObjects::ReadDomain(const ObjectAddress& address, const cia301::Room& room) noexcept
{
    const network_plan::LoadedSlave* const slave = net_.Find(address.sub);
    const bool is_dcf = address.index == kDcf && slave != nullptr;
    cia301::Reading reading = is_dcf ? Text(slave->dcf_text, room) : domains_.OnRead(address, room);
    const bool is_empty = reading.abort == SdoAbort::kNone && reading.size_bytes == 0U;
    reading.abort = is_empty ? SdoAbort::kNoData : reading.abort;
    return reading;
}

SdoAbort ManagerObjects::OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept
{
    const bool is_number = !IsDomain(address.index);
    const auto number = static_cast<std::uint32_t>(is_number ? cia301::FromLittleEndian(value.data, value.size_bytes)
                                                             : std::uint64_t{0U});
    const SdoAbort abort = MayWrite(address, number);
    return (abort == SdoAbort::kNone) ? Store(address, value) : abort;
}

/// Only a command is delayed (1F82h).
SdoAbort ManagerObjects::OnWriteAgain(const ObjectAddress& address, const cia301::Bytes& value) noexcept
{
    return assembly_.Core().IsActive() ? objects_.OnWriteAgain(address, value) : OnWrite(address, value);
}

SdoAbort ManagerObjects::MayWrite(const ObjectAddress& address, const std::uint32_t value) const noexcept
{
    const auto unless = [](const bool is_wrong, const SdoAbort abort) { return is_wrong ? abort : SdoAbort::kNone; };
    const cia302::FlyingMaster* const flying = assembly_.Core().Role().Flying();
    switch (address.index)
    {
    case kConsumers: // See there.
    case kProducer:
    case kInhibit:
    case kBootTime:
        return SdoAbort::kNone;
    case kNmt:
        return unless(!assembly_.Core().IsActive() || IsDoubtedStart(address.sub, value), SdoAbort::kDeviceState);
    case kConfigure:
    case kGuarding:
        return unless(!assembly_.Core().IsActive(), SdoAbort::kDeviceState);
    case kStartUp:
    {
        const std::uint32_t changed = value ^ net_.Setup().start_up;
        const bool has_no_effect = (changed & ~network_plan::StartUpBits(net_.Plan().manager.profile)) != 0U;
        return ((changed & kFixedBits) != 0U) ? SdoAbort::kDeviceState : unless(has_no_effect, SdoAbort::kValueRange);
    }
    case cia302::kFlyingMasterIndex:
        return unless(flying == nullptr || flying->State() != cia302::FlyingState::kInitialising,
                      SdoAbort::kDeviceState);
    case kAssignment:
    {
        cia302::SlaveSetup asked{};
        asked.assignment = value;
        const bool is_malformed =
            (asked.GuardTimeMs() == 0U) != (asked.RetryFactor() == 0U) || asked.Has(kReservedAssignment);
        const SdoAbort abort = MayChange(NodeId{address.sub});
        const SdoAbort leaves = unless(!asked.IsListed(), SdoAbort::kDeviceState);
        const SdoAbort wrong = (leaves == SdoAbort::kNone) ? unless(is_malformed, SdoAbort::kValueRange) : leaves;
        return (abort == SdoAbort::kNone) ? wrong : abort;
    }
    default:
        return MayChange(NodeId{address.sub});
    }
}

/// A start of one safety slave whose node-ID may be that of two devices: it would be made PRE-OPERATIONAL, and stopped.
/// [SRS_MGR_670]
bool ManagerObjects::IsDoubtedStart(const std::uint8_t sub, const std::uint32_t value) const noexcept
{
    constexpr std::uint32_t kStart = 5U;
    const bool is_safety = net_.Setup().IsSafetySlave(NodeId{sub});
    return is_safety && value == kStart && assembly_.Core().Watched().Of(NodeId{sub}).is_duplicate;
}

/// What the manager knows of a slave. A safety slave stays what its network file says: no write takes it out of the
/// list that forbids a start of all. [SRS_MGR_214]
SdoAbort ManagerObjects::MayChange(const NodeId node) const noexcept
{
    const bool is_listed = net_.Setup().IsListed(node);
    if (is_listed && net_.Setup().IsSafetySlave(node))
    {
        return SdoAbort::kReadOnly;
    }
    return (!is_listed || IsStartingUp(assembly_, node)) ? SdoAbort::kDeviceState : SdoAbort::kNone;
}

/// Other guarding times count at once for a slave that is guarded, or was started and is watched by nobody.
SdoAbort ManagerObjects::StoreAssignment(const ObjectAddress& address, const cia301::Bytes& value) noexcept
{
    constexpr std::uint32_t kFirstGuardingBit = 8U;
    const NodeId node{address.sub};
    cia302::NodeTable& table = assembly_.Core().ProfileParts().table;
    const std::uint32_t before = net_.Setup().Slave(node).assignment;
    const SdoAbort abort = objects_.OnWrite(address, value);
    const std::uint32_t changed = before ^ net_.Setup().Slave(node).assignment;
    const cia302::Watch watch = table.Record(node).watch;
    const bool is_unwatched = watch == cia302::Watch::kNone && assembly_.Core().Status(node).is_started;
    if ((changed >> kFirstGuardingBit) != 0U && (watch == cia302::Watch::kGuarding || is_unwatched))
    {
        table.WatchAsSetUp(node, now_);
    }
    return abort;
}

SdoAbort ManagerObjects::Store(const ObjectAddress& address, const cia301::Bytes& value) noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    switch (address.index)
    {
    case kProducer:
        assembly_.SetHeartbeat(static_cast<std::uint16_t>(cia301::FromLittleEndian(value.data, value.size_bytes)));
        break;
    case kConsumers:
        abort = consumers_.Write(
            address.sub, static_cast<std::uint32_t>(cia301::FromLittleEndian(value.data, value.size_bytes)), now_);
        break;
    case kAssignment:
        abort = StoreAssignment(address, value);
        break;
    case kConcise:
        abort = net_.ReplaceConcise(address.sub, value) ? SdoAbort::kNone : SdoAbort::kValueRange;
        break;
    case cia302::kFlyingMasterIndex:
        abort = flying_.OnWrite(address, value);
        break;
    default:
        abort = objects_.OnWrite(address, value);
        break;
    }
    return abort;
}
} // namespace counterpoint::runtime
