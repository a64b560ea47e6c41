// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_KERNEL_HPP
#define SAFETY_CORE_KERNEL_KERNEL_HPP

#include "safety_core/kernel/clock_supervisor.hpp"
#include "safety_core/kernel/communication_index.hpp"
#include "safety_core/kernel/configuration_guard.hpp"
#include "safety_core/kernel/configuration_image.hpp"
#include "safety_core/kernel/decision.hpp"
#include "safety_core/kernel/flow_monitor.hpp"
#include "safety_core/kernel/kernel_context.hpp"
#include "safety_core/kernel/object_access.hpp"
#include "safety_core/kernel/production.hpp"
#include "safety_core/kernel/reporting.hpp"
#include "safety_core/kernel/result.hpp"
#include "safety_core/kernel/second_nmt.hpp"
#include "safety_core/kernel/start_check.hpp"
#include "safety_core/kernel/variable.hpp"

#include <cstdint>

namespace counterpoint
{

/// Inputs of one cycle. Bit n of the acknowledge levels is slot n; each channel is given a reading of its own.
struct CycleCall
{
    InstantPair now;
    SrdoMask acknowledge_a;
    SrdoMask acknowledge_b;
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
    SrdoState state;       ///< kFaulted where the channels differ; kReleased neither in the device safe state nor once
                           ///< OPERATIONAL was left, where it is kOff.
    SrdoCause first_cause; ///< As channel A has it, or channel B where A has none or was demoted; told first.
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

/// State of the cycle between Start and Stop. Zero-filled memory is a kernel that was not started.
struct KernelRun
{
    QueueState queue{};
    bool started{};
    bool left_operational{}; ///< Channel A has not seen it yet.
    std::uint32_t cycle{};
    std::uint32_t frames{}; ///< Marks of frames that came, less of those that both channels have. [SRS_KRN_034]
};

/// The facade of the certified part: an application links this and the two channels. Not reentrant. All times and
/// frames come in as arguments. Order of use: Start; WriteObject for the configuration; SetNmtState; then, for ever:
/// OnFrame, OnConfirm and OnOverflow for everything that happened on the bus, in bus order, then Cycle.
class Kernel
{
  public:
    explicit Kernel(const KernelParts& parts) noexcept;

    /// @brief Power-on. `config` is kept by reference and checked here. O(srdo_count + objects) [SRS_KRN_001,
    /// SRS_KRN_572]
    [[nodiscard]] StartResult Start(const DeviceConfig& config, FlowCallback flow,
                                    StatusHandshake handshake = StatusHandshake::kOff) noexcept;
    /// @brief The kernel is no longer used: permits are withdrawn, objects of consumers take the safe value, everything
    /// is refused until Start. [SRS_KRN_025, SRS_KRN_029]
    void Stop() noexcept;

    /// @brief A received frame, in bus order. O(payload) [SRS_KRN_007, SRS_KRN_008]
    void OnFrame(const StampedFrame& frame) noexcept;
    /// @brief A frame of this device was on the bus, in bus order with the received ones. [SRS_KRN_214]
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
    /// SRS_CFG_044, SRS_CFG_045, SRS_CFG_046, SRS_CFG_047, SRS_CFG_340, SRS_CFG_341, SRS_CFG_342]
    [[nodiscard]] ObjectReading ReadObject(const ObjectAddress& address) noexcept
    {
        return context_.guard.Read(KeyOf(address));
    }
    [[nodiscard]] AbortCode WriteObject(const ObjectAddress& address, const ObjectData& data) noexcept
    {
        return context_.guard.Write(KeyOf(address), data);
    }

