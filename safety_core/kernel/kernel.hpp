// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_KERNEL_HPP
#define SAFETY_CORE_KERNEL_KERNEL_HPP

#include "hal/api/can_ports.hpp"
#include "hal/api/safety_output.hpp"
#include "hal/api/watchdog.hpp"
#include "safety_core/comparator/comparator.hpp"
#include "safety_core/kernel/application.hpp"
#include "safety_core/kernel/clock_supervisor.hpp"
#include "safety_core/kernel/configuration_guard.hpp"
#include "safety_core/kernel/flow_monitor.hpp"
#include "safety_core/kernel/object_access.hpp"
#include "safety_core/kernel/result.hpp"
#include "safety_core/kernel/safe_state_latch.hpp"
#include "safety_core/kernel/self_test_part.hpp"
#include "safety_core/kernel/srdo_status.hpp"
#include "safety_core/kernel/variable.hpp"

#include <cstdint>

namespace counterpoint
{

/// Everything a kernel works with; all outlive it. Channel A writes and sends the normal side, channel B the inverse
/// side.
struct KernelParts
{
    Channel& channel_a;
    Channel& channel_b;
    hal::CanPorts& can;
    hal::SafetyOutput& output;
    hal::Watchdog& watchdog;
    Application& application;
    SelfTestPart* self_test{nullptr}; ///< Optional. [SRS_STS_063]
};

/// Whether OnFlow is called; the flow monitor works with either. [SRS_FLOW_004]
enum class FlowCallback : std::uint8_t
{
    kOff = 0U,
    kOn = 1U,
};

/// Whether the application must answer in the status byte; the byte signals with either. [SRS_KRN_022]
enum class StatusHandshake : std::uint8_t
{
    kOff = 0U,
    kRequired = 0x69U,
};

/// Inputs of one cycle. Acknowledge levels: bit n is slot n; one input a channel, both may come from the same wire.
struct CycleCall
{
    InstantPair now;
    SrdoMask acknowledge_a;
    SrdoMask acknowledge_b;
};

/// First reason why Start refused. [SRS_KRN_001]
enum class StartResult : std::uint8_t
{
    kInvalid = 0U,
    kStarted = 0x69U,
    kSrdoCount = 1U,      ///< Not 1 to 64.
    kSrdoNumbers = 2U,    ///< Not 1 to 64 in ascending order, or with a gap where gaps are refused.
    kNodeId = 3U,         ///< Not 1 to 127.
    kGranularity = 4U,    ///< Not 1, 8, 16, 32 or 64.
    kPorts = 5U,          ///< Not kFirst or kSecond.
    kObjects = 6U,        ///< Out of order, a length not 1 to 64, no place, or more than 1024.
    kTiming = 7U,         ///< A time outside its range.
    kBusOrder = 8U,       ///< The HAL does not guarantee bus order.
    kStamps = 9U,         ///< The HAL does not guarantee stamps.
    kConfirmations = 10U, ///< The HAL does not guarantee confirmations.
    kStorage = 11U,       ///< More SRDOs or map entries than a channel has room for, or an odd number of entries.
};

struct CheckReply
{
    Result result;
    CommunicationIndex index; ///< First faulty SRDO; 0 if none, or if the device digest is not the expected one.
};

struct SignReply
{
    Result result;
    std::uint16_t signature;
};

struct StateReply
{
    Result result;
    SrdoState state;           ///< kFaulted where the channels differ; never kReleased in the device safe state.
    SrdoCause first_cause;     ///< As channel A has it, or channel B where A has none or was demoted.
    std::uint16_t error_count; ///< The greater one of both.
};

struct StatusReply
{
    Result result;
    StatusByte status;
};

/// Parameters of one SRDO that its application works with. [SRS_KRN_023]
struct ParametersReply
{
    Result result;
    std::uint8_t direction;
    std::uint16_t refresh_ms; ///< Refresh time or SCT.
    std::uint8_t map_count;
};

/// Entry of an SRDO's mapping by its number: 1 to the number of mapped entries.
struct MappedEntry
{
    std::uint8_t number;
};

struct MappedReply
{
    Result result;
    VariablePlace variable; ///< Place null: a dummy.
};

/// State of a kernel between Start and Stop. Zero-filled memory is a kernel that was not started. What is short comes
/// first, within the reach of the shortest instructions.
struct KernelRun
{
    std::uint8_t test_number{};
    std::uint8_t received{};
    std::uint8_t transmitted{};
    std::uint8_t transmitted_told{};
    QueueState queue{};
    FlowCallback flow_callback{};
    StatusHandshake handshake{};
    bool started{};
    bool left_operational{}; ///< The channels have not seen it yet.
    bool gfc_seen{};
    bool gfc_open{};
    bool fault_told{};
    std::uint16_t errors{}; ///< Told in this cycle: more than 255 with many consumers.
    std::uint16_t demotions{};
    std::uint32_t cycle{};
    std::uint32_t test_cycles{};
    std::uint32_t cycles_to_test{};
    std::uint32_t shortest_refresh_us{}; ///< Of the producers; 0 without one.
    Instant gfc_until{};                 ///< When an SRDO must have followed the GFC.
    Instant now{};                       ///< By counter A.
    SrdoMask committed{};
    SrdoMask producers{}; ///< What Send may ask for; none outside OPERATIONAL and without a valid configuration.
    SrdoMask requests{};  ///< Told to the channels by the next cycle, as the two below.
    SrdoMask stand_a{};   ///< Producers that only channel A called due.
    SrdoMask stand_b{};
};

/// What a kernel tells of its SRDOs beside what the channels tell.
struct KernelRecord
{
    Verdict verdict{};
    SrdoStatus status{};
};

/// The facade of the certified part: an application links this and the two channels. Not reentrant. All times and
/// frames come in as arguments. Order of use: Start; WriteObject for the configuration; SetNmtState; then, for ever:
/// OnFrame, OnConfirm and OnOverflow for everything that happened on the bus, in bus order, then Cycle.
class Kernel
{
  public:
    explicit Kernel(const KernelParts& parts) noexcept;

