// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/cross_link.hpp"

#include "hal/host/udp_cross_link.hpp"
#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

hal::LinkFrame Frame(const std::uint8_t first)
{
    hal::LinkFrame frame{};
    frame.length = 3U;
    frame.bytes[0] = first;
    return frame;
}

class Wire : public ::testing::Test
{
  protected:
    int Received(WireEnd end)
    {
        hal::LinkFrame frame{};
        return (wire.End(end).Receive(frame) == hal::LinkStatus::kDone) ? frame.bytes[0] : -1;
    }
    HostWire wire{1U};
};

// Given a wire with a delay of 500 us, when a frame is sent at 100, then it is there at 600 and not before, once,
// unchanged.
TEST_F(Wire, CarriesAfterItsDelay)
{
    Verifies(req::SRS_LNK_020);
    Verifies(req::SRS_LNK_021);
    wire.Faults(WireEnd::kFirst).shortest_us = 500U;
    wire.Faults(WireEnd::kFirst).longest_us = 500U;
    wire.SetNow(100U);
    EXPECT_EQ(wire.End(WireEnd::kFirst).Send(Frame(7U)), hal::LinkStatus::kDone);
    wire.SetNow(599U);
    EXPECT_EQ(Received(WireEnd::kSecond), -1);
    wire.SetNow(700U);
    EXPECT_EQ(Received(WireEnd::kFirst), -1);
    EXPECT_EQ(Received(WireEnd::kSecond), 7);
    EXPECT_EQ(wire.ArrivedAt(WireEnd::kSecond), 600U);
    EXPECT_EQ(Received(WireEnd::kSecond), -1);
}

// Given frames of no or too great a length, then they are not sent.
TEST_F(Wire, RefusesImpossibleLengths)
{
    Verifies(req::SRS_LNK_020);
    hal::LinkFrame frame = Frame(1U);
    frame.length = 0U;
    EXPECT_EQ(wire.End(WireEnd::kFirst).Send(frame), hal::LinkStatus::kNothing);
    frame.length = 189U;
    EXPECT_EQ(wire.End(WireEnd::kFirst).Send(frame), hal::LinkStatus::kNothing);
    EXPECT_EQ(Received(WireEnd::kSecond), -1);
}

// Given frames of the least and the greatest length, then they come in the order in which they were sent, one at a
// time, unchanged to the last byte.
TEST_F(Wire, CarriesOneToOneHundredAndEightyEightBytesInTheirOrder)
{
    Verifies(req::SRS_LNK_020);
    hal::LinkFrame longest{};
    longest.length = 188U;
    for (std::uint8_t place = 0U; place < 188U; ++place)
    {
        longest.bytes[place] = static_cast<std::uint8_t>(255U - place);
    }
    hal::LinkFrame shortest{};
    shortest.length = 1U;
    shortest.bytes[0] = 7U;
    for (const hal::LinkFrame* const frame : {&longest, &shortest, &longest})
    {
        EXPECT_EQ(wire.End(WireEnd::kSecond).Send(*frame), hal::LinkStatus::kDone);
    }
    for (const hal::LinkFrame* const sent : {&longest, &shortest, &longest})
    {
        hal::LinkFrame frame{};
        ASSERT_EQ(wire.End(WireEnd::kFirst).Receive(frame), hal::LinkStatus::kDone);
        ASSERT_EQ(frame.length, sent->length);
        EXPECT_TRUE(std::equal(&frame.bytes[0], &frame.bytes[frame.length], &sent->bytes[0]));
    }
    EXPECT_EQ(Received(WireEnd::kFirst), -1);
}

