// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What each class of the skeleton answers before anybody wrote its body.
#include "board.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <type_traits>

namespace port_skeleton
{
namespace
{

using namespace counterpoint;

TEST(PortSkeletonParts, AreTheClassesThatAPortImplements)
{
    Verifies(req::SRS_HAL_033);
    EXPECT_TRUE((std::is_base_of_v<hal::CanPorts, decltype(Board::can)>));
    EXPECT_TRUE((std::is_base_of_v<hal::Clocks, decltype(Board::clocks)>));
    EXPECT_TRUE((std::is_base_of_v<hal::SafetyOutput, decltype(Board::output)>));
    EXPECT_TRUE((std::is_base_of_v<hal::OutputCutoff, decltype(Board::output)>));
    EXPECT_TRUE((std::is_base_of_v<hal::Watchdog, decltype(Board::watchdog)>));
    EXPECT_TRUE((std::is_base_of_v<hal::MemoryProtection, decltype(Board::protection)>));
    EXPECT_TRUE((std::is_base_of_v<hal::InterruptLock, decltype(Board::lock)>));
    EXPECT_TRUE((std::is_base_of_v<hal::ParameterMemory, decltype(Board::parameters)>));
    EXPECT_TRUE((std::is_base_of_v<hal::CrossLink, decltype(Board::link)>));
}

TEST(PortSkeletonParts, GuaranteeNothingAndRefuseEachFrame)
{
    Verifies(req::SRS_HAL_033);
    Board board;
    const hal::CanGuarantees guarantees = board.can.Guarantees();
    EXPECT_EQ(guarantees.bus_order, hal::Guarantee::kAbsent);
    EXPECT_EQ(guarantees.stamps, hal::Guarantee::kAbsent);
    EXPECT_EQ(guarantees.confirmations, hal::Guarantee::kAbsent);
    // Given frames that may be sent, on both controllers, then none is taken, received or confirmed
    for (const CanPortId port : {CanPortId::kFirst, CanPortId::kSecond})
    {
        const CanFrame frame{0x101U, FrameKind::kData, port, 1U, {1U}};
        EXPECT_EQ(board.can.Transmit(frame), hal::TransmitStatus::kRefused);
        EXPECT_EQ(board.can.Next().kind, EventKind::kNothing);
    }
    // nor by the link to another CPU
    hal::LinkFrame message{};
    message.length = 1U;
    EXPECT_EQ(board.link.Send(message), hal::LinkStatus::kNothing);
    EXPECT_EQ(board.link.Receive(message), hal::LinkStatus::kNothing);
}

TEST(PortSkeletonParts, TellNoTimeAndAskNothing)
{
    Verifies(req::SRS_HAL_033);
    Board board;
    for (int time = 0; time < 3; ++time)
    {
        EXPECT_EQ(board.clocks.Now().a.us, 0U);
        EXPECT_EQ(board.clocks.Now().b.us, 0U);
        EXPECT_EQ(board.watchdog.Question().value, 0U);
        board.watchdog.Answer(hal::WatchdogAnswer{0x5EC0'DE27U * 0x0100'0193U});
    }
}

// Three right permits for slots 0 and 2, whose mask is 5; the high word of the mask is 0.
TEST(PortSkeletonParts, OpenNoOutput)
{
    Verifies(req::SRS_HAL_033);
    Board board;
    board.output.Drive(hal::PermitSet{});
    for (int cycle = 0; cycle < 3; ++cycle)
    {
        const std::uint32_t challenge = board.output.Challenge();
        const std::uint32_t sum = challenge + 5U;
        board.output.Drive(
            hal::PermitSet{{5U, sum * 0x9E37'79B1U}, {5U, sum * 0x85EB'CA77U}, {5U, sum * 0xC2B2'AE3DU}});
        // Then the gate says that it is interrupted: nobody armed it
        EXPECT_EQ(challenge, 0U);
    }
    board.output.CutOff();
    EXPECT_EQ(board.output.Challenge(), 0U);
}

TEST(PortSkeletonParts, ProtectAndKeepNothing)
{
    Verifies(req::SRS_HAL_033);
    Board board;
    alignas(64) const std::array<std::uint8_t, 64> place{};
    EXPECT_EQ(board.protection.Protect(hal::MemoryRegion{place.data(), 64U, hal::MemoryOwner::kChannelA}),
              hal::ProtectStatus::kAbsent);
    EXPECT_EQ(board.parameters.BankBytes(), 0U);
    EXPECT_EQ(board.parameters.Status(), hal::MemoryStatus::kFailed);
    // Given what is programmed all the same, then it is not read
    const std::array<std::uint8_t, 8> written{1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U};
    const hal::MemorySection section{hal::MemoryBank::kFirst, 0U, 8U};
    board.parameters.Program(section, written.data());
    std::array<std::uint8_t, 8> read{};
    EXPECT_FALSE(board.parameters.Read(section, read.data()));
    EXPECT_EQ(read, (std::array<std::uint8_t, 8>{}));
}

} // namespace
} // namespace port_skeleton
