// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/manager/safety_permissions.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint16_t kFirstSafety = 0x1300U;
constexpr std::uint16_t kLastSafety = 0x13FFU;

/// What a frame says of a download.
enum class Download : std::uint8_t
{
    kNone = 0U,
    kBegun = 1U, ///< It may be written, or is: the answer names the object.
    kRest = 2U,  ///< A segment, or the end of a block: of what was begun last.
    kAsked = 3U, ///< Somebody else asks for it: the request names the object.
    kAskedRest = 4U,
};

/// What a request says of one. This device does not hear its own.
Download AskedIn(const std::uint8_t head) noexcept
{
    constexpr std::uint8_t kCommandBits = 0xE0U;
    constexpr std::uint8_t kSegment = 0x00U;
    constexpr std::uint8_t kBegin = 0x20U;
    constexpr std::uint8_t kBlockBits = 0xE1U;
    constexpr std::uint8_t kBlockBegin = 0xC0U;
    constexpr std::uint8_t kBlockEnd = 0xC1U;
    const auto command = static_cast<std::uint8_t>(head & kCommandBits);
    const auto block = static_cast<std::uint8_t>(head & kBlockBits);
    const bool is_begin = (command == kBegin) || (block == kBlockBegin);
    const bool is_rest = (command == kSegment) || (block == kBlockEnd);
    const Download rest = is_rest ? Download::kAskedRest : Download::kNone;
    return is_begin ? Download::kAsked : rest;
}

Download DownloadIn(const CanFrame& frame) noexcept
{
    constexpr std::uint32_t kAnswers = 0x580U;
    constexpr std::uint32_t kRequests = 0x600U;
    constexpr std::uint8_t kSdoBytes = 8U;
    constexpr std::uint8_t kCommandBits = 0xE0U;
    constexpr std::uint8_t kBegin = 0x60U;
    constexpr std::uint8_t kSegment = 0x20U;
    constexpr std::uint8_t kBlockBits = 0xE3U;
    constexpr std::uint8_t kBlockBegin = 0xA0U;
    constexpr std::uint8_t kBlockEnd = 0xA1U;
    const std::uint32_t service = frame.identifier & ~std::uint32_t{kLastNode};
    const bool is_sdo = (frame.kind == FrameKind::kData) && (frame.length_bytes == kSdoBytes);
    const bool is_answer = is_sdo && (service == kAnswers);
    const auto command = static_cast<std::uint8_t>(frame.data[0] & kCommandBits);
    const auto block = static_cast<std::uint8_t>(frame.data[0] & kBlockBits);
    Download download = Download::kNone;
    if (is_sdo && (service == kRequests))
    {
        download = AskedIn(frame.data[0]);
    }
    else if (is_answer && ((command == kBegin) || (block == kBlockBegin)))
    {
        download = Download::kBegun;
    }
    else if (is_answer && ((command == kSegment) || (block == kBlockEnd)))
    {
        download = Download::kRest;
    }
    else
    {
        // Something else, or no answer.
    }
    return download;
}

} // namespace

SafetyPermissions::SafetyPermissions(const NetworkSetup& setup, GateState* const told, SafetyGate& gate,
                                     NodeTable& table) noexcept
    : setup_(setup), told_(told), gate_(gate), table_(table)
{
}

void SafetyPermissions::Close(const NodeId node) noexcept
{
    if (setup_.IsSafetySlave(node))
    {
        gate_.Close(node);
    }
}

/// A reset ends what was verified, at once and not when the slave comes back, and what was suspected: whoever sent it.
/// [SRS_SFS_002]
void SafetyPermissions::OnReset(const NodeId node) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        if ((node.value == kAllNodes.value) || (node.value == id))
        {
            Close(NodeId{id});
            gate_.Trust(NodeId{id});
        }
    }
}

/// Out of OPERATIONAL it can be changed, and be back there before it says so. What was found before stays to be told.
/// [SRS_SFS_002]
void SafetyPermissions::OnLeave(const NodeId node) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const GateState gate = gate_.State(NodeId{id});
        const bool is_hit = (node.value == kAllNodes.value) || (node.value == id);
        if (is_hit && ((gate == GateState::kOpen) || (gate == GateState::kBusy)))
        {
            Close(NodeId{id});
        }
    }
}

/// What was read of a safety slave before holds no more, and what is being read begins anew.
void SafetyPermissions::ReadAnew(const NodeId node) noexcept
{
    gate_.Renew(node);
    if (gate_.State(node) == GateState::kOpen)
    {
        Close(node);
    }
}

