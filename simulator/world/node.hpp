// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_HPP
#define SIMULATOR_WORLD_NODE_HPP

#include "runtime/device/assembly.hpp"
#include "runtime/device/model.hpp"
#include "runtime/device/owned_channel.hpp"
#include "simulator/faults/channel_tap.hpp"
#include "simulator/faults/memory_places.hpp"
#include "simulator/faults/output_tap.hpp"
#include "simulator/faults/part_faults.hpp"
#include "simulator/faults/supervisor_tap.hpp"
#include "simulator/journal/journal.hpp"
#include "simulator/world/link_wire.hpp"
#include "simulator/world/node_application.hpp"
#include "simulator/world/node_memory.hpp"
#include "simulator/world/node_self_test.hpp"
#include "simulator/world/participant.hpp"

#include "hal/host/can_ports.hpp"
#include "hal/host/clocks.hpp"
#include "hal/host/frame_queue.hpp"
#include "hal/host/output.hpp"
#include "hal/host/virtual/bus.hpp"
#include "hal/host/watchdog.hpp"
#include "safety_core/crosslink/peer.hpp"
#include "safety_core/kernel/kernel.hpp"

#include <array>
#include <memory>
#include <optional>

namespace counterpoint::simulator
{
/// Frames of one SRDO as this node got them: what limits are counted from. [SRS_SIM_031]
struct PairTimes
{
    Nanoseconds last_good_normal{-1}; ///< Normal frame of the last complete valid pair.
    Nanoseconds last_inverse{-1};
    Nanoseconds pending{-1};
    Payload data{};
    std::uint8_t length_bytes{0U};
};

/// Whether a node is looked into: taps around channels and supervisors cost time.
enum class Insight : std::uint8_t
{
    kNone = 0U,
    kTapped = 1U,
};

/// Where a node is, and who looks at it.
struct NodePlace
{
    NodeIndex index;
    host::VirtualBus& bus;
    Journal& journal;
    Insight insight;
    const cia306::Device* file; ///< Null: the node has no services but NMT commands.
};

/// What the core is told of the link. [SRS_SIM_056]
[[nodiscard]] LinkConfig LinkConfigOf(const NodeSetup& setup);

/// One device of the simulated network, or one CPU of it: an assembly with shipped channels on the hardware layer of
/// the host, with taps in front of them where it is looked into. [SRS_SIM_001, SRS_SIM_061, SRS_SIM_062]
class Node final : private host::FrameSink, private ChannelWitness, private runtime::AssemblyOwner
{
  public:
    /// @brief Everything given outlives the node, but for the file. A setup whose phase never comes has no supply until
    /// PowerOn.
    Node(const NodePlace& place, const NodeSetup& setup, runtime::DeviceModel& model);

    /// @brief Of a CPU of two: the wire to the other one, which outlives the node.
    void Join(LinkWire& wire) noexcept;
    /// @brief A message that came over it.
    void TakeMessage(const hal::LinkFrame& frame);
    /// @brief Starts and commissions the kernel as PowerOn will, to find out early whether it can be. Throws
    /// cia306::InputError.
    void Rehearse();
    /// @brief The supply comes, for the first time or again: counters begin, the kernel starts and is commissioned, the
    /// watchdog starts. A device whose tables were hit by a fault may not start; then it stays off.
    void PowerOn();
    /// @brief The supply goes: outputs close, the controllers forget their frames. [SRS_SIM_037]
    void PowerOff();
    /// @brief Starts the kernel anew; a node that hangs does not hear of it.
    void ResetNode();
    /// @brief Passes initialising; the kernel's safe state and interlocks stay.
    void ResetCommunication();
    /// @brief The next instant at which the node does something: a cycle, or an output that closes by itself.
    [[nodiscard]] Nanoseconds NextEvent() const noexcept
    {
        return next_event_;
    }
    /// @brief Does what is due at the bus's present instant.
    void Run();

    /// @brief A command of the NMT master for this node alone, or that another way leads to that state.
    void SetNmt(NmtState state);
    void SetAcknowledge(std::uint8_t srdo, bool level);
    void SendGfc();
    /// @brief The next cycle, and all after it, come so much later (negative: earlier).
    void ShiftCycle(Nanoseconds by);
    void SetCounterRate(bool is_counter_a, std::int32_t drift_ppm);
    void JumpCounter(bool is_counter_a, Nanoseconds by);
    /// @brief The memory of a part, in which bits flip.
    [[nodiscard]] std::vector<MemoryPiece> PiecesOfPart(Part part, std::uint8_t srdo);
    /// @brief Flips one bit of a part's memory, of those that PiecesOfPart tells.
    void FlipBit(Part part, std::uint8_t srdo, const runtime::BitPlace& place);
    /// @brief From now on this bit of the part's live memory stays at one level.
    void StickBit(const FaultSetup& fault, const runtime::BitPlace& place, std::size_t index);
    /// @brief Nothing of the node runs any more, until a power cycle.
    void StandStill();
    /// @brief From now on frames wait in a queue of this capacity for the next cycle; 0: as before. [SRS_SIM_027]
    void Poll(std::size_t capacity, std::size_t fault);