// Given a quarter of a million in a million, then of 10 000 frames about a quarter is lost, comes twice, or is changed;
// without frequencies, none.
TEST_F(Wire, LosesRepeatsAndFlipsAsOftenAsItIsTold)
{
    Verifies(req::SRS_LNK_021);
    const auto of = [](const WireFaults& faults)
    {
        HostWire own{5U};
        own.Faults(WireEnd::kFirst) = faults;
        std::array<int, 2> counts{}; // Frames that came, and those of them that were changed.
        for (int number = 0; number < 10000; ++number)
        {
            EXPECT_EQ(own.End(WireEnd::kFirst).Send(Frame(0U)), hal::LinkStatus::kDone);
            hal::LinkFrame frame{};
            while (own.End(WireEnd::kSecond).Receive(frame) == hal::LinkStatus::kDone)
            {
                ++counts[0];
                counts[1] += ((frame.bytes[0] | frame.bytes[1] | frame.bytes[2]) != 0) ? 1 : 0;
            }
        }
        return counts;
    };
    WireFaults faults{};
    EXPECT_EQ(of(faults), (std::array<int, 2>{10000, 0}));
    faults.loss_ppm = 250'000U;
    faults.most_lost_in_a_row = 10000U;
    EXPECT_GT(of(faults)[0], 7200);
    EXPECT_LT(of(faults)[0], 7800);
    faults = WireFaults{};
    faults.repeat_ppm = 250'000U;
    EXPECT_GT(of(faults)[0], 12200);
    EXPECT_LT(of(faults)[0], 12800);
    faults = WireFaults{};
    faults.flip_ppm = 250'000U;
    EXPECT_EQ(of(faults)[0], 10000);
    EXPECT_GT(of(faults)[1], 2200);
    EXPECT_LT(of(faults)[1], 2800);
}

TEST_F(Wire, IsCutInEachDirectionForItself)
{
    Verifies(req::SRS_LNK_021);
    wire.Faults(WireEnd::kSecond).is_cut = true;
    EXPECT_EQ(wire.End(WireEnd::kSecond).Send(Frame(1U)), hal::LinkStatus::kDone);
    EXPECT_EQ(wire.End(WireEnd::kFirst).Send(Frame(2U)), hal::LinkStatus::kDone);
    EXPECT_EQ(Received(WireEnd::kFirst), -1);
    EXPECT_EQ(Received(WireEnd::kSecond), 2);
}

// Given a million in a million, then every frame is lost (but the third after two in a row), comes twice, or is
// changed.
TEST_F(Wire, LosesRepeatsAndFlips)
{
    Verifies(req::SRS_LNK_021);
    wire.Faults(WireEnd::kFirst).loss_ppm = 1'000'000U;
    wire.Faults(WireEnd::kFirst).most_lost_in_a_row = 2U;
    for (std::uint8_t number = 1U; number <= 6U; ++number)
    {
        EXPECT_EQ(wire.End(WireEnd::kFirst).Send(Frame(number)), hal::LinkStatus::kDone);
    }
    EXPECT_EQ(Received(WireEnd::kSecond), 3);
    EXPECT_EQ(Received(WireEnd::kSecond), 6);
    EXPECT_EQ(Received(WireEnd::kSecond), -1);
    wire.Faults(WireEnd::kSecond).repeat_ppm = 1'000'000U;
    EXPECT_EQ(wire.End(WireEnd::kSecond).Send(Frame(9U)), hal::LinkStatus::kDone);
    EXPECT_EQ(Received(WireEnd::kFirst), 9);
    EXPECT_EQ(Received(WireEnd::kFirst), 9);
    wire.Faults(WireEnd::kSecond) = WireFaults{};
    wire.Faults(WireEnd::kSecond).flip_ppm = 1'000'000U;
    EXPECT_EQ(wire.End(WireEnd::kSecond).Send(Frame(0U)), hal::LinkStatus::kDone);
    hal::LinkFrame frame{};
    EXPECT_EQ(wire.End(WireEnd::kFirst).Receive(frame), hal::LinkStatus::kDone);
    EXPECT_NE(frame.bytes[0] | frame.bytes[1] | frame.bytes[2], 0);
}

