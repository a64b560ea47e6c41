// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The setup as objects; then 1F25h, 1F82h and 1F83h, which do something.
#include "canopen/cia302/network/objects.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::ObjectValue;

constexpr std::uint16_t kInhibit = 0x102AU;
constexpr std::uint16_t kDcf = 0x1F20U;
constexpr std::uint16_t kConcise = 0x1F22U;
constexpr std::uint16_t kConfigure = 0x1F25U;
constexpr std::uint16_t kProgram = 0x1F58U;
constexpr std::uint16_t kStartUp = 0x1F80U;
constexpr std::uint16_t kAssignment = 0x1F81U;
constexpr std::uint16_t kNmt = 0x1F82U;
constexpr std::uint16_t kGuarding = 0x1F83U;
constexpr std::uint16_t kBootTime = 0x1F89U;
constexpr std::uint16_t kRestore = 0x1F8AU;
constexpr std::uint8_t kAllSub = 0x80U;
constexpr std::uint32_t kMaxInhibit = 0xFFFFU;

/// The numbers of 32 bits of a slave, by their objects.
struct Member
{
    std::uint16_t index;
    std::uint32_t SlaveSetup::* place;
};

constexpr Member kMembers[8] = {{0x1F26U, &SlaveSetup::configuration_date}, {0x1F27U, &SlaveSetup::configuration_time},
                                {kAssignment, &SlaveSetup::assignment},     {0x1F84U, &SlaveSetup::device_type},
                                {0x1F85U, &SlaveSetup::vendor_id},          {0x1F86U, &SlaveSetup::product_code},
                                {0x1F87U, &SlaveSetup::revision_number},    {0x1F88U, &SlaveSetup::serial_number}};

/// The same of its software.
struct SoftwareMember
{
    std::uint16_t index;
    std::uint32_t SoftwareSetup::* place;
};

constexpr SoftwareMember kSoftwareMembers[3] = {
    {0x1F53U, &SoftwareSetup::date}, {0x1F54U, &SoftwareSetup::time}, {0x1F55U, &SoftwareSetup::identification}};

bool IsService(const std::uint16_t index) noexcept
{
    return (index == kConfigure) || (index == kNmt) || (index == kGuarding);
}

bool IsNode(const std::uint8_t sub) noexcept
{
    return (sub >= 1U) && (sub <= kLastNode);
}

constexpr std::uint32_t kAllBut = 0x80U;     ///< Added to a value: all but the master and the requester.
constexpr std::uint32_t kConf = 0x666E6F63U; ///< "conf"

NmtCommand CommandOf(const std::uint32_t value) noexcept
{
    constexpr std::uint32_t kPreOperationalShort = 0x0FU; // 8Fh is also in use for 127 + 80h.
    NmtCommand command = NmtCommand::kInvalid;
    switch (value)
    {
    case 4U:
        command = NmtCommand::kStop;
        break;
    case 5U:
        command = NmtCommand::kStart;
        break;
    case 6U:
        command = NmtCommand::kResetNode;
        break;
    case 7U:
        command = NmtCommand::kResetCommunication;
        break;
    case 127U:
    case kPreOperationalShort:
        command = NmtCommand::kPreOperational;
        break;
    default:
        break;
    }
    return command;
}

SdoAbort AbortOf(const NmtAnswer answer) noexcept
{
    SdoAbort abort = SdoAbort::kDeviceState;
    if ((answer == NmtAnswer::kTaken) || (answer == NmtAnswer::kPartly))
    {
        abort = SdoAbort::kNone;
    }
    else if (answer == NmtAnswer::kQueueFull)
    {
        abort = SdoAbort::kPending;
    }
    else if ((answer == NmtAnswer::kWrong) || (answer == NmtAnswer::kInvalid))
    {
        abort = SdoAbort::kValueRange;
    }
    return abort;
}

} // namespace

NetworkObjects::NetworkObjects(const NetworkObjectParts& parts) noexcept
    : parts_(parts), now_{0U}, requester_{0U}, each_(NmtCommand::kInvalid), next_(1U), is_other_met_(false)
{
}

void NetworkObjects::OnCycle(const Instant now) noexcept
{
    now_ = now;
}

