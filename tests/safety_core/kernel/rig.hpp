// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_SAFETY_CORE_KERNEL_RIG_HPP
#define TESTS_SAFETY_CORE_KERNEL_RIG_HPP

#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/api/watchdog_timer.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "safety_core/kernel/variable.hpp"
#include "tests/safety_core/kernel/tap.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <initializer_list>
#include <utility>
#include <vector>

namespace counterpoint
{

/// Takes frames for transmission and keeps them; what it answers is under the test's control.
class RecordingPorts final : public hal::CanPorts
{
  public:
    hal::CanGuarantees Guarantees() const noexcept override
    {
        return guarantees;
    }

    hal::CanGuarantees guarantees{hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
    hal::TransmitStatus answer{hal::TransmitStatus::kAccepted};
    std::vector<CanFrame> sent{};

  private:
    hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override
    {
        if (answer == hal::TransmitStatus::kAccepted)
        {
            sent.push_back(frame);
        }
        return answer;
    }
};

/// The real output gate, driven by the rig's time.
class GateOutput final : public hal::SafetyOutput
{
  public:
    std::uint32_t Challenge() noexcept override
    {
        return gate.Challenge();
    }
    void Drive(const hal::PermitSet& permits) noexcept override
    {
        last = permits;
        gate.Drive(permits, Instant{*now_us});
    }

    hal::OutputGate gate{};
    hal::PermitSet last{};
    const std::uint32_t* now_us{nullptr};
};

/// The real watchdog rule, driven by the rig's time.
class TimerWatchdog final : public hal::Watchdog
{
  public:
    hal::WatchdogQuestion Question() noexcept override
    {
        return timer.Question();
    }
    void Answer(const hal::WatchdogAnswer& answer) noexcept override
    {
        timer.Answer(answer, Instant{*now_us});
    }

    hal::WatchdogTimer timer{};
    const std::uint32_t* now_us{nullptr};
};

/// Keeps what the kernel tells the application.
class RecordingApplication final : public Application
{
  public:
    RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override
    {
        refreshed.push_back(index.value);
        if (on_refresh)
        {
            on_refresh();
        }
        return refresh;
    }
    void OnSrdoEvent(CommunicationIndex index) noexcept override
    {
        events.push_back(index.value);
        if (on_event)
        {
            on_event(index);
        }
    }
    void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept override
    {
        errors.emplace_back(index.value, cause);
        if (on_error)
        {
            on_error(index);
        }
    }
    void OnGfc() noexcept override
    {
        ++gfcs;
    }
    void OnGfcNotFollowed() noexcept override
    {
        ++gfcs_not_followed;
    }
    void OnConfigurationInvalid(CommunicationIndex index) noexcept override
    {
        invalid.push_back(index.value);
    }
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override
    {
        faults.push_back(report.fault);
    }
    void OnFlow(const FlowCount& count) noexcept override
    {
        flow.emplace_back(count.event, count.count);
    }

    std::function<void()> on_refresh{};
    std::function<void(CommunicationIndex)> on_event{};
    std::function<void(CommunicationIndex)> on_error{};
    RefreshAnswer refresh{RefreshAnswer::kReady};
    std::vector<std::uint16_t> refreshed{};
    std::vector<std::uint16_t> events{};
    std::vector<std::pair<std::uint16_t, SrdoCause>> errors{};
    std::vector<std::uint16_t> invalid{};
    std::vector<DeviceFault> faults{};
    std::vector<std::pair<FlowEvent, std::uint16_t>> flow{};
    int gfcs{0};
    int gfcs_not_followed{0};
};

/// A device of three SRDOs with a gap, on real channels behind taps, real gate and real watchdog:
///   SRDO 1 (1301h, slot 0) consumer  101h/102h, 2 bytes, 2200h:01 and 2300h:01, SCT 50 ms, SRVT 20 ms, automatic
///   SRDO 3 (1303h, slot 1) producer  103h/104h, 2 bytes, 2000h:01 and 2100h:01, refresh 25 ms, SRVT 20 ms, provider
///   SRDO 4 (1304h, slot 2) off
/// Cycle 1 ms, tolerance 0.5 ms, discrepancy 5 ms, diagnosis 30 ms, test 45 ms. Node-ID 2.
class Rig : public ::testing::Test
{
  public:
    /// `other` is the kernel's application instead of `application`.
    explicit Rig(SelfTestPart* self_test = nullptr, FlowWatch* flow = nullptr, Application* other = nullptr,
                 bool has_windows = true);

    /// Writes and declares the configuration above; every write must be accepted.
    void Configure();
    /// Configure and OPERATIONAL, one cycle.
    void Operate();
    AbortCode Write(std::uint16_t index, std::uint8_t sub, std::uint32_t value, std::uint8_t size);
    std::uint32_t Read(std::uint16_t index, std::uint8_t sub);
    /// One cycle at the next multiple of the cycle time.
    void Cycle(SrdoMask acknowledge = 0U);
    void Cycles(std::uint32_t count);
    /// A data frame at the present time plus `after_us`, which stays the present time for the next frames.
    void Receive(std::uint32_t identifier, std::initializer_list<std::uint8_t> bytes, std::uint32_t after_us = 0U);
    /// A good pair for SRDO 1: 12h 34h.
    void ReceivePair();
    /// Confirms the frame that was sent last.
    void ConfirmLast();
    /// The pair of SRDO 1 as the application reads it.
    std::uint64_t NormalOut() const;
    std::uint64_t InverseOut() const;
    /// Slots whose outputs are open.
    SrdoMask Open();
    bool WatchdogAlive();
    /// Causes that the application was told for one SRDO, in order.
    std::vector<SrdoCause> CausesOf(std::uint16_t index) const;

    std::array<std::uint8_t, 2> tx_normal{0x12U, 0x34U};
    std::array<std::uint8_t, 2> tx_inverse{0xEDU, 0xCBU};
    std::array<std::uint8_t, 2> rx_normal{};
    std::array<std::uint8_t, 2> rx_inverse{};
    std::array<MappableObject, 5> objects{};
    std::array<SrdoSetup, 3> setups{};
    DeviceConfig config{};
    FlowCallback flow_callback{FlowCallback::kOn};
    StatusHandshake handshake{StatusHandshake::kOff};
    bool has_gfc{true}; ///< Configure writes 1 to 1300h.

    channel_a::StorageFor<3U> storage_a{};
    channel_b::StorageFor<3U> storage_b{};
    channel_a::Channel real_a;
    channel_b::Channel real_b;
    Tap a;
    Tap b;
    RecordingPorts ports{};
    GateOutput output{};
    TimerWatchdog watchdog{};
    RecordingApplication application{};
    CauseWindows windows[3]{};
    Kernel kernel;
    std::uint32_t now_us{5000U};
};

} // namespace counterpoint

#endif