    /// @brief Power-on. `config` is kept by reference and checked here. O(srdo_count + objects) [SRS_KRN_001]
    [[nodiscard]] StartResult Start(const DeviceConfig& config, FlowCallback flow,
                                    StatusHandshake handshake = StatusHandshake::kOff) noexcept;
    /// @brief The kernel is no longer used: permits are withdrawn, objects of consumers take the safe value, everything
    /// is refused until Start. [SRS_KRN_025, SRS_KRN_029]
    void Stop() noexcept;

    /// @brief A received frame, in bus order. O(payload) [SRS_KRN_007, SRS_KRN_008]
    void OnFrame(const StampedFrame& frame) noexcept;
    /// @brief A frame of this device was on the bus, in bus order with the received ones. [SRS_KRN_014]
    void OnConfirm(const StampedFrame& frame) noexcept;
    /// @brief Frames were lost between controller and kernel. [SRS_KRN_009]
    void OnOverflow() noexcept
    {
        run_.queue = QueueState::kOverflowed;
    }
    /// @brief One cycle. O(srdo_count) [SRS_KRN_002]
    void Cycle(const CycleCall& call) noexcept;

    /// @brief NMT state of the node. Leaving OPERATIONAL writes the safe values at once. O(srdo_count) [SRS_KRN_010,
    /// SRS_KRN_029]
    void SetNmtState(NmtState state) noexcept;
    /// @brief 1300h to 13FFh and the mappable variables. [SRS_CFG_040, SRS_CFG_041, SRS_CFG_042, SRS_CFG_043,
    /// SRS_CFG_044, SRS_CFG_045, SRS_CFG_046, SRS_CFG_047]
    [[nodiscard]] ObjectReading ReadObject(const ObjectAddress& address) noexcept
    {
        return guard_.Read(KeyOf(address));
    }
    [[nodiscard]] AbortCode WriteObject(const ObjectAddress& address, const ObjectData& data) noexcept
    {
        return guard_.Write(KeyOf(address), data);
    }

