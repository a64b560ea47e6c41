// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"

#include <algorithm>

namespace counterpoint
{

Rig::Rig(SelfTestPart* const self_test, FlowWatch* const flow, Application* const other, const bool has_windows)
    : real_a{storage_a.Handle()}, real_b{storage_b.Handle()}, a{real_a}, b{real_b},
      kernel{KernelParts{a, b, ports, output, watchdog, (other == nullptr) ? application : *other, self_test,
                         has_windows ? &windows[0] : nullptr, flow}}
{
    objects = {MappableObject{0x2000U, 1U, 16U, MapAccess::kProducer, tx_normal.data()},
               MappableObject{0x2100U, 1U, 16U, MapAccess::kProducer, tx_inverse.data()},
               MappableObject{0x2200U, 1U, 16U, MapAccess::kConsumer, rx_normal.data()},
               MappableObject{0x2300U, 1U, 16U, MapAccess::kConsumer, rx_inverse.data()},
               MappableObject{0x2400U, 1U, 16U, MapAccess::kNone, rx_inverse.data()}};
    const auto setup = [](std::uint8_t number, ReleasePolicy policy, ProducerForm form, Payload safe_value)
    { return SrdoSetup{number, policy, form, safe_value, SrvtDetection::kEarly, StaticMap{nullptr, 0U}}; };
    setups = {setup(1U, ReleasePolicy::kAutomatic, ProducerForm::kApplicationSends, Payload{0x7F01U, 0U}),
              setup(3U, ReleasePolicy::kInterlock, ProducerForm::kProviderCalled, Payload{0U, 0U}),
              setup(4U, ReleasePolicy::kInterlock, ProducerForm::kApplicationSends, Payload{0U, 0U})};
    config.srdos = setups.data();
    config.srdo_count = 3U;
    config.objects = objects.data();
    config.object_count = 5U;
    config.node_id = 2U;
    config.granularity_bits = 8U;
    config.map_entries = 16U;
    config.gaps = NumberGaps::kSearched;
    config.gfc = GfcUse::kPresent;
    config.normal_port = CanPortId::kFirst;
    config.inverse_port = CanPortId::kFirst;
    config.cycle_us = 1000U;
    config.cycle_tolerance_us = 500U;
    config.discrepancy_us = 5000U;
    config.acknowledge_window_us = 100000U;
    config.diagnostic_interval_us = 30000U;
    config.test_interval_us = 45000U;
    config.clock_tolerance_us = 200U;
    config.clock_interval_us = 100000U;
    config.output_time_us = 1000U;
    output.now_us = &now_us;
    watchdog.now_us = &now_us;
    watchdog.timer.Start(hal::WatchdogWindow{500U, 1600U}, Instant{now_us});
}

AbortCode Rig::Write(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value,
                     const std::uint8_t size)
{
    ObjectData data{};
    data.size_bytes = size;
    for (std::uint32_t byte = 0U; byte < size; ++byte)
    {
        data.bytes[byte] = static_cast<std::uint8_t>(value >> (8U * byte));
    }
    return kernel.WriteObject(ObjectAddress{index, sub}, data);
}

std::uint32_t Rig::Read(const std::uint16_t index, const std::uint8_t sub)
{
    const ObjectReading reading = kernel.ReadObject(ObjectAddress{index, sub});
    EXPECT_EQ(reading.abort, AbortCode::kNone);
    std::uint32_t value = 0U;
    for (std::uint32_t byte = 0U; byte < std::min<std::uint32_t>(reading.data.size_bytes, 4U); ++byte)
    {
        value |= static_cast<std::uint32_t>(reading.data.bytes[byte]) << (8U * byte);
    }
    return value;
}

void Rig::Configure()
{
    ASSERT_EQ(kernel.Start(config, flow_callback, handshake), StartResult::kStarted);
    if (has_gfc)
    {
        ASSERT_EQ(Write(0x1300U, 0U, 1U, 1U), AbortCode::kNone);
    }
    const auto map = [this](std::uint16_t mapping, std::uint32_t normal, std::uint32_t inverse)
    {
        ASSERT_EQ(Write(mapping, 1U, normal, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(mapping, 2U, inverse, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(mapping, 0U, 2U, 1U), AbortCode::kNone);
    };
    map(0x1381U, 0x22000110U, 0x23000110U);
    ASSERT_EQ(Write(0x1301U, 2U, 50U, 2U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 5U, 0x101U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 6U, 0x102U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1301U, 1U, 2U, 1U), AbortCode::kNone);
    map(0x1383U, 0x20000110U, 0x21000110U);
    ASSERT_EQ(Write(0x1303U, 5U, 0x103U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1303U, 6U, 0x104U, 4U), AbortCode::kNone);
    ASSERT_EQ(Write(0x1303U, 1U, 1U, 1U), AbortCode::kNone);
    for (const std::uint8_t number : std::initializer_list<std::uint8_t>{1, 3, 4})
    {
        const SignReply reply = kernel.Sign(CommunicationIndex{static_cast<std::uint16_t>(0x1300U + number)});
        ASSERT_EQ(reply.result, Result::kSuccessful);
        ASSERT_EQ(Write(0x13FFU, number, reply.signature, 2U), AbortCode::kNone);
    }
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kPreOperational);
}

void Rig::Operate()
{
    Configure();
    kernel.SetNmtState(NmtState::kOperational);
    Cycle();
}

void Rig::Cycle(const SrdoMask acknowledge)
{
    now_us += 1000U - (now_us % 1000U);
    kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us}}, acknowledge, acknowledge});
}