void NetworkObjects::SetRequester(const NodeId node) noexcept
{
    requester_ = node;
}

ObjectValue NetworkObjects::Fetch(const ObjectAddress& address) noexcept
{
    ObjectValue value{SdoAbort::kNone, 0U, 4U};
    if (address.index == kInhibit)
    {
        value = ObjectValue{SdoAbort::kNone, parts_.setup.inhibit_100us, 2U};
    }
    else if (address.index == kStartUp)
    {
        value.value = parts_.setup.start_up;
    }
    else if (address.index == kBootTime)
    {
        value.value = parts_.setup.boot_time_ms;
    }
    else if (address.sub == 0U)
    {
        value = ObjectValue{SdoAbort::kNone, IsService(address.index) ? std::uint32_t{kAllSub} : kLastNode, 1U};
    }
    else
    {
        value = IsService(address.index) ? FetchService(address) : FetchArray(address);
    }
    return value;
}

ObjectValue NetworkObjects::FetchArray(const ObjectAddress& address) const noexcept
{
    ObjectValue value{SdoAbort::kSubUnknown, 0U, 4U};
    if (IsNode(address.sub))
    {
        const SlaveSetup& slave = parts_.setup.Slave(NodeId{address.sub});
        const bool is_restore = (address.index == kRestore);
        value.abort = is_restore ? SdoAbort::kNone : SdoAbort::kObjectUnknown;
        value.value = slave.restore_sub;
        value.size_bytes = is_restore ? 1U : 4U;
        for (const Member& member : kMembers)
        {
            const bool is_it = (member.index == address.index);
            value.abort = is_it ? SdoAbort::kNone : value.abort;
            value.value = is_it ? slave.*member.place : value.value;
        }
        for (const SoftwareMember& member : kSoftwareMembers)
        {
            const bool is_it = (member.index == address.index);
            value.abort = is_it ? SdoAbort::kNone : value.abort;
            value.value = is_it ? slave.software.*member.place : value.value;
        }
    }
    return value;
}

ObjectValue NetworkObjects::FetchService(const ObjectAddress& address) const noexcept
{
    ObjectValue value{SdoAbort::kWriteOnly, 0U, 1U};
    if (IsNode(address.sub) && (address.index != kConfigure))
    {
        const NodeId node{address.sub};
        const bool is_guarded = (parts_.table.Record(node).watch == Watch::kGuarding);
        const std::uint32_t guarding = is_guarded ? 1U : 0U;
        const bool is_anybody = parts_.setup.IsListed(node) || (node.value == parts_.setup.own.value) ||
                                parts_.table.Record(node).was_seen; // Else a command to all makes nobody OPERATIONAL.
        const std::uint32_t state = is_anybody ? parts_.table.RequestValue(node) : std::uint8_t{0U};
        value.abort = SdoAbort::kNone;
        value.value = (address.index == kNmt) ? state : guarding;
    }
    return value;
}

SdoAbort NetworkObjects::Store(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    const bool is_setup = (address.index == kInhibit) || (address.index == kStartUp) || (address.index == kBootTime);
    SdoAbort abort = SdoAbort::kReadOnly;
    if (is_setup)
    {
        abort = StoreSetup(address.index, value);
    }
    else if (address.index == kNmt)
    {
        abort = RequestNmt(address.sub, value, cia301::Attempt::kFirst);
    }
    else if (address.index == kGuarding)
    {
        abort = RequestGuarding(address.sub, value);
    }
    else if (address.index == kConfigure)
    {
        abort = RequestConfiguration(address.sub, value);
    }
    else if (address.sub != 0U)
    {
        abort = StoreArray(address, value);
    }
    return abort;
}

/// A full queue is all that delays a write.
SdoAbort NetworkObjects::StoreAgain(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    return (address.index == kNmt) ? RequestNmt(address.sub, value, cia301::Attempt::kAgain) : Store(address, value);
}