    /// @brief Requests the transmission of one producer, or of all with index 0. [SRS_KRN_011]
    [[nodiscard]] Result Send(CommunicationIndex index) noexcept;
    /// @brief Sends the global fail-safe command; an SRDO of this device must follow. [SRS_KRN_013]
    [[nodiscard]] Result SendGfc() noexcept;
    /// @brief Checks all SRDOs in both channels: by all rules outside OPERATIONAL, by signature and resolved mapping in
    /// it; then the device digest. [SRS_KRN_015]
    [[nodiscard]] CheckReply CheckConfiguration() noexcept;
    /// @brief The device digest as both channels compute it now, whatever is expected: what 5F04h has to hold. O(slots)
    /// [SRS_KRN_015]
    [[nodiscard]] DigestReply Digest() noexcept
    {
        return guard_.Digest();
    }
    /// @brief Signature of one SRDO as both channels compute it. [SRS_KRN_015]
    [[nodiscard]] SignReply Sign(CommunicationIndex index) noexcept;
    /// @brief State of one SRDO. [SRS_KRN_015]
    [[nodiscard]] StateReply GetState(CommunicationIndex index) const noexcept;
    /// @brief Status byte of one SRDO, for callbacks too. [SRS_KRN_021]
    [[nodiscard]] StatusReply GetStatus(CommunicationIndex index) const noexcept;
    [[nodiscard]] Result SetStatus(CommunicationIndex index, StatusByte status) noexcept;
    /// @brief Parameters of one SRDO, and its mapped variables by number. [SRS_KRN_023]
    [[nodiscard]] ParametersReply GetParameters(CommunicationIndex index) const noexcept;
    [[nodiscard]] MappedReply GetMapped(CommunicationIndex index, MappedEntry entry) const noexcept;
    /// @brief The fields of an SRDO with a static mapping; clears 13FEh. [SRS_KRN_024]
    [[nodiscard]] Result DefineStaticFields(CommunicationIndex index, const StaticFields& fields) noexcept;

    /// @brief The stored configuration, item by item, for a store of the device. Loading and restoring takes time for
    /// each item (`header.count`) and is refused in OPERATIONAL; a device that cannot spare it in one cycle does it
    /// before the first one. [SRS_CFG_051, SRS_CFG_052, SRS_CFG_053]
    [[nodiscard]] HeaderReply ConfigurationHeader() noexcept
    {
        return guard_.Header(guard_.Valid());
    }
    [[nodiscard]] ItemReply ReadItem(const std::uint32_t number) noexcept
    {
        return guard_.ReadItem(number);
    }
    [[nodiscard]] Result LoadItem(const std::uint32_t number, const std::uint32_t value) noexcept
    {
        return guard_.LoadItem(number, value);
    }
    /// @brief After all items: rechecks everything, and declares it valid if it was and still is. Else the power-on
    /// configuration is restored.
    [[nodiscard]] Result LoadConfiguration(const ImageHeader& header) noexcept
    {
        return guard_.Load(header);
    }
    [[nodiscard]] Result RestoreDefaults() noexcept
    {
        return guard_.RestoreDefaults();
    }

    /// @brief The application demands the device safe state. [SRS_KRN_031]
    void DemandSafeState() noexcept
    {
        latch_.Enter(DeviceFault::kApplication, kNoSlot);
    }
    /// @brief The link to the other CPU is lost or wrong. [SRS_LNK_006]
    void OnCrossLinkFault() noexcept
    {
        latch_.Enter(DeviceFault::kCrossLink, kNoSlot);
    }
    /// @brief fault kNone while running. [SRS_KRN_003]
    [[nodiscard]] DeviceFaultReport DeviceState() const noexcept
    {
        return latch_.Report();
    }
    /// @brief How often a channel was demoted since Start; stays at 65535. [SRS_CMP_004]
    [[nodiscard]] std::uint16_t DemotionCount() const noexcept
    {
        return run_.demotions;
    }
    /// @brief The comparator's last verdict, for diagnosis only: nothing is granted from it.
    [[nodiscard]] const Verdict& LastVerdict() const noexcept
    {
        return record_.verdict;
    }