    [[nodiscard]] const runtime::DeviceModel& Model() const noexcept;
    [[nodiscard]] NodeApplication& App() noexcept;
    [[nodiscard]] PartFaults& Faults() noexcept;
    [[nodiscard]] host::HostCanPorts& Can() noexcept;
    [[nodiscard]] const PairTimes& TimesOf(SlotIndex slot) const noexcept;
    [[nodiscard]] SrdoMask Open() const noexcept;
    [[nodiscard]] NodeIndex Index() const noexcept
    {
        return place_.index;
    }
    /// @brief kInvalid: it has no supply.
    [[nodiscard]] cia301::NodeState State() const noexcept;
    [[nodiscard]] bool HasSupply() const noexcept
    {
        return is_on_;
    }
    /// @brief Another device of its kind stands here from the next power-on on. Of a node with services; below, too.
    void SetSerial(std::uint32_t serial) noexcept;
    /// @brief Somebody writes into it, by no message of the bus.
    void Store(const ObjectAddress& object, std::uint32_t value);
    /// @brief Its nodes of the bus, the first controller first.
    [[nodiscard]] const std::vector<host::NodeIndex>& BusNodes() const noexcept;
    [[nodiscard]] Kernel& Core() noexcept;

  private:
    /// What one channel said last.
    struct Voice
    {
        CycleOutcome outcome{};
        std::array<SrdoState, kMaxSrdoCount> states{};
    };

    void OnFrame(const StampedFrame& frame) override; // Of the controllers; the three below as well.
    void OnConfirm(const StampedFrame& frame) override;
    void OnOverflow() override;
    void OnOutcome(Part part, const Channel& channel, const CycleOutcome& outcome) override;
    [[nodiscard]] bool Concerns(const CanFrame& frame) const override;
    void OnStart() noexcept override; // Of the assembly; the six below as well.
    void OnNoStart(StartResult result) noexcept override;
    void OnLoaded(std::uint8_t groups) noexcept override;
    void OnRefused(const runtime::ConfigurationWrite& write, AbortCode code) noexcept override;
    void OnResetCommunication(const std::vector<std::string>& refusals) noexcept override;
    void OnTime(const cia301::TimeOfDay& time, Instant now) noexcept override;
    void OnEmergency(const cia301::ReceivedEmergency& emergency) noexcept override;
    [[nodiscard]] SlotIndex ConsumerOf(const CanFrame& frame) const;

    void ConnectControllers(std::uint32_t count);
    void FurnishSelfTest();
    [[nodiscard]] bool IsTapped() const noexcept;
    [[nodiscard]] Channel& RealChannel(runtime::Letter letter) noexcept;
    [[nodiscard]] Channel& VoiceOf(runtime::Letter letter) noexcept;
    [[nodiscard]] hal::SafetyOutput& Output() noexcept;
    [[nodiscard]] hal::Watchdog& Supervision() noexcept;
    [[nodiscard]] InstantPair Instants() noexcept;
    [[nodiscard]] StampedFrame Stamped(const StampedFrame& frame) const noexcept;
    void Obey(cia301::NmtCommand command);
    void RunKernel(const CycleCall& call);
    void TellLink();
    [[nodiscard]] std::vector<MemoryPiece> WatchedPieces(Part part);
    void NoteSelfTest();
    void StartFresh();
    void BeginCycles();
    void Settle();
    void LookAtBus();
    void Serve();
    void BeginCounters();
    void Take(const StampedFrame& frame);
    void HandOver();
    void FollowConfiguration();
    void TakeIdentifier(std::uint32_t identifier, SlotIndex slot);
    void TakeConfirmation(const StampedFrame& frame);
    void TakeOverflow();
    void DrainQueue();
    [[nodiscard]] SrdoMask Level(Part part, SrdoMask frozen);
    void Cycle();
    /// @brief Ends as an exception does if a call into the kernel would lead anywhere: all but a cycle that begins with
    /// a look at the pointers.
    void RequireSound();
    /// @brief Makes a call into the kernel that may never return.
    template <typename Call> void Guarded(const Call& call);
    void SendByApplication();
    void LookAtOutput();
    void LookAtWatchdog();
    void SettleNextEvent() noexcept;
    void LookInside();
    void TellStates(Part part, const Channel& channel, Voice& voice);
    void TellCauses(Part part, const Channel& channel, SrdoMask new_fault, SrdoMask signalled);
    void NoteEffects();
    void NoteHung();
    void Follow(const StampedFrame& frame);
    void ScheduleNext();
    [[nodiscard]] Nanoseconds Now() const noexcept;
    [[nodiscard]] std::uint8_t NumberOf(SlotIndex slot) const noexcept;

