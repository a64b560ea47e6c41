// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the kernel says, in its bytes; the kernel itself is used by verification/vm.
#include "hal/host/live/link.hpp"

#include "hal/host/live/error.hpp"
#include "hal/host/live/socketcan_bus.hpp"
#include "tests/hal/host/live_rig.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>
#include <linux/can/error.h>

namespace counterpoint::host
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

/// RTM_NEWLINK (16) of interface 5, up, running, with its carrier: head (16), link (16), then IFLA_LINKINFO (18) with
/// kind "can" (1) and data (2) with state (4), restart-ms (6) and error counters (8).
Bytes CanLink(const std::uint8_t state)
{
    return {92U, 0U, 0U,  0U,    16U,   0U,  0U,  0U, 0U,    0U,    0U, 0U, 0U, 0U, 0U, 0U, // nlmsghdr
            0U,  0U, 0U,  0U,    5U,    0U,  0U,  0U, 0x41U, 0x00U, 1U, 0U, 0U, 0U, 0U, 0U, // ifinfomsg, flags 1'0041h
            60U, 0U, 18U, 0U,                                                               // IFLA_LINKINFO
            8U,  0U, 1U,  0U,    'c',   'a', 'n', 0U,                                       // kind
            28U, 0U, 2U,  0x80U,                                                            // data, marked as nested
            8U,  0U, 4U,  0U,    state, 0U,  0U,  0U,                                       // state
            8U,  0U, 6U,  0U,    100U,  0U,  0U,  0U,                                       // restart-ms
            8U,  0U, 8U,  0U,    44U,   1U,  7U,  0U, // 300 transmit, 7 receive errors
            20U, 0U, 3U,  0U,    0U,    0U,  0U,  0U, 0U,    0U,    0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U};
}

TEST(LiveLinkTest, ReadsTheStateOfAController)
{
    Verifies(req::SRS_LIVE_022);
    const std::vector<std::pair<std::uint8_t, BusState>> states{{0U, BusState::kActive},  {1U, BusState::kWarning},
                                                                {2U, BusState::kPassive}, {3U, BusState::kBusOff},
                                                                {4U, BusState::kDown},    {5U, BusState::kDown}};
    for (const auto& [code, state] : states)
    {
        const Bytes bytes = CanLink(code);
        const std::optional<LinkState> link = ReadLinkMessage(bytes.data(), bytes.size());
        ASSERT_TRUE(link);
        EXPECT_EQ(link->index, 5);
        EXPECT_TRUE(link->is_up);
        EXPECT_TRUE(link->is_carrying);
        EXPECT_EQ(link->controller, state);
        EXPECT_EQ(link->transmit_errors, 255U);
        EXPECT_EQ(link->receive_errors, 7U);
        EXPECT_EQ(link->restart_ms, 100U);
    }
}

// Given a virtual interface (kind vcan), and one that is down, then there is no controller, and nothing is carried.
TEST(LiveLinkTest, ReadsAVirtualInterface)
{
    Verifies(req::SRS_LIVE_022);
    const Bytes bytes{44U, 0U, 0U,  0U, 16U, 0U, 0U, 0U, 0U,  0U,  0U,  0U, 0U, 0U, 0U, 0U, //
                      0U,  0U, 0U,  0U, 9U,  0U, 0U, 0U, 0U,  0U,  0U,  0U, 0U, 0U, 0U, 0U, //
                      12U, 0U, 18U, 0U, 8U,  0U, 1U, 0U, 'v', 'c', 'a', 0U};
    const std::optional<LinkState> link = ReadLinkMessage(bytes.data(), bytes.size());
    ASSERT_TRUE(link);
    EXPECT_EQ(link->index, 9);
    EXPECT_FALSE(link->is_up);
    EXPECT_FALSE(link->is_carrying);
    EXPECT_FALSE(link->controller);
}