void Rig::Cycles(const std::uint32_t count)
{
    for (std::uint32_t cycle = 0U; cycle < count; ++cycle)
    {
        Cycle();
    }
}

void Rig::Receive(const std::uint32_t identifier, const std::initializer_list<std::uint8_t> bytes,
                  const std::uint32_t after_us)
{
    now_us += after_us;
    StampedFrame frame{};
    frame.frame.identifier = identifier;
    frame.frame.kind = FrameKind::kData;
    frame.frame.port = CanPortId::kFirst;
    for (const std::uint8_t byte : bytes)
    {
        frame.frame.data[frame.frame.length_bytes] = byte;
        ++frame.frame.length_bytes;
    }
    frame.stamp = InstantPair{{now_us}, {now_us}};
    kernel.OnFrame(frame);
}

void Rig::ReceivePair()
{
    Receive(0x101U, {0x12U, 0x34U}, 100U);
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
}

void Rig::ConfirmLast()
{
    ASSERT_FALSE(ports.sent.empty());
    now_us += 100U;
    const CanFrame last = ports.sent.back();
    kernel.OnConfirm(StampedFrame{last, InstantPair{{now_us}, {now_us}}});
}

std::uint64_t Rig::NormalOut() const
{
    return static_cast<std::uint64_t>(rx_normal[0]) | (static_cast<std::uint64_t>(rx_normal[1]) << 8U);
}

std::uint64_t Rig::InverseOut() const
{
    return static_cast<std::uint64_t>(rx_inverse[0]) | (static_cast<std::uint64_t>(rx_inverse[1]) << 8U);
}

SrdoMask Rig::Open()
{
    return output.gate.Open(Instant{now_us}, hal::GateLimit{1600U});
}

bool Rig::WatchdogAlive()
{
    watchdog.timer.Examine(Instant{now_us});
    return watchdog.timer.IsAlive();
}

std::vector<SrdoCause> Rig::CausesOf(const std::uint16_t index) const
{
    std::vector<SrdoCause> causes;
    for (const std::pair<std::uint16_t, SrdoCause>& error : application.errors)
    {
        if (error.first == index)
        {
            causes.push_back(error.second);
        }
    }
    return causes;
}

} // namespace counterpoint