SdoAbort NetworkObjects::StoreSetup(const std::uint16_t index, const std::uint32_t value) noexcept
{
    const bool is_wrong =
        ((index == kStartUp) && ((value & ~kKnownStartUpBits) != 0U)) || ((index == kInhibit) && (value > kMaxInhibit));
    SdoAbort abort = is_wrong ? SdoAbort::kValueRange : SdoAbort::kNone;
    if (parts_.setup_room == nullptr)
    {
        abort = SdoAbort::kReadOnly;
    }
    else if (!is_wrong && (index == kStartUp))
    {
        parts_.setup_room->start_up = value;
    }
    else if (!is_wrong && (index == kBootTime))
    {
        parts_.setup_room->boot_time_ms = value;
    }
    else if (!is_wrong)
    {
        parts_.setup_room->inhibit_100us = static_cast<std::uint16_t>(value);
    }
    return abort;
}

SdoAbort NetworkObjects::StoreArray(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    SdoAbort abort = SdoAbort::kReadOnly;
    if (parts_.slave_room != nullptr)
    {
        abort = FetchArray(address).abort;
    }
    if ((abort == SdoAbort::kNone) && (address.index == kRestore))
    {
        const bool is_right = (value <= kLastNode); // Sub-indices of 1011h.
        abort = is_right ? SdoAbort::kNone : SdoAbort::kValueRange;
        std::uint8_t& place = parts_.slave_room[address.sub].restore_sub;
        place = is_right ? static_cast<std::uint8_t>(value) : place;
    }
    else if (abort == SdoAbort::kNone)
    {
        SlaveSetup& slave = parts_.slave_room[address.sub];
        for (const Member& member : kMembers)
        {
            slave.*member.place = (member.index == address.index) ? value : slave.*member.place;
        }
        for (const SoftwareMember& member : kSoftwareMembers)
        {
            std::uint32_t& place = slave.software.*member.place;
            place = (member.index == address.index) ? value : place;
        }
    }
    return abort;
}

NetworkDomains::NetworkDomains(const NetworkSetup& setup) noexcept : setup_(setup)
{
}

cia301::Reading NetworkDomains::OnRead(const ObjectAddress& address, const Room& room) noexcept
{
    cia301::Reading reading{IsNode(address.sub) ? SdoAbort::kNone : SdoAbort::kSubUnknown, 0U};
    const SlaveSetup& slave = setup_.Slave(NodeId{address.sub});
    Bytes domain{nullptr, 0U};
    domain = (address.index == kDcf) ? slave.dcf : domain;
    domain = (address.index == kConcise) ? slave.concise_dcf : domain;
    domain = (address.index == kProgram) ? slave.software.program : domain;
    if ((reading.abort == SdoAbort::kNone) && (domain.size_bytes > room.size_bytes))
    {
        reading.abort = SdoAbort::kOutOfMemory;
    }
    else if (reading.abort == SdoAbort::kNone)
    {
        reading.size_bytes = domain.size_bytes;
        for (std::uint32_t i = 0U; i < domain.size_bytes; ++i)
        {
            room.data[i] = domain.data[i];
        }
    }
    return reading;
}

/// A command to each begins with the first node, whatever another client's has come to, and takes its place.
SdoAbort NetworkObjects::RequestNmt(const std::uint8_t sub, const std::uint32_t value,
                                    const cia301::Attempt attempt) noexcept
{
    const bool is_new = (attempt == cia301::Attempt::kFirst);
    const bool is_all = (sub == kAllSub);
    const bool is_each = (value >= kAllBut);
    const bool is_short = (value == 0x0FU); // Only with 80h.
    const NmtCommand command = is_short ? NmtCommand::kInvalid : CommandOf(value & ~kAllBut);
    const bool is_known = parts_.setup.IsListed(NodeId{sub}) || (sub == parts_.setup.own.value) || is_all;
    SdoAbort abort = SdoAbort::kValueRange;
    if (sub == 0U)
    {
        abort = SdoAbort::kReadOnly;
    }
    else if ((command != NmtCommand::kInvalid) && is_all && is_each)
    {
        next_ = is_new ? std::uint8_t{1U} : next_;
        is_other_met_ = !is_new && is_other_met_;
        each_ = is_new ? command : each_;
        abort = (each_ == command) ? RequestEach(command) : SdoAbort::kLocalControl;
    }
    else if ((command != NmtCommand::kInvalid) && is_known && !is_each)
    {
        abort = AbortOf(parts_.start_up.Command(command, is_all ? kAllNodes : NodeId{sub}, now_));
    }
    return abort;
}

