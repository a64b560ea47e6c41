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

/// One connection with that health, and what it says of the last that was no frame.
std::unique_ptr<TroubledBus> BusWith(const host::BusHealth& health, const std::string& problem = "")
{
    auto bus = std::make_unique<TroubledBus>([health] { return health; });
    bus->problem = problem;
    return bus;
}

// Given two controllers, then an absence of whichever connection is taken once, and the last one's is what it was.
TEST(NodePortsTest, AnAbsenceOfEachConnectionIsTakenOnce)
{
    Verifies(req::SRS_NODE_580);
    host::BusHealth quiet;
    host::BusHealth off;
    off.absences = 2U;
    off.absence = host::BusState::kBusOff;
    host::BusHealth down;
    down.absences = 1U;
    down.absence = host::BusState::kDown;
    runtime::NodePorts one(BusWith(quiet), BusWith(off));
    EXPECT_EQ(one.TakeAbsence(), host::BusState::kBusOff);
    EXPECT_EQ(one.TakeAbsence(), host::BusState::kInvalid);
    runtime::NodePorts two(BusWith(off), BusWith(quiet), BusWith(down));
    EXPECT_EQ(two.TakeAbsence(), host::BusState::kDown);
    EXPECT_EQ(two.TakeAbsence(), host::BusState::kInvalid);
}

TEST(NodePortsTest, WhatIsNoFrameCountsOnEachConnection)
{
    Verifies(req::SRS_NODE_581);
    host::BusHealth three;
    three.malformed = 3U;
    runtime::NodePorts one(BusWith(three), BusWith(three, "first"));
    EXPECT_EQ(one.Malformed(), 6U);
    EXPECT_EQ(one.Problem(), "first");
    runtime::NodePorts two(BusWith(three), BusWith(three), BusWith(three, "second"));
    EXPECT_EQ(two.Malformed(), 9U);
    EXPECT_EQ(two.Problem(), "second");
    EXPECT_EQ(runtime::NodePorts(BusWith(three, "a"), BusWith(three, "b")).Problem(), "a");
    EXPECT_EQ(runtime::NodePorts(BusWith(three), BusWith(three)).Problem(), "");
}

TEST(NodePortsTest, AStateThatNoBusTellsIsNone)
{
    Verifies(req::SRS_NODE_020);
    EXPECT_EQ(Ports(false, host::BusState::kWarning).ports->State(), host::BusState::kWarning);
    EXPECT_EQ(Ports(true, host::BusState::kInvalid).ports->State(), host::BusState::kInvalid);
}
} // namespace
} // namespace counterpoint::tools::test
