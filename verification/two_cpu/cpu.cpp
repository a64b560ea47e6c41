// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/two_cpu/cpu.hpp"

#include <stdexcept>

namespace counterpoint::two_cpu
{
namespace
{
constexpr std::uint8_t kNodeId = 2U;

[[nodiscard]] Instant TrueInstant(const double true_us)
{
    return Instant{static_cast<std::uint32_t>(static_cast<std::int64_t>(true_us))};
}
} // namespace

RefreshAnswer ProcessApplication::OnRefresh(CommunicationIndex /*index*/) noexcept
{
    const std::uint32_t value = static_cast<std::uint32_t>(process) + offset;
    tx_normal = {static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value >> 8U)};
    tx_inverse = {static_cast<std::uint8_t>(~value), static_cast<std::uint8_t>(~value >> 8U)};
    return RefreshAnswer::kReady;
}

void ProcessApplication::OnSrdoEvent(const CommunicationIndex index) noexcept
{
    (index.value == 0x1301U) ? ++received : ++sent;
}

void ProcessApplication::OnSrdoError(const CommunicationIndex index, const SrdoCause cause) noexcept
{
    if (cause != SrdoCause::kWaitingPastSct)
    {
        (index.value == 0x1301U) ? ++consumer_errors : ++producer_errors;
    }
}

Cpu::Cpu(const PeerRole role, const Timing& timing, const CpuClock& its_clock)
    : clock{its_clock}, timing_{timing}, channel_a_{storage_a_.Handle()}, channel_b_{storage_b_.Handle()},
      tap{(role == PeerRole::kA) ? static_cast<Channel&>(channel_a_) : static_cast<Channel&>(channel_b_)},
      peer{tap, watchdog, LinkOf(role, timing)},
      kernel{KernelParts{peer.VoiceA(), peer.VoiceB(), ports, output, peer.Watchdog(), application}},
      services_{cia301::NodeId{kNodeId}, (role == PeerRole::kA) ? &ports : nullptr},
      device_{device::BareParts{kernel, services_, *this, device::FrameRoom{frames_.data(), 6U}, 2U}}
{
}

LinkConfig Cpu::LinkOf(const PeerRole role, const Timing& timing)
{
    return LinkConfig{role, timing.timeout_us, timing.timeout_us / 2U, 10U * timing.timeout_us,
                      timing.stamp_tolerance_us};
}

void Cpu::Describe() noexcept
{
    objects_ = {MappableObject{0x2000U, 1U, 16U, MapAccess::kProducer, application.tx_normal.data()},
                MappableObject{0x2100U, 1U, 16U, MapAccess::kProducer, application.tx_inverse.data()},
                MappableObject{0x2200U, 1U, 16U, MapAccess::kConsumer, application.rx_normal.data()},
                MappableObject{0x2300U, 1U, 16U, MapAccess::kConsumer, application.rx_inverse.data()}};
    setups_[0U].number = 1U;
    setups_[0U].policy = ReleasePolicy::kAutomatic;
    setups_[1U].number = 2U;
    setups_[1U].form = ProducerForm::kProviderCalled;
    config_.srdos = setups_.data();
    config_.srdo_count = 2U;
    config_.objects = objects_.data();
    config_.object_count = 4U;
    config_.node_id = kNodeId;
    config_.granularity_bits = 8U;
    config_.map_entries = 2U;
    config_.normal_port = CanPortId::kFirst;
    config_.inverse_port = CanPortId::kFirst;
    config_.cycle_us = timing_.cycle_us;
    config_.cycle_tolerance_us = timing_.tolerance_us;
    config_.discrepancy_us = timing_.discrepancy_us;
    config_.acknowledge_window_us = 100'000U;
    config_.diagnostic_interval_us = 16U * timing_.cycle_us;
    config_.test_interval_us = 15U * (timing_.cycle_us + timing_.tolerance_us);
    config_.clock_tolerance_us = timing_.cycle_us;
    config_.clock_interval_us = 100U * timing_.cycle_us;
}

void Cpu::Write(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value,
                const std::uint8_t size) noexcept
{
    ObjectData data{};
    data.size_bytes = size;
    for (std::uint32_t byte = 0U; byte < size; ++byte)
    {
        data.bytes[byte] = static_cast<std::uint8_t>(value >> (8U * byte));
    }
    is_configured_ = (kernel.WriteObject(ObjectAddress{index, sub}, data) == AbortCode::kNone) && is_configured_;
}