// Given delays of 0 to 100 us, then some of 100 frames overtake others; cut, nothing gets in; the same seed does the
// same.
TEST_F(Wire, OvertakesAndIsCut)
{
    Verifies(req::SRS_LNK_021);
    HostWire twin{1U};
    int overtaken = 0;
    int last = -1;
    for (HostWire* const each : {&wire, &twin})
    {
        each->Faults(WireEnd::kFirst).longest_us = 100U;
        for (std::uint8_t number = 0U; number < 100U; ++number)
        {
            each->SetNow(number);
            EXPECT_EQ(each->End(WireEnd::kFirst).Send(Frame(number)), hal::LinkStatus::kDone);
        }
        each->SetNow(1000U);
    }
    for (int count = 0; count < 100; ++count)
    {
        const int got = Received(WireEnd::kSecond);
        hal::LinkFrame frame{};
        EXPECT_EQ(twin.End(WireEnd::kSecond).Receive(frame), hal::LinkStatus::kDone);
        EXPECT_EQ(frame.bytes[0], got);
        overtaken += (got < last) ? 1 : 0;
        last = got;
    }
    EXPECT_GT(overtaken, 0);
    wire.Faults(WireEnd::kFirst).is_cut = true;
    EXPECT_EQ(wire.End(WireEnd::kFirst).Send(Frame(1U)), hal::LinkStatus::kDone);
    wire.SetNow(2000U);
    EXPECT_EQ(Received(WireEnd::kSecond), -1);
}

// Given two ends on the loopback interface, then frames pass in both directions; a port that is taken is refused by
// number.
TEST(UdpWire, CarriesBetweenTwoProcesses)
{
    Verifies(req::SRS_LNK_022);
    const auto base = static_cast<std::uint16_t>(30000 + ((getpid() % 10000) * 2));
    UdpCrossLink first{UdpPorts{base, static_cast<std::uint16_t>(base + 1U)}};
    // When another process sends, and answers what it hears
    const pid_t other = ::fork();
    ASSERT_NE(other, -1);
    hal::LinkFrame frame{};
    hal::LinkStatus status = hal::LinkStatus::kNothing;
    const auto wait = [&frame, &status](UdpCrossLink& link)
    {
        for (int attempt = 0; (attempt < 10'000) && (status != hal::LinkStatus::kDone); ++attempt)
        {
            status = link.Receive(frame);
            usleep(1000);
        }
    };
    if (other == 0)
    {
        UdpCrossLink second{UdpPorts{static_cast<std::uint16_t>(base + 1U), base}};
        static_cast<void>(second.Send(Frame(9U)));
        wait(second);
        ::_exit((frame.bytes[0] == 5U) ? 0 : 1);
    }
    wait(first);
    EXPECT_EQ(frame.bytes[0], 9U);
    EXPECT_EQ(first.Send(Frame(5U)), hal::LinkStatus::kDone);
    // Then each has what the other one sent
    int end = -1;
    ASSERT_EQ(::waitpid(other, &end, 0), other);
    EXPECT_EQ(end, 0);
}

TEST(UdpWire, CarriesBetweenPorts)
{
    Verifies(req::SRS_LNK_022);
    const auto base = static_cast<std::uint16_t>(30000 + ((getpid() % 10000) * 2));
    UdpCrossLink first{UdpPorts{base, static_cast<std::uint16_t>(base + 1U)}};
    UdpCrossLink second{UdpPorts{static_cast<std::uint16_t>(base + 1U), base}};
    hal::LinkFrame frame{};
    EXPECT_EQ(second.Receive(frame), hal::LinkStatus::kNothing);
    EXPECT_EQ(first.Send(Frame(5U)), hal::LinkStatus::kDone);
    hal::LinkStatus status = hal::LinkStatus::kNothing;
    for (int attempt = 0; (attempt < 100'000) && (status != hal::LinkStatus::kDone); ++attempt)
    {
        status = second.Receive(frame);
        usleep(1000);
    }
    ASSERT_EQ(status, hal::LinkStatus::kDone);
    EXPECT_EQ(frame.length, 3U);
    EXPECT_EQ(frame.bytes[0], 5U);
    frame.length = 0U;
    EXPECT_EQ(second.Send(frame), hal::LinkStatus::kNothing);
    try
    {
        const UdpCrossLink third{UdpPorts{base, base}};
        FAIL() << "the port is taken";
    }
    catch (const std::runtime_error& error)
    {
        EXPECT_NE(std::string{error.what()}.find("UDP port " + std::to_string(base)), std::string::npos);
    }
}

} // namespace
} // namespace counterpoint::host