/// Somebody else starts safety slaves. What this device has verified and started runs already; all others are taken to
/// run, whether or not they say so by any error control, and so are read. [SRS_SFS_006, SRS_SFS_150]
void SafetyPermissions::OnForeignStart(const NodeId node, const StartUp& profile, const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId slave{id};
        const bool is_hit = ((node.value == kAllNodes.value) || (node.value == id)) && setup_.IsSafetySlave(slave);
        const bool is_ours = HasStarted(slave, profile) && (gate_.State(slave) == GateState::kOpen);
        if (is_hit)
        {
            table_.KeepStarted(slave);
        }
        if (is_hit && !is_ours)
        {
            ReadAnew(slave); // It may have been changed since it was read.
            table_.Presume(slave, now);
        }
    }
}

/// This device has verified it, and its start is on the bus.
bool SafetyPermissions::HasStarted(const NodeId node, const StartUp& profile) const noexcept
{
    const bool has_left = (table_.Record(node).asked == SlaveState::kOperational);
    return profile.Status(node).is_started && has_left;
}

/// 1300h may be written in every state, and 1010h and 1011h change what a device has after its reset alone: they count
/// until the start. A device takes nothing else of 1300h to 13FFh in OPERATIONAL: it had not got the start yet. Who
/// runs is read again, whoever started it. A request counts as well, for the start may leave between it and its answer.
void SafetyPermissions::OnFrame(const CanFrame& frame, const StartUp* const profile, const Instant now) noexcept
{
    constexpr std::uint16_t kStore = 0x1010U;
    constexpr std::uint16_t kRestore = 0x1011U;
    const NodeId node{static_cast<std::uint8_t>(frame.identifier & kLastNode)};
    const Download download = DownloadIn(frame);
    const ObjectAddress named{static_cast<std::uint16_t>(cia301::FromLittleEndian(&frame.data[1], 2U)), frame.data[3]};
    if (download == Download::kBegun)
    {
        gate_.NoteDownload(node, named);
    }
    const bool is_asked = (download == Download::kAsked) || (download == Download::kAskedRest);
    const ObjectAddress object = (download == Download::kAsked) ? named : gate_.LastDownload(node);
    const bool is_configuration = (object.index > kFirstSafety) && (object.index <= kLastSafety);
    const bool is_other = (object.index == kFirstSafety) || (object.index == kStore) || (object.index == kRestore);
    const bool is_meant = (download != Download::kNone) && setup_.IsSafetySlave(node) &&
                          (is_configuration || is_other) && (profile != nullptr);
    if (is_meant && gate_.OnWritten(node, object) && (gate_.State(node) == GateState::kOpen))
    {
        const bool is_started = HasStarted(node, *profile);
        const bool is_running = is_started || table_.IsFoundRunning(node);
        // Who runs may refuse: its answer tells.
        const bool is_over = is_asked ? !is_running : (!is_started || is_configuration);
        if (is_over)
        {
            Close(node);
            if (is_running)
            {
                table_.Presume(node, now);
            }
        }
    }
}

/// Whatever was on the bus meanwhile: who runs is read again, what is being read from the beginning, and who does not
/// run any more has booted. [SRS_SFS_153, SRS_NMM_020]
void SafetyPermissions::OnLost(const StartUp* const profile, const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId slave{id};
        gate_.Renew(slave);
        if (profile != nullptr)
        {
            table_.Miss(slave);
        }
        if ((profile != nullptr) && setup_.IsSafetySlave(slave) && (gate_.State(slave) == GateState::kOpen))
        {
            const bool is_started = HasStarted(slave, *profile); // Else the start is given up.
            Close(slave);
            if (is_started || (table_.Record(slave).state == SlaveState::kOperational))
            {
                table_.Presume(slave, now);
            }
        }
    }
}

void SafetyPermissions::OnStartDropped(const NodeId node) noexcept
{
    if (gate_.State(node) == GateState::kOpen)
    {
        Close(node);
    }
}

void SafetyPermissions::Tell(ManagerListener& listener, const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        const GateState gate = gate_.State(node);
        if (setup_.IsSafetySlave(node) && (gate != told_[id]))
        {
            told_[id] = gate;
            listener.OnGate(node, gate, now);
        }
    }
}

} // namespace counterpoint::cia302