device::LoadResult Cpu::OnResetCommunication() noexcept
{
    const auto set = [this](std::uint8_t number, std::uint16_t first_object, std::uint8_t direction)
    {
        const std::uint16_t mapping = static_cast<std::uint16_t>(0x1380U + number);
        const std::uint16_t communication = static_cast<std::uint16_t>(0x1300U + number);
        const std::uint32_t normal = (static_cast<std::uint32_t>(first_object) << 16U) | 0x0110U;
        const std::uint32_t inverse = normal + 0x01000000U;
        Write(mapping, 1U, normal, 4U);
        Write(mapping, 2U, inverse, 4U);
        Write(mapping, 0U, 2U, 1U);
        const std::uint16_t own_refresh_ms = static_cast<std::uint16_t>(timing_.refresh_us / 1000U);
        Write(communication, 2U, (direction == kDirectionProducer) ? own_refresh_ms : timing_.sct_ms, 2U);
        Write(communication, 3U, timing_.srvt_ms, 1U);
        Write(communication, 5U, 0xFFU + (2U * number), 4U);
        Write(communication, 6U, 0x100U + (2U * number), 4U);
        Write(communication, 1U, direction, 1U);
    };
    set(1U, 0x2200U, kDirectionConsumer);
    set(2U, 0x2000U, kDirectionProducer);
    for (std::uint8_t number = 1U; number <= 2U; ++number)
    {
        const SignReply reply = kernel.Sign(CommunicationIndex{static_cast<std::uint16_t>(0x1300U + number)});
        Write(0x13FFU, number, reply.signature, 2U);
    }
    Write(0x13FEU, 0U, kConfigurationValidValue, 1U);
    return is_configured_ ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
}

device::LoadResult Cpu::OnResetNode() noexcept
{
    Describe();
    const LinkConfigFault fault = CheckLinkConfig(config_, LinkOf(PeerRole::kA, timing_));
    const bool is_started =
        (fault == LinkConfigFault::kNone) && (kernel.Start(config_, FlowCallback::kOff) == StartResult::kStarted);
    return is_started ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
}

void Cpu::PowerOn(const double true_us)
{
    watchdog.timer.Start(hal::WatchdogWindow{timing_.cycle_us / 8U, (2U * timing_.cycle_us) + timing_.tolerance_us},
                         TrueInstant(true_us - timing_.cycle_us));
    if (device_.PowerOn(clock.At(true_us)) != device::LoadResult::kLoaded)
    {
        throw std::runtime_error("two_cpu: the kernel refuses to start, or its configuration");
    }
}

void Cpu::OnBus(const CanFrame& frame, const bool is_own, const double true_us)
{
    const Instant stamp = clock.At(true_us);
    const StampedFrame stamped{frame, InstantPair{stamp, stamp}};
    if (is_own || peer.IsEcho(frame))
    {
        device_.OnConfirm(stamped);
    }
    else
    {
        device_.OnFrame(stamped);
    }
    device_.Serve(stamp); // The inverse frame at once, a command too.
}

void Cpu::OnLink(const hal::LinkFrame& frame, const double true_us)
{
    peer.OnMessage(frame, clock.At(true_us));
}

void Cpu::Cycle(const double true_us, hal::LinkFrame& message)
{
    const Instant now = clock.At(true_us);
    output.now = TrueInstant(true_us);
    watchdog.now = TrueInstant(true_us);
    application.process = static_cast<std::uint16_t>(true_us / 64'000'000.0);
    if (peer.Examine(now) != LinkFinding::kNone)
    {
        kernel.OnCrossLinkFault();
    }
    device_.Cycle(CycleCall{InstantPair{now, now}, 0U, 0U});
    peer.Compose(PeerMoment{now, kernel.DeviceState().fault}, message);
}

bool Cpu::IsOpen(const double true_us)
{
    const Instant now = TrueInstant(true_us);
    watchdog.timer.Examine(now);
    const SrdoMask open = output.gate.Open(now, hal::GateLimit{timing_.cycle_us + timing_.tolerance_us});
    return watchdog.timer.IsAlive() && ((open & 1U) != 0U);
}

} // namespace counterpoint::two_cpu
