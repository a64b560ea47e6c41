// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/zynqmp/two_cpu/core.hpp"

#include "verification/target/zynqmp/two_cpu/board.hpp"
#include "verification/target/zynqmp/two_cpu/own_channel.hpp"

namespace counterpoint::two_cpu
{
namespace
{
constexpr std::uint8_t kNodeId = 2U;
constexpr std::uint16_t kValue = 0x3AC5U;
} // namespace

InstantPair OwnClock(const InstantPair& counters) noexcept
{
    const Instant own = (OwnRole() == PeerRole::kA) ? counters.a : counters.b;
    return InstantPair{own, own};
}

RefreshAnswer ProcessApplication::OnRefresh(const CommunicationIndex /*index*/) noexcept
{
    for (std::uint32_t byte = 0U; byte < 2U; ++byte)
    {
        tx_normal[byte] = static_cast<std::uint8_t>(kValue >> (8U * byte));
        tx_inverse[byte] = static_cast<std::uint8_t>(~kValue >> (8U * byte));
    }
    return RefreshAnswer::kReady;
}

void ProcessApplication::OnSrdoEvent(const CommunicationIndex index) noexcept
{
    std::uint32_t& count = (index.value == 0x1301U) ? received : sent;
    ++count;
}

void ProcessApplication::OnSrdoError(const CommunicationIndex /*index*/, const SrdoCause /*cause*/) noexcept
{
}

void ProcessApplication::OnConfigurationInvalid(const CommunicationIndex /*index*/) noexcept
{
}

void ProcessApplication::OnDeviceFault(const DeviceFaultReport& /*report*/) noexcept
{
}

Core::Core() noexcept
    : peer{OwnChannel(), OwnBoard().Watchdog(), OwnLink()},
      kernel{KernelParts{peer.VoiceA(), peer.VoiceB(), OwnBoard().Can(), OwnBoard().Output(), peer.Watchdog(),
                         application}},
      services_{cia301::NodeId{kNodeId}, (OwnRole() == PeerRole::kA) ? &OwnBoard().Can() : nullptr},
      device_{device::BareParts{kernel, services_, *this, device::FrameRoom{&frames_[0], 6U}, 2U}}
{
}

LinkConfig Core::OwnLink() noexcept
{
    return LinkConfig{OwnRole(), kLinkTimeoutUs, kLinkTimeoutUs / 2U, 10U * kLinkTimeoutUs, kStampToleranceUs};
}

void Core::Describe() noexcept
{
    objects_[0] = MappableObject{0x2000U, 1U, 16U, MapAccess::kProducer, &application.tx_normal[0]};
    objects_[1] = MappableObject{0x2100U, 1U, 16U, MapAccess::kProducer, &application.tx_inverse[0]};
    objects_[2] = MappableObject{0x2200U, 1U, 16U, MapAccess::kConsumer, &application.rx_normal[0]};
    objects_[3] = MappableObject{0x2300U, 1U, 16U, MapAccess::kConsumer, &application.rx_inverse[0]};
    setups_[0U].number = 1U;
    setups_[0U].policy = ReleasePolicy::kAutomatic;
    setups_[1U].number = 2U;
    setups_[1U].form = ProducerForm::kProviderCalled;
    config_.srdos = &setups_[0];
    config_.srdo_count = 2U;
    config_.objects = &objects_[0];
    config_.object_count = 4U;
    config_.node_id = kNodeId;
    config_.granularity_bits = 8U;
    config_.map_entries = 2U;
    config_.normal_port = CanPortId::kFirst;
    config_.inverse_port = CanPortId::kFirst;
    config_.cycle_us = kCycleUs;
    config_.cycle_tolerance_us = kToleranceUs;
    config_.discrepancy_us = kDiscrepancyUs;
    config_.acknowledge_window_us = 100000U;
    config_.diagnostic_interval_us = 16U * kCycleUs;
    config_.test_interval_us = 15U * (kCycleUs + kToleranceUs);
    config_.clock_tolerance_us = kCycleUs;
    config_.clock_interval_us = 100U * kCycleUs;
}

void Core::Write(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value,
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

void Core::SetUp(const std::uint8_t number, const std::uint16_t first_object, const std::uint8_t direction) noexcept
{
    const auto mapping = static_cast<std::uint16_t>(0x1380U + number);
    const auto communication = static_cast<std::uint16_t>(0x1300U + number);
    const std::uint32_t normal = (static_cast<std::uint32_t>(first_object) << 16U) | 0x0110U;
    Write(mapping, 1U, normal, 4U);
    Write(mapping, 2U, normal + 0x01000000U, 4U);
    Write(mapping, 0U, 2U, 1U);
    Write(communication, 2U, (direction == kDirectionProducer) ? (kRefreshUs / 1000U) : kSctMs, 2U);
    Write(communication, 3U, kSrvtMs, 1U);
    Write(communication, 5U, 0xFFU + (2U * number), 4U);
    Write(communication, 6U, 0x100U + (2U * number), 4U);
    Write(communication, 1U, direction, 1U);
}

device::LoadResult Core::OnResetCommunication() noexcept
{
    SetUp(1U, 0x2200U, kDirectionConsumer);
    SetUp(2U, 0x2000U, kDirectionProducer);
    for (std::uint8_t number = 1U; number <= 2U; ++number)
    {
        const SignReply reply = kernel.Sign(CommunicationIndex{static_cast<std::uint16_t>(0x1300U + number)});
        Write(0x13FFU, number, reply.signature, 2U);
    }
    Write(0x13FEU, 0U, kConfigurationValidValue, 1U);
    return is_configured_ ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
}

device::LoadResult Core::OnResetNode() noexcept
{
    Describe();
    const bool is_started = (CheckLinkConfig(config_, OwnLink()) == LinkConfigFault::kNone) &&
                            (kernel.Start(config_, FlowCallback::kOff) == StartResult::kStarted);
    return is_started ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
}

bool Core::PowerOn(const Instant now) noexcept
{
    return device_.PowerOn(now) == device::LoadResult::kLoaded;
}

void Core::OnBus(const StampedFrame& frame, const bool is_own, const Instant now) noexcept
{
    if (is_own || peer.IsEcho(frame.frame))
    {
        device_.OnConfirm(frame);
    }
    else
    {
        device_.OnFrame(frame);
    }
    device_.Serve(now); // The inverse frame at once, a command too.
}

void Core::OnLoss() noexcept
{
    device_.OnLoss();
}

void Core::Cycle(const InstantPair& now, hal::LinkFrame& message) noexcept
{
    if (peer.Examine(now.a) != LinkFinding::kNone)
    {
        kernel.OnCrossLinkFault();
    }
    device_.Cycle(CycleCall{now, 0U, 0U});
    peer.Compose(PeerMoment{now.a, kernel.DeviceState().fault}, message);
}

std::uint32_t Core::LimitOfLink() const noexcept
{
    return ComputeLimit(config_, LinkTime{kLinkTimeoutUs}).us;
}

std::uint32_t Core::LimitOf(const FaultClass fault) const noexcept
{
    return ComputeLimit(config_, SrdoTimes{kSctMs, kSrvtMs}, fault).us;
}

} // namespace counterpoint::two_cpu