    NodePlace place_; ///< Its file is a mark only.
    const NodeSetup& setup_;
    runtime::DeviceModel& model_;
    host::VirtualBus& bus_;
    Journal& journal_;
    PartFaults faults_{};
    host::HostClocks clocks_;
    host::HostWatchdog watchdog_;
    host::HostOutput output_;
    OutputTap output_tap_;
    WatchdogTap watchdog_tap_;
    host::HostCanPorts can_;
    std::unique_ptr<runtime::OwnedChannel> channel_a_;
    std::unique_ptr<runtime::OwnedChannel> channel_b_;
    ChannelTap tap_a_;
    ChannelTap tap_b_;
    SupervisorTap supervisors_;
    NodeApplication application_;
    NodeMemory memory_;
    NodeImage image_;
    std::unique_ptr<NodeSelfTest> self_test_; ///< Null: the device has none.
    std::unique_ptr<Peer> peer_;              ///< Null: the device has one CPU.
    LinkWire* wire_{nullptr};
    LinkState shown_link_{LinkState::kWaiting};
    runtime::DeviceAssembly assembly_;
    StartResult started_{StartResult::kStarted};               ///< What the kernel said last.
    std::optional<runtime::ConfigurationWrite> refused_write_; ///< The first one at this start.
    AbortCode refused_{AbortCode::kNone};

    Nanoseconds next_cycle_{0};
    Nanoseconds cycle_ns_{0};        ///< Whole nanoseconds of a cycle on the node's oscillator.
    std::int64_t cycle_fraction_{0}; ///< And the rest, in parts of `oscillator_`.
    std::int64_t oscillator_{0};
    std::int64_t fraction_sum_{0};
    SrdoMask acknowledge_{0U};
    SrdoMask seen_acknowledge_a_{0U}; ///< By the channels; a frozen one stays.
    SrdoMask seen_acknowledge_b_{0U};
    std::vector<host::NodeIndex> bus_nodes_;
    std::unique_ptr<host::FrameQueue> queue_; ///< Between controllers and kernel while the node polls.
    std::size_t queue_capacity_{0U};
    std::size_t queue_fault_{kNoFaultIndex};
    bool has_overflowed_{false};
    SrdoMask open_{0U};
    std::uint32_t cycles_to_send_{0U}; ///< Applications that send by themselves: cycles until the next refresh.
    std::uint32_t cycles_per_send_{0U};
    Nanoseconds next_event_{0};
    Nanoseconds serve_at_{kNever};        ///< Services look at what the bus brought.
    Nanoseconds look_at_{kNever};         ///< When output or watchdog change by themselves.
    std::optional<std::uint32_t> serial_; ///< 1018h:04 instead of the file's.
    cia301::NodeState state_{cia301::NodeState::kInvalid};
    device::BusCondition condition_{device::BusCondition::kActive};
    bool has_restarted_{false}; ///< The kernel was started anew: cycles and watchdog begin.
    bool is_hung_{false};
    bool has_told_test_{false};
    bool may_be_wild_{false}; ///< A pointer to a virtual table was hit.
    bool is_on_{false};
    bool was_alive_{true};
    // Last shown to people.
    Voice voice_a_{};
    Voice voice_b_{};
    SrdoMask shown_agreed_{0U};
    SrdoMask shown_matched_{0U};
    SrdoMask shown_permits_{0U};
    std::array<SlotIndex, kSrdoIdentifierCount> slot_of_{}; ///< Consumers by identifier.
    std::array<PairTimes, kMaxSrdoCount> times_{};
};
template <typename Call> void Node::Guarded(const Call& call)
{
    if (place_.insight == Insight::kNone)
    {
        call();
        return;
    }
    faults_.SetNow(Now());
    memory_.Hold();
    const SupervisorTap::Scope scope(&supervisors_);
    if (setjmp(faults_.WayOut()) != 0)
    {
        NoteHung();
        return;
    }
    call();
}

} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_HPP
