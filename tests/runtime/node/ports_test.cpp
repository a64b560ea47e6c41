// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/ports.hpp"
#include "tests/runtime/node/troubled_bus.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <memory>

// The controllers of a node: by which connection a frame leaves, and what becomes of it.
namespace counterpoint::tools::test
{
namespace
{
CanFrame FrameWith(const std::uint32_t identifier, const CanPortId port = CanPortId::kFirst)
{
    CanFrame frame{};
    frame.identifier = identifier;
    frame.kind = FrameKind::kData;
    frame.port = port;
    frame.length_bytes = 1U;
    return frame;
}

struct Ports
{
    explicit Ports(const bool has_second = false, const host::BusState state = host::BusState::kActive)
    {
        const auto made = [state]
        {
            return std::make_unique<TroubledBus>(
                [state]
                {
                    host::BusHealth health;
                    health.state = state;
                    return health;
                });
        };
        auto of_safety = made();
        auto of_services = made();
        auto of_inverse = has_second ? made() : nullptr;
        safety = of_safety.get();
        services = of_services.get();
        inverse = of_inverse.get();
        ports =
            std::make_unique<runtime::NodePorts>(std::move(of_safety), std::move(of_services), std::move(of_inverse));
    }

    TroubledBus* safety{nullptr};
    TroubledBus* services{nullptr};
    TroubledBus* inverse{nullptr};
    std::unique_ptr<runtime::NodePorts> ports{};
};

TEST(NodePortsTest, EachFrameLeavesByItsConnection)
{
    Verifies(req::SRS_NODE_014);
    Ports one;
    EXPECT_EQ(one.ports->Transmit(FrameWith(0x101U)), hal::TransmitStatus::kAccepted);
    EXPECT_EQ(one.ports->Transmit(FrameWith(0x181U)), hal::TransmitStatus::kAccepted);
    EXPECT_EQ(one.safety->sent.size(), 1U);
    EXPECT_EQ(one.services->sent.size(), 1U);
    // Nobody is the second controller
    EXPECT_EQ(one.ports->Transmit(FrameWith(0x102U, CanPortId::kSecond)), hal::TransmitStatus::kRefused);
    Ports two(true);
    EXPECT_EQ(two.ports->Transmit(FrameWith(0x102U, CanPortId::kSecond)), hal::TransmitStatus::kAccepted);
    EXPECT_EQ(two.inverse->sent.size(), 1U);
    EXPECT_TRUE(two.safety->sent.empty());
}

TEST(NodePortsTest, WhatABusDoesNotTakeIsToldAsTheKernelHasIt)
{
    Verifies(req::SRS_NODE_001);
    const auto status = [](const host::SendResult answer)
    {
        Ports one;
        one.services->answer = answer;
        return one.ports->Transmit(FrameWith(0x181U));
    };
    EXPECT_EQ(status(host::SendResult::kSent), hal::TransmitStatus::kAccepted);
    EXPECT_EQ(status(host::SendResult::kBusOff), hal::TransmitStatus::kBusOff);
    EXPECT_EQ(status(host::SendResult::kQueueFull), hal::TransmitStatus::kQueueFull);
    EXPECT_EQ(status(host::SendResult::kDown), hal::TransmitStatus::kQueueFull);
    EXPECT_EQ(status(host::SendResult::kRefused), hal::TransmitStatus::kRefused);
    EXPECT_EQ(status(host::SendResult::kInvalid), hal::TransmitStatus::kRefused);
}

TEST(NodePortsTest, AtItsEndANodeSendsNoSrdoAnyMore)
{
    Verifies(req::SRS_NODE_005);
    Ports one;
    one.ports->EndProduction();
    EXPECT_EQ(one.ports->Transmit(FrameWith(0x101U)), hal::TransmitStatus::kRefused);
    EXPECT_EQ(one.ports->Transmit(FrameWith(0x181U)), hal::TransmitStatus::kAccepted);
    EXPECT_TRUE(one.safety->sent.empty());
}

TEST(NodePortsTest, AStateThatNoBusTellsIsNone)
{
    Verifies(req::SRS_NODE_020);
    EXPECT_EQ(Ports(false, host::BusState::kWarning).ports->State(), host::BusState::kWarning);
    EXPECT_EQ(Ports(true, host::BusState::kInvalid).ports->State(), host::BusState::kInvalid);
}
} // namespace
} // namespace counterpoint::tools::test