// Given every shorter piece of a message, then it is either no message or one without what is cut off; never more.
TEST(LiveLinkTest, TakesNothingFromBehindItsEnd)
{
    Verifies(req::SRS_LIVE_022);
    const Bytes bytes = CanLink(3U);
    for (std::size_t count = 0U; count < bytes.size(); ++count)
    {
        const Bytes piece(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
        EXPECT_FALSE(ReadLinkMessage(piece.data(), piece.size())) << count;
    }
    Bytes wrong = bytes;
    wrong[36] = 2U; // An attribute shorter than its own head.
    EXPECT_FALSE(ReadLinkMessage(wrong.data(), wrong.size())->controller);
    wrong = bytes;
    wrong[4] = 17U; // RTM_DELLINK.
    EXPECT_FALSE(ReadLinkMessage(wrong.data(), wrong.size()));
}

TEST(LiveLinkTest, TakesWhatAControllerDoesNotTellForUnknown)
{
    Verifies(req::SRS_LIVE_022);
    const auto read = [](const Bytes& bytes) { return ReadLinkMessage(bytes.data(), bytes.size()); };
    Bytes bytes = CanLink(3U);
    // Given a state of another type, then there is none; counters and restart stay
    bytes[50] = 44U;
    EXPECT_FALSE(read(bytes)->controller);
    EXPECT_EQ(read(bytes)->receive_errors, 7U);
    EXPECT_EQ(read(bytes)->restart_ms, 100U);
    // Counters of another type
    bytes = CanLink(3U);
    bytes[66] = 44U;
    EXPECT_EQ(read(bytes)->controller, BusState::kBusOff);
    EXPECT_EQ(read(bytes)->receive_errors, 0U);
    // A state with too few bytes for one, a restart that would be longer than all of it
    bytes = CanLink(3U);
    bytes[48] = 6U;
    EXPECT_FALSE(read(bytes)->controller);
    bytes = CanLink(3U);
    bytes[56] = 200U;
    EXPECT_EQ(read(bytes)->restart_ms, 0U);
    EXPECT_EQ(read(bytes)->controller, BusState::kBusOff);
    // A message that says that it is shorter than what each one has
    bytes = CanLink(3U);
    bytes[0] = 31U;
    EXPECT_FALSE(read(bytes));
    // An interface that does not run, or has no carrier
    bytes = CanLink(0U);
    bytes[24] = 0x01U;
    EXPECT_TRUE(read(bytes)->is_up);
    EXPECT_FALSE(read(bytes)->is_carrying);
    bytes = CanLink(0U);
    bytes[26] = 0U;
    EXPECT_FALSE(read(bytes)->is_carrying);
}

TEST(LiveLinkTest, WritesTheOrders)
{
    Verifies(req::SRS_LIVE_022);
    const Bytes restart{56U, 0U, 0U,  0U, 16U, 0U, 5U, 0U, 0U,  0U,  0U,  0U, 0U, 0U, 0U, 0U, // request, acknowledge
                        0U,  0U, 0U,  0U, 5U,  0U, 0U, 0U, 0U,  0U,  0U,  0U, 0U, 0U, 0U, 0U, //
                        24U, 0U, 18U, 0U, 7U,  0U, 1U, 0U, 'c', 'a', 'n', 0U,                 //
                        12U, 0U, 2U,  0U, 8U,  0U, 7U, 0U, 1U,  0U,  0U,  0U};
    EXPECT_EQ(RestartLinkMessage(5), restart);
    const Bytes up{32U, 0U, 0U, 0U, 16U, 0U, 5U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U,
                   0U,  0U, 0U, 0U, 6U,  0U, 0U, 0U, 1U, 0U, 0U, 0U, 1U, 0U, 0U, 0U};
    EXPECT_EQ(SwitchLinkMessage(6, true), up);
    Bytes down = up;
    down[24] = 0U;
    EXPECT_EQ(SwitchLinkMessage(6, false), down);
    EXPECT_EQ(AskLinkMessage(6)[4], 18U); // RTM_GETLINK
}

LiveFrame ErrorFrame(const std::uint32_t classes, const std::initializer_list<std::uint8_t> data)
{
    LiveFrame frame = Live(classes, data);
    frame.error = true;
    return frame;
}

TEST(LiveErrorTest, ReadsStateAndCounters)
{
    Verifies(req::SRS_LIVE_021);
    const ErrorNews passive =
        ReadErrorFrame(ErrorFrame(CAN_ERR_CRTL | CAN_ERR_CNT, {0U, CAN_ERR_CRTL_RX_PASSIVE, 0U, 0U, 0U, 0U, 9U, 135U}));
    EXPECT_EQ(passive.state, BusState::kPassive);
    EXPECT_TRUE(passive.has_counters);
    EXPECT_EQ(passive.transmit_errors, 9U);
    EXPECT_EQ(passive.receive_errors, 135U);
    EXPECT_EQ(ReadErrorFrame(ErrorFrame(CAN_ERR_CRTL, {0U, CAN_ERR_CRTL_TX_WARNING})).state, BusState::kWarning);
    EXPECT_EQ(ReadErrorFrame(ErrorFrame(CAN_ERR_CRTL, {0U, CAN_ERR_CRTL_ACTIVE})).state, BusState::kActive);
    EXPECT_EQ(ReadErrorFrame(ErrorFrame(CAN_ERR_CRTL, {0U, CAN_ERR_CRTL_RX_OVERFLOW})).state, std::nullopt);
    EXPECT_EQ(ReadErrorFrame(ErrorFrame(CAN_ERR_PROT, {0U, 0U, CAN_ERR_PROT_ACTIVE})).state, BusState::kActive);
    EXPECT_EQ(ReadErrorFrame(ErrorFrame(CAN_ERR_PROT, {0U, 0U, CAN_ERR_PROT_STUFF})).state, std::nullopt);
    EXPECT_EQ(ReadErrorFrame(ErrorFrame(CAN_ERR_BUSOFF, {})).state, BusState::kBusOff);
    EXPECT_TRUE(ReadErrorFrame(ErrorFrame(CAN_ERR_BUSOFF, {})).is_bus_off);
    EXPECT_TRUE(ReadErrorFrame(ErrorFrame(CAN_ERR_RESTARTED, {})).is_restart);
    EXPECT_EQ(ReadErrorFrame(ErrorFrame(CAN_ERR_RESTARTED, {})).state, BusState::kActive);
    EXPECT_EQ(ReadErrorFrame(Live(CAN_ERR_BUSOFF, {})).state, std::nullopt);
}

TEST(LiveErrorTest, TellsInWords)
{
    Verifies(req::SRS_LIVE_021);
    EXPECT_EQ(DescribeErrorFrame(ErrorFrame(CAN_ERR_BUSOFF, {})), "bus-off");
    EXPECT_EQ(DescribeErrorFrame(
                  ErrorFrame(CAN_ERR_CRTL | CAN_ERR_CNT, {0U, CAN_ERR_CRTL_TX_PASSIVE, 0U, 0U, 0U, 0U, 130U, 0U})),
              "error passive (transmitter); 130 transmit, 0 receive errors");
    EXPECT_EQ(DescribeErrorFrame(ErrorFrame(CAN_ERR_PROT | CAN_ERR_BUSERROR | CAN_ERR_ACK,
                                            {0U, 0U, CAN_ERR_PROT_STUFF | CAN_ERR_PROT_TX})),
              "no acknowledgement, bus error, stuff error, on transmission");
    EXPECT_EQ(DescribeErrorFrame(ErrorFrame(0U, {})), "error of no known class");
}

TEST(SocketCanFrameTest, IsTheKernelsForm)
{
    Verifies(req::SRS_LIVE_020);
    LiveFrame extended = Live(0x1234'5678U, {1U, 2U});
    extended.extended = true;
    const SocketCanFrame raw = ToSocketCan(extended);
    EXPECT_EQ(raw.bytes, 16U);
    EXPECT_EQ(raw.frame.can_id, 0x9234'5678U);
    EXPECT_EQ(raw.frame.len, 2U);
    LiveFrame back;
    ASSERT_TRUE(FromSocketCan(raw.frame, raw.bytes, back));
    EXPECT_TRUE(back.extended);
    EXPECT_EQ(back.identifier, 0x1234'5678U);
    EXPECT_EQ(back.data[1], 2U);
    LiveFrame remote = Live(0x701U, {});
    remote.remote = true;
    EXPECT_EQ(ToSocketCan(remote).frame.can_id, 0x4000'0701U);
    LiveFrame flexible = Live(1U, {});
    flexible.fd = true;
    flexible.length_bytes = 64U;
    EXPECT_EQ(ToSocketCan(flexible).bytes, 72U);
    canfd_frame error{};
    error.can_id = 0x2000'0040U;
    error.len = 8U;
    ASSERT_TRUE(FromSocketCan(error, 16U, back));
    EXPECT_TRUE(back.error && !back.extended && !back.remote);
    EXPECT_EQ(back.identifier, 0x40U);
    canfd_frame standard{};
    standard.can_id = 0x4000'0123U;
    standard.len = 3U;
    ASSERT_TRUE(FromSocketCan(standard, 16U, back));
    EXPECT_TRUE(back.remote && !back.extended && !back.fd);
    EXPECT_EQ(back.identifier, 0x123U);
    standard.len = 64U;
    ASSERT_TRUE(FromSocketCan(standard, 72U, back));
    EXPECT_TRUE(back.fd);
    error.len = 9U;
    EXPECT_FALSE(FromSocketCan(error, 16U, back));
    EXPECT_FALSE(FromSocketCan(error, 15U, back));
}

// Given an interface that is not there, or a kernel without SocketCAN, then opening says which.
TEST(SocketCanBusTest, SaysWhatItCannotOpen)
{
    Verifies(req::SRS_LIVE_020);
    const std::string problem = ProblemOf([] { static_cast<void>(OpenLiveBus("nocan9")); });
    const bool is_no_interface = problem == "bus 'nocan9': No such device, expected a CAN interface 'nocan9'";
    const bool is_no_socketcan = problem == "bus 'nocan9': Address family not supported by protocol, expected a kernel "
                                            "with SocketCAN (modules can and can_raw)";
    EXPECT_TRUE(is_no_interface || is_no_socketcan) << problem;
}

} // namespace
} // namespace counterpoint::host
