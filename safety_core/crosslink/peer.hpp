// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_PEER_HPP
#define SAFETY_CORE_CROSSLINK_PEER_HPP

#include "hal/api/cross_link.hpp"
#include "safety_core/crosslink/flow_tap.hpp"
#include "safety_core/crosslink/own_voice.hpp"
#include "safety_core/crosslink/remote_voice.hpp"

#include <cstdint>

namespace counterpoint
{

/// What the kernel of this CPU is told of a message: when it is composed, and whether the kernel is running.
struct PeerMoment
{
    Instant now;
    DeviceFault fault; ///< Kernel::DeviceState().fault
};

/// One CPU of two: the two voices that its kernel is given as channels, and the messages to and from the other CPU. An
/// executive does, each cycle:
///
///     while (wire.Receive(frame) == kDone) peer.OnMessage(frame, clock);
///     for each frame of the bus: peer.IsEcho(frame) ? kernel.OnConfirm(...) : kernel.OnFrame(...);
///     if (peer.Examine(now) != LinkFinding::kNone) kernel.OnCrossLinkFault();
///     kernel.Cycle(...);
///     peer.Compose({now, kernel.DeviceState().fault}, frame); wire.Send(frame);
///
/// This CPU has one clock: it stamps frames and messages and is both halves of each InstantPair that the kernel is
/// given, or moments of two clocks are compared and no pair is sent any more.
/// Without the call of OnCrossLinkFault the device is as safe, and tells another cause. NMT states and configuration
/// are given to both CPUs within the discrepancy time. On CPU A the application reads and writes the normal objects, on
/// CPU B the inverse ones.
class Peer
{
  public:
    /// @brief `channel` is the implementation that `config.role` names.
    Peer(Channel& channel, hal::Watchdog& watchdog, const LinkConfig& config) noexcept;

    /// @brief What KernelParts take. Kernel::Start restarts all of it.
    [[nodiscard]] Channel& VoiceA() noexcept;
    [[nodiscard]] Channel& VoiceB() noexcept;
    [[nodiscard]] hal::Watchdog& Watchdog() noexcept;

    /// @brief What came over the wire, stamped by the own clock. O(bytes)
    void OnMessage(const hal::LinkFrame& frame, Instant received) noexcept;
    /// @brief Before each cycle: anything but kNone is for Kernel::OnCrossLinkFault.
    [[nodiscard]] LinkFinding Examine(Instant now) noexcept;
    /// @brief After each cycle: what the other CPU is to be told. O(bytes)
    void Compose(const PeerMoment& moment, hal::LinkFrame& frame) noexcept;
    /// @brief Whether a received frame is the other CPU's half of a pair of this device. [SRS_TWO_217]
    [[nodiscard]] bool IsEcho(const CanFrame& frame) const noexcept;
    /// @brief State of the link, why it is lost, and what became of the messages.
    [[nodiscard]] const LinkSupervisor& Link() const noexcept;

  private:
    /// @brief As many reports as a message has room for: of active consumers with news first, of the others in turn.
    void FillReports(SrdoMask changed, Instant now, LinkMessage& message) noexcept;
    /// @brief New faults that the message has to carry: each until the peer has echoed one that carried the newest of
    /// them. [SRS_TWO_006]
    [[nodiscard]] SrdoMask TellFaults(SrdoMask faults) noexcept;

    OwnVoice own_;
    RemoteVoice remote_;
    FlowTap flow_;
    LinkConfig config_;
    SrdoMask news_{0U};    ///< Slots that the next reports tell first.
    SrdoMask carried_{0U}; ///< New faults that the peer may not have heard of.
    std::uint32_t carried_since_{0U};
    std::uint32_t sequence_{0U};
    SlotIndex reported_{0U}; ///< The last one in turn.
};

} // namespace counterpoint

#endif