/// A full queue is waited for: the write is asked again, and goes on where it stopped. One node whose state does not
/// allow the command keeps no other one from it, nor does another device than the expected one, which is told at the
/// end. Whom a start of all leaves out is left out here, too. [SRS_BOOT_470]
SdoAbort NetworkObjects::RequestEach(const NmtCommand command) noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    while ((abort == SdoAbort::kNone) && (next_ <= kLastNode))
    {
        const NodeId node{next_};
        const bool is_left_out = (command == NmtCommand::kStart) && parts_.start_up.IsLeftOut(node);
        if (parts_.setup.IsListed(node) && (next_ != requester_.value) && !is_left_out)
        {
            const NmtAnswer answer = parts_.start_up.Command(command, node, now_);
            const bool is_other = (answer == NmtAnswer::kOtherDevice);
            is_other_met_ = is_other_met_ || is_other;
            abort = (is_other || (answer == NmtAnswer::kWrong)) ? SdoAbort::kNone : AbortOf(answer);
        }
        next_ = (abort == SdoAbort::kNone) ? static_cast<std::uint8_t>(next_ + 1U) : next_;
    }
    if (abort != SdoAbort::kPending)
    {
        abort = ((abort == SdoAbort::kNone) && is_other_met_) ? SdoAbort::kDeviceState : abort;
        each_ = NmtCommand::kInvalid;
    }
    return abort;
}

SdoAbort NetworkObjects::RequestGuarding(const std::uint8_t sub, const std::uint32_t value) noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    if (sub == 0U)
    {
        abort = SdoAbort::kReadOnly;
    }
    else if (value > 1U)
    {
        abort = SdoAbort::kValueRange;
    }
    else if (sub == kAllSub)
    {
        for (std::uint8_t id = 1U; id <= kLastNode; ++id)
        {
            static_cast<void>(GuardNode(NodeId{id}, value == 1U)); // Those that cannot be are left as they are.
        }
    }
    else
    {
        abort = GuardNode(NodeId{sub}, value == 1U);
    }
    return abort;
}

SdoAbort NetworkObjects::GuardNode(const NodeId node, const bool is_on) noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    if (!parts_.setup.IsListed(node))
    {
        abort = SdoAbort::kValueRange;
    }
    else
    {
        const SlaveSetup& slave = parts_.setup.Slave(node);
        // Who is supervised by heartbeat answers no remote frame.
        const bool has_times =
            (slave.GuardTimeMs() > 0U) && (slave.RetryFactor() > 0U) && (slave.heartbeat.consumer_ms == 0U);
        const Watch watch = parts_.table.Record(node).watch;
        abort = (has_times || !is_on) ? SdoAbort::kNone : SdoAbort::kDeviceState;
        if (has_times && is_on)
        {
            parts_.table.WatchGuarding(node, slave.GuardTimeMs(), slave.RetryFactor(), now_);
        }
        else if (!is_on && (watch == Watch::kGuarding))
        {
            parts_.table.Unwatch(node);
        }
    }
    return abort;
}

/// Of all, those that can be configured are; the answer tells that there was one that cannot. [SRS_NMM_152]
SdoAbort NetworkObjects::RequestConfiguration(const std::uint8_t sub, const std::uint32_t value) noexcept
{
    const NodeId node{sub};
    SdoAbort abort = SdoAbort::kNone;
    if (sub == 0U)
    {
        abort = SdoAbort::kReadOnly;
    }
    else if (value != kConf)
    {
        abort = SdoAbort::kNotStored;
    }
    else if (sub == kAllSub)
    {
        for (std::uint8_t id = 1U; id <= kLastNode; ++id)
        {
            const bool is_meant = parts_.setup.IsListed(NodeId{id});
            const bool is_refused = is_meant && !parts_.start_up.Configure(NodeId{id}, now_);
            abort = is_refused ? SdoAbort::kDeviceState : abort;
        }
    }
    else if (!parts_.setup.IsListed(node))
    {
        abort = SdoAbort::kValueRange;
    }
    else
    {
        abort = parts_.start_up.Configure(node, now_) ? SdoAbort::kNone : SdoAbort::kDeviceState;
    }
    return abort;
}

} // namespace counterpoint::cia302
