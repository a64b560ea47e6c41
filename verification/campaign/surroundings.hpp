// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_SURROUNDINGS_HPP
#define VERIFICATION_CAMPAIGN_SURROUNDINGS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/api/watchdog_timer.hpp"
#include "safety_core/kernel/application.hpp"
#include "safety_core/kernel/flow_monitor.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

/// What stands around kernel and channels of the device under test. All of it is plain memory in the region.
namespace counterpoint::campaign
{
/// Moments of a cycle at which a fault begins, and at which a bit that is stuck is forced again. [SRS_CMG_003]
enum class Phase : std::uint8_t
{
    kBeforeFrames = 0U,
    kBetweenFrames = 1U, ///< Behind the first frame; without frames like kAfterFrames.
    kAfterFrames = 2U,   ///< Before Cycle.
    kFirstStep = 3U,     ///< From here on: behind each step of the flow, in the order of FlowStep.
};
constexpr std::uint8_t kPhaseCount = static_cast<std::uint8_t>(Phase::kFirstStep) + kFlowStepCount;

/// Is told each phase of a cycle of the device under test.
class PhaseHook
{
  public:
    virtual void At(Phase phase) noexcept = 0;

    PhaseHook(const PhaseHook&) = delete;
    PhaseHook& operator=(const PhaseHook&) = delete;

  protected:
    PhaseHook() noexcept = default;
    ~PhaseHook() noexcept = default;
};

/// The shipped flow monitor, and behind each of its marks a phase.
class TappedFlow : public FlowWatch
{
  public:
    TappedFlow() noexcept = default;
    virtual ~TappedFlow() = default;
    TappedFlow(const TappedFlow&) = delete;
    TappedFlow& operator=(const TappedFlow&) = delete;

    void Begin() noexcept override
    {
        monitor.Begin();
    }
    void Mark(FlowStep step, const FlowEvidence& evidence) noexcept override;
    [[nodiscard]] hal::WatchdogAnswer End(const hal::WatchdogQuestion& question) noexcept override
    {
        return monitor.End(question);
    }
    [[nodiscard]] DeviceFault Finding() const noexcept override
    {
        return monitor.Finding();
    }

    FlowMonitor monitor{};
    PhaseHook* hook{nullptr}; ///< Outside of the region; null while the device is being started.
};

/// A frame of the device on its way: confirmed as soon as it was on the bus.
struct OwnFrame
{
    CanFrame frame;
    std::int64_t confirmed_at; ///< ns
};

constexpr std::size_t kMostOwnFrames = 32U;

/// The controllers: each frame is on the bus so long after it was handed over.
class FlatPorts final : public hal::CanPorts
{
  public:
    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override
    {
        return {hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
    }

    /// @brief Before a cycle: what was confirmed is on the bus; what waits moves to the front.
    void MoveOn() noexcept;

    std::int64_t now{0};                           ///< ns
    std::int64_t frame_ns{0};                      ///< How long a frame takes.
    std::array<OwnFrame, kMostOwnFrames> frames{}; ///< Of this cycle and those not confirmed yet.
    std::uint32_t count{0U};
    std::uint32_t confirmed{0U}; ///< The first so many are.
    std::uint32_t sent{0U};      ///< All that were ever handed over.

  private:
    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;
};

/// The watchdog of the device.
class FlatWatchdog final : public hal::Watchdog
{
  public:
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override
    {
        return timer.Question();
    }
    void Answer(const hal::WatchdogAnswer& answer) noexcept override
    {
        timer.Answer(answer, now);
    }

    hal::WatchdogTimer timer{};
    Instant now{0U}; ///< Time of the bus.
};

/// The output of the device, in series with the watchdog.
class FlatOutput : public hal::SafetyOutput
{
  public:
    FlatOutput() noexcept = default;
    virtual ~FlatOutput() = default;
    FlatOutput(const FlatOutput&) = delete;
    FlatOutput& operator=(const FlatOutput&) = delete;

    [[nodiscard]] std::uint32_t Challenge() noexcept override
    {
        return gate.Challenge();
    }
    void Drive(const hal::PermitSet& permits) noexcept override
    {
        gate.Drive(permits, now);
    }
    [[nodiscard]] hal::ProbeAnswer Probe(const hal::PermitSet& permits, std::uint32_t challenge) const noexcept override
    {
        return hal::OutputGate::Probe(permits, challenge);
    }

    /// @brief Slots that are open now.
    [[nodiscard]] virtual SrdoMask Open() noexcept
    {
        return gate.Open(now, limit);
    }
    /// @brief Once a cycle, before the kernel's: an output that looks at itself may be no longer live behind it.
    virtual void Examine() noexcept
    {
    }

    hal::OutputGate gate{};
    Instant now{0U}; ///< Time of the bus.
    hal::GateLimit limit{0U};
    bool is_live{true}; ///< False: it has cut itself off, and nobody calls the kernel any more.
};

/// What an application was told by the kernel.
struct Told
{
    SrdoMask faulted{0U}; ///< By number of the SRDO, less 1: a cause was told, kWaitingPastSct excepted.
    SrdoCause first_cause{SrdoCause::kNone}; ///< Of them.
    DeviceFault device_fault{DeviceFault::kNone};
};
[[nodiscard]] bool operator==(const Told& left, const Told& right) noexcept;

/// The same three times: the judge believes what the kernel told, not what a channel with a wrong address wrote over
/// one of them. [SRS_CMG_410]
using ToldCopies = std::array<Told, 3U>;
[[nodiscard]] Told MajorityOf(const ToldCopies& copies) noexcept;

/// Whoever has fresh values for a producer whose provider is called. Outside of the region.
class Provider
{
  public:
    [[nodiscard]] virtual RefreshAnswer Provide(CommunicationIndex index) noexcept = 0;

    Provider(const Provider&) = delete;
    Provider& operator=(const Provider&) = delete;

  protected:
    Provider() noexcept = default;
    ~Provider() noexcept = default;
};

/// Notes what it is told, slot by slot. It writes its producers' values when it is asked for them. [SRS_CMG_810]
class FlatApplication final : public Application
{
  public:
    [[nodiscard]] RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override;
    void OnSrdoEvent(CommunicationIndex index) noexcept override;
    void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept override;
    void OnConfigurationInvalid(CommunicationIndex index) noexcept override;
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override;

    /// @brief What it was told. [SRS_CMG_410]
    [[nodiscard]] Told Now() const noexcept
    {
        return MajorityOf(copies);
    }
    /// @brief As if it had been told nothing of SRDOs.
    void ForgetErrors() noexcept;

    ToldCopies copies{};
    Provider* provider{nullptr};

  private:
    void Keep(const Told& told) noexcept;
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_SURROUNDINGS_HPP
