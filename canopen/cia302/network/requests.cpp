// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// 1F25h, 1F82h and 1F83h: objects that do something.
#include "canopen/cia302/network/objects.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint8_t kAllSub = 0x80U;
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

SdoAbort NetworkObjects::RequestNmt(const std::uint8_t sub, const std::uint32_t value) noexcept
{
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
        abort = RequestEach(command);
    }
    else if ((command != NmtCommand::kInvalid) && is_known && !is_each)
    {
        abort = AbortOf(parts_.start_up.Command(command, is_all ? kAllNodes : NodeId{sub}, now_));
    }
    return abort;
}

/// A full queue is waited for: the write is asked again, and goes on where it stopped. One node whose state does not
/// allow the command keeps no other one from it, nor does another device than the expected one, which is told at the
/// end.
SdoAbort NetworkObjects::RequestEach(const NmtCommand command) noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    while ((abort == SdoAbort::kNone) && (next_ <= kLastNode))
    {
        const NodeId node{next_};
        if (parts_.setup.IsListed(node) && (next_ != requester_.value))
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
        next_ = 1U;
        is_other_met_ = false;
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