    /// @brief Requests the transmission of one producer, or of all with index 0, in either form. Made while the refresh
    /// waits it is one pair with it. [SRS_KRN_011]
    [[nodiscard]] Result Send(CommunicationIndex index) noexcept;
    /// @brief Sends the global fail-safe command; an SRDO of this device must follow. [SRS_KRN_013]
    [[nodiscard]] Result SendGfc() noexcept;
    /// @brief Checks all SRDOs in both channels: by all rules outside OPERATIONAL, by signature and resolved mapping in
    /// it; then the device digest. [SRS_KRN_015, SRS_KRN_210, SRS_KRN_211]
    [[nodiscard]] CheckReply CheckConfiguration() noexcept;
    /// @brief The device digest as both channels compute it now, whatever is expected: what 5F04h has to hold. O(slots)
    /// [SRS_KRN_150]
    [[nodiscard]] DigestReply Digest() noexcept
    {
        return context_.guard.Digest();
    }
    /// @brief Signature of one SRDO as both channels compute it. [SRS_KRN_151]
    [[nodiscard]] SignReply Sign(CommunicationIndex index) noexcept;
    /// @brief State of one SRDO. [SRS_KRN_152]
    [[nodiscard]] StateReply GetState(CommunicationIndex index) const noexcept;
    /// @brief Status byte of one SRDO, for callbacks too. [SRS_KRN_021]
    [[nodiscard]] StatusReply GetStatus(CommunicationIndex index) const noexcept;
    [[nodiscard]] Result SetStatus(CommunicationIndex index, StatusByte status) noexcept;
    /// @brief Parameters of one SRDO, and its mapped variables by number. [SRS_KRN_023]
    [[nodiscard]] ParametersReply GetParameters(CommunicationIndex index) const noexcept;
    [[nodiscard]] MappedReply GetMapped(CommunicationIndex index, MappedEntry entry) const noexcept;
    /// @brief The fields of an SRDO with a static mapping; clears 13FEh. [SRS_KRN_024]
    [[nodiscard]] Result DefineStaticFields(CommunicationIndex index, const StaticFields& fields) noexcept;

    /// @brief The stored configuration, item by item, for a store of the device. [SRS_CFG_051, SRS_CFG_052,
    /// SRS_CFG_053]
    [[nodiscard]] ConfigurationImage Image() noexcept
    {
        return ConfigurationImage{context_.guard};
    }

    /// @brief The application demands the device safe state. [SRS_KRN_031]
    void DemandSafeState() noexcept
    {
        context_.latch.Demand(DeviceFault::kApplication);
    }
    /// @brief The link to the other CPU is lost or wrong. [SRS_LNK_006]
    void OnCrossLinkFault() noexcept
    {
        context_.latch.Demand(DeviceFault::kCrossLink);
    }
    /// @brief fault kNone while running. [SRS_KRN_003]
    [[nodiscard]] DeviceFaultReport DeviceState() const noexcept
    {
        return context_.latch.Report();
    }
    /// @brief How often a channel was demoted since Start; stays at 65535. [SRS_CMP_340]
    [[nodiscard]] std::uint16_t DemotionCount() const noexcept
    {
        return decision_.Demotions();
    }
    /// @brief The comparator's last verdict, for diagnosis only: nothing is granted from it.
    [[nodiscard]] const Verdict& LastVerdict() const noexcept
    {
        return decision_.LastVerdict();
    }

  private:
    /// @brief Why a call finds no SRDO. [SRS_KRN_030]
    [[nodiscard]] Result Missing() const noexcept
    {
        return run_.started ? Result::kNotExist : Result::kDeviceFault;
    }
    // What is used in one place alone is inline: the compiler then decides whether it needs a call of its own.
    [[nodiscard]] inline PartsView ExamineSelf() noexcept;
    [[nodiscard]] inline CycleInput TakeInput(const CycleCall& call, std::uint32_t challenge,
                                              std::uint32_t token) noexcept;

    KernelRun run_{};
    SecondNmt second_nmt_{};
    FlowMonitor flow_{}; ///< Called by way of the parts alone. [SRS_KRN_039]
    KernelContext context_;
    ClockSupervisor clocks_{};
    Reporting reporting_{};
    Production production_{};
    Decision decision_{};
};

} // namespace counterpoint

#endif