  private:
    // What is used in one source file alone is inline: the compiler then decides whether it needs a call of its own.
    [[nodiscard]] static inline StartResult CheckNumbers(const DeviceConfig& config) noexcept;
    [[nodiscard]] static inline StartResult CheckObjects(const DeviceConfig& config) noexcept;
    [[nodiscard]] static inline StartResult CheckTiming(const DeviceConfig& config) noexcept;
    [[nodiscard]] inline StartResult CheckRoom(const DeviceConfig& config) const noexcept;
    [[nodiscard]] static bool Fits(const DeviceConfig& config, const Channel& channel) noexcept;
    [[nodiscard]] inline StartResult CheckPlatform(const DeviceConfig& config) const noexcept;
    [[nodiscard]] inline SlotIndex SlotAt(std::uint32_t index) const noexcept;
    [[nodiscard]] CommunicationIndex IndexOf(const SlotIndex slot) const noexcept
    {
        const std::uint32_t number = config_->srdos[slot].number; // MISRA D-002
        return CommunicationIndex{static_cast<std::uint16_t>((kFirstCommunication - 1U) + number)};
    }
    /// @brief Why a call finds no SRDO. [SRS_KRN_030]
    [[nodiscard]] Result Missing() const noexcept
    {
        return run_.started ? Result::kNotExist : Result::kDeviceFault;
    }
    [[nodiscard]] Result SendReadiness() const noexcept;
    [[nodiscard]] inline Result Request(SlotIndex wanted, SrdoMask to_send) noexcept;
    [[nodiscard]] Result WhyNotSent(SlotIndex wanted) const noexcept;
    [[nodiscard]] inline PartsView ExamineSelf() noexcept;
    /// @brief Producers while nothing is sent because of the device safe state: every refresh stands still, every one
    /// is asked to send, and nothing is missed. [SRS_KRN_004]
    [[nodiscard]] SrdoMask Halted() const noexcept
    {
        return run_.producers & ~latch_.Gate();
    }
    [[nodiscard]] inline CycleInput TakeInput(const CycleCall& call) noexcept;
    inline void CompareOutcomes(const Comparison& comparison, CycleOutcome& outcome_b) noexcept;
    void TestComparator(const Comparison& comparison, CycleOutcome& outcome_b) noexcept;
    inline void Demote() noexcept;
    [[nodiscard]] inline SrdoMask Commit() noexcept; ///< Consumers whose new pair was released.
    void Produce() noexcept;
    inline void ProduceSlot(SlotIndex slot) noexcept;
    void GiveUp(SlotIndex slot, SrdoCause cause) noexcept;
    [[nodiscard]] inline hal::TransmitStatus HandOver(SlotIndex slot, const CanFrame& frame) noexcept;
    void Withdraw() noexcept; ///< Nothing is released any more: all objects of consumers take the safe value.
    inline void FollowGfc() noexcept;
    inline void EnterOperational() noexcept;
    void ReportErrors(SrdoMask signalled) noexcept;
    inline void ReportEvent(SlotIndex slot) noexcept;
    void ExamineHandshake() noexcept;
    inline void ReportSlot(SlotIndex slot) noexcept;
    void ReportReceived(SrdoMask received) noexcept;
    void ReportDevice() noexcept;
    void ReportFlow(const CycleOutcome& outcome) noexcept;
    void Deliver(FlowEvent event, std::uint16_t count) noexcept;
    inline void GivePermits(std::uint32_t challenge) noexcept;

    KernelRun run_{};
    KernelParts parts_;
    const DeviceConfig* config_; ///< Never null: a device without SRDOs before Start.
    SafeStateLatch latch_{};
    ConfigurationGuard guard_;
    Comparator comparator_{};
    FlowMonitor flow_{};
    ClockSupervisor clocks_{};
    KernelRecord record_{};
};

} // namespace counterpoint

#endif
