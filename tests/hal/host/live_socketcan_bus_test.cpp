// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The bus of a CAN interface, with a model of the kernel that does what a kernel with CAN does; the kernel itself is
// used by verification/vm.
#include "hal/host/live/error.hpp"
#include "hal/host/live/socketcan_bus.hpp"
#include "tests/hal/host/fake_can_kernel.hpp"
#include "tests/hal/host/live_rig.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/verifies.hpp"

#include <cerrno>
#include <gtest/gtest.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>

namespace counterpoint::host
{
namespace
{

using Lines = std::vector<std::string>;

constexpr std::uint8_t kOff = 3U; ///< CAN_STATE_BUS_OFF.

class SocketCanBus : public ::testing::Test
{
  protected:
    SocketCanBus()
    {
        can0().state = std::uint8_t{0U};
    }
    FakeCanKernel::Interface& can0()
    {
        return kernel.interfaces["can0"];
    }
    [[nodiscard]] std::unique_ptr<LiveBus> Open(const LiveOptions& options = {})
    {
        return OpenLiveBus("can0", options);
    }
    [[nodiscard]] std::string Problem(const LiveOptions& options = {})
    {
        return ProblemOf([&options] { static_cast<void>(OpenLiveBus("can0", options)); });
    }
    /// Changes the interface, and the kernel tells it.
    void Change(LiveBus& bus, const std::function<void(FakeCanKernel::Interface&)>& change)
    {
        change(can0());
        kernel.TellNews();
        Serve(bus);
    }
    /// As an owner does when the descriptor is readable.
    static void Serve(LiveBus& bus)
    {
        LiveFrame frame;
        while (bus.Receive(frame))
        {
        }
    }
    /// Serves the bus until the condition holds, at most minutes.
    static bool Until(LiveBus& bus, const std::function<bool()>& holds)
    {
        const std::uint64_t start_ns = LiveNow();
        while (!holds() && (LiveNow() - start_ns < 300'000'000'000U))
        {
            pollfd wait{bus.Descriptor(), POLLIN, 0};
            static_cast<void>(::poll(&wait, 1U, 100));
            Serve(bus);
        }
        return holds();
    }
    /// Identifiers of the frames that the interface took.
    [[nodiscard]] std::vector<std::uint32_t> Sent() const
    {
        std::vector<std::uint32_t> identifiers;
        for (const canfd_frame& frame : kernel.sent)
        {
            identifiers.push_back(frame.can_id);
        }
        return identifiers;
    }

    FakeCanKernel kernel;
};

TEST_F(SocketCanBus, SaysWhyItCannotBeOpened)
{
    Verifies(req::SRS_LIVE_020);
    // Given a kernel without CAN
    kernel.socket_failure = EAFNOSUPPORT;
    EXPECT_EQ(Problem(),
              "bus 'can0': Address family not supported by protocol, expected a kernel with SocketCAN (modules can "
              "and can_raw)");
    kernel.socket_failure = 0;
    // No such interface
    EXPECT_EQ(ProblemOf([] { static_cast<void>(OpenLiveBus("can1")); }),
              "bus 'can1': No such device, expected a CAN interface 'can1'");
    // One that is removed between the look at its name and the use of it
    {
        const FailingCall bind{SystemCall::kBind, ENODEV, 1};
        EXPECT_EQ(Problem(), "bus 'can0': No such device, expected a CAN interface 'can0'");
    }
    // Or a kernel that does not know what the socket needs
    for (const int option : {CAN_RAW_RECV_OWN_MSGS, CAN_RAW_FD_FRAMES, CAN_RAW_ERR_FILTER})
    {
        kernel.refused_option = option;
        EXPECT_EQ(Problem(),
                  "bus 'can0': Protocol not available, expected a raw socket with own frames and error frames");
    }
    kernel.refused_option = CAN_RAW_FILTER;
    EXPECT_EQ(Problem(), "bus 'can0': Protocol not available, expected at most 512 filters");
    kernel.refused_option = -1;
    EXPECT_EQ(Problem(), "");
}

TEST_F(SocketCanBus, GivesFiltersToTheKernelWithTheWidthCompared)
{
    Verifies(req::SRS_LIVE_014);
    LiveOptions options;
    options.filters = {{0x180U, 0x780U, false}, {0x1234'5678U, 0x1FFF'FFFFU, true}};
    const auto bus = Open(options);
    ASSERT_EQ(kernel.filters.size(), 2U);
    EXPECT_EQ(kernel.filters[0].can_id, 0x180U);
    EXPECT_EQ(kernel.filters[0].can_mask, 0x8000'0780U);
    EXPECT_EQ(kernel.filters[1].can_id, 0x9234'5678U);
    EXPECT_EQ(kernel.filters[1].can_mask, 0x9FFF'FFFFU);
    // Without any, everything passes
    const auto open = Open();
    ASSERT_EQ(kernel.filters.size(), 1U);
    EXPECT_EQ(kernel.filters[0].can_mask, 0U);
}

TEST_F(SocketCanBus, SendsAndGivesWhatComesAndWhatComesBack)
{
    Verifies(req::SRS_LIVE_003);
    Verifies(req::SRS_LIVE_025);
    const auto bus = Open();
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    ASSERT_EQ(bus->Send(Live(0x123U, {7U})), SendResult::kSent);
    ASSERT_EQ(Sent(), (std::vector<std::uint32_t>{0x123U}));
    EXPECT_EQ(kernel.sent[0].data[0], 7U);
    EXPECT_EQ(kernel.sent_bytes[0], 16U);
    kernel.Arrive(0x701U);
    kernel.Arrive(0x123U, true);
    LiveFrame frame;
    ASSERT_TRUE(bus->Receive(frame));
    EXPECT_EQ(frame.identifier, 0x701U);
    EXPECT_FALSE(frame.own);
    ASSERT_TRUE(bus->Receive(frame));
    EXPECT_EQ(frame.identifier, 0x123U);
    EXPECT_TRUE(frame.own);
    EXPECT_FALSE(bus->Receive(frame));
    // What no interface could carry is refused, and what this one cannot, too
    EXPECT_EQ(bus->Send(Live(0x800U, {})), SendResult::kRefused);
    kernel.send_failures = {EINVAL};
    EXPECT_EQ(bus->Send(Live(0x1U, {})), SendResult::kRefused);
    EXPECT_EQ(Sent().size(), 1U);
}

TEST_F(SocketCanBus, CountsWhatIsNoFrameAndWhatWasLost)
{
    Verifies(req::SRS_LIVE_027);
    const auto bus = Open();
    canfd_frame odd{};
    odd.len = 9U;
    kernel.Arrive(odd);
    kernel.dropped = 12U;
    kernel.Arrive(0x1U);
    LiveFrame frame;
    ASSERT_TRUE(bus->Receive(frame));
    EXPECT_EQ(frame.identifier, 1U);
    EXPECT_EQ(bus->Health().lost_frames, 12U);
    EXPECT_EQ(bus->Health().malformed, 1U);
}

TEST_F(SocketCanBus, TakesTheStampOfTheControllerWhereThereIsOne)
{
    Verifies(req::SRS_LIVE_057);
    const auto bus = Open();
    LiveFrame first;
    LiveFrame second;
    // Given two frames that are 3 ms apart for the controller, and were read at once
    kernel.hardware_ns = 5'000'000'000U;
    kernel.Arrive(0x1U);
    ASSERT_TRUE(bus->Receive(first));
    kernel.hardware_ns = 4'997'000'000U;
    kernel.Arrive(0x2U);
    ASSERT_TRUE(bus->Receive(second));
    EXPECT_EQ(first.time_ns - second.time_ns, 3'000'000U);
    EXPECT_LE(first.time_ns, LiveNow());
    // Then each without a stamp has that of the software: not 0, and not the distance of the one before
    kernel.hardware_ns.reset();
    for (int frame = 0; frame < 2; ++frame)
    {
        const std::uint64_t before_ns = LiveNow();
        kernel.Arrive(0x3U);
        ASSERT_TRUE(bus->Receive(first));
        EXPECT_GE(first.time_ns, before_ns) << frame;
        EXPECT_LE(first.time_ns, LiveNow()) << frame;
    }
}

TEST_F(SocketCanBus, KeepsInOrderWhatTheKernelDoesNotTakeYet)
{
    Verifies(req::SRS_LIVE_004);
    Verifies(req::SRS_LIVE_023);
    for (const int failure : {ENOBUFS, EAGAIN})
    {
        kernel.sent.clear();
        const auto bus = Open();
        kernel.send_failures = {failure, failure};
        EXPECT_EQ(bus->Send(Live(0x1U, {})), SendResult::kSent);
        EXPECT_EQ(bus->Send(Live(0x2U, {})), SendResult::kSent);
        EXPECT_EQ(bus->Health().waiting, 2U);
        EXPECT_TRUE(Until(*bus, [&bus] { return bus->Health().waiting == 0U; }));
        EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{1U, 2U}));
    }
}

TEST_F(SocketCanBus, WaitsForACarrierAndTakesNoMoreThanItsQueue)
{
    Verifies(req::SRS_LIVE_004);
    Verifies(req::SRS_LIVE_023);
    // Given an interface that is up and whose queue does not go
    can0().is_carrying = false;
    const auto bus = Open();
    for (std::uint32_t n = 0U; n < 64U; ++n)
    {
        ASSERT_EQ(bus->Send(Live(n, {})), SendResult::kSent);
    }
    EXPECT_EQ(bus->Send(Live(64U, {})), SendResult::kQueueFull);
    EXPECT_TRUE(kernel.sent.empty());
    Change(*bus, [](auto& interface) { interface.is_carrying = true; });
    EXPECT_TRUE(Until(*bus, [&bus] { return bus->Health().waiting == 0U; }));
    EXPECT_EQ(kernel.sent.size(), 64U);
    EXPECT_EQ(Sent().back(), 63U);
}

TEST_F(SocketCanBus, DropsAWaitingFrameThatTheKernelRefusesAtLast)
{
    Verifies(req::SRS_LIVE_023);
    const auto bus = Open();
    kernel.send_failures = {ENOBUFS, EINVAL, ENODEV};
    EXPECT_EQ(bus->Send(Live(0x1U, {})), SendResult::kSent);
    EXPECT_EQ(bus->Send(Live(0x2U, {})), SendResult::kSent);
    EXPECT_TRUE(Until(*bus, [&bus] { return bus->Health().waiting == 0U; }));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{2U})); // Also though the interface seemed to be gone once.
    EXPECT_EQ(bus->Health().dropped_frames, 1U);
}

TEST_F(SocketCanBus, GoesDownAndUpWithItsInterface)
{
    Verifies(req::SRS_LIVE_024);
    const auto bus = Open();
    kernel.send_failures = {ENOBUFS};
    ASSERT_EQ(bus->Send(Live(0x1U, {})), SendResult::kSent);
    // When it goes down, what waits is dropped
    Change(*bus, [](auto& interface) { interface.is_up = false; });
    EXPECT_EQ(bus->Health().state, BusState::kDown);
    EXPECT_EQ(bus->Health().dropped_frames, 1U);
    EXPECT_EQ(bus->Send(Live(0x2U, {})), SendResult::kDown);
    Change(*bus, [](auto& interface) { interface.is_up = true; });
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    EXPECT_EQ(bus->Send(Live(0x3U, {})), SendResult::kSent);
    // When it is removed, and made again with another index and filters of before
    const FakeCanKernel::Interface before = can0();
    kernel.interfaces.clear();
    kernel.TellNews();
    Serve(*bus);
    EXPECT_EQ(bus->Health().state, BusState::kDown);
    kernel.filters.clear();
    Change(*bus,
           [&before](auto& interface)
           {
               interface = before;
               interface.index = 9;
           });
    EXPECT_EQ(kernel.filters.size(), 1U);
    EXPECT_EQ(bus->Send(Live(0x4U, {})), SendResult::kSent);
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{3U, 4U}));
}

TEST_F(SocketCanBus, LooksWhenTheKernelHadMoreNewsThanFit)
{
    Verifies(req::SRS_LIVE_024);
    const auto bus = Open();
    can0().is_up = false;
    // Given a message without a byte, then there is nothing to look for
    kernel.is_news_empty = true;
    kernel.TellNews();
    Serve(*bus);
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    kernel.is_news_empty = false;
    // Given news that the kernel could not keep
    const FailingCall receive{SystemCall::kReceive, ENOBUFS, 0, 1};
    Serve(*bus);
    EXPECT_EQ(bus->Health().state, BusState::kDown);
}

TEST_F(SocketCanBus, LearnsByACallThatItsInterfaceIsDown)
{
    Verifies(req::SRS_LIVE_024);
    for (const int failure : {ENETDOWN, ENXIO, ENODEV})
    {
        can0().is_up = true;
        kernel.sent.clear();
        const auto bus = Open();
        // Given a failure of before: it is up again, and the frame goes out
        kernel.send_failures = {failure};
        EXPECT_EQ(bus->Send(Live(0x1U, {})), SendResult::kSent);
        EXPECT_EQ(Sent().size(), 1U);
        // One that fails again though it is said to be up
        kernel.send_failures = {failure, failure};
        EXPECT_EQ(bus->Send(Live(0x2U, {})), SendResult::kDown);
        // One that is down before the kernel tells it
        can0().is_up = false;
        kernel.send_failures = {failure};
        EXPECT_EQ(bus->Send(Live(0x3U, {})), SendResult::kDown);
        EXPECT_EQ(bus->Health().state, BusState::kDown);
    }
    // The same when it is read
    can0().is_up = true;
    const auto bus = Open();
    can0().is_up = false;
    kernel.FailReading(ENETDOWN);
    kernel.Arrive(0x5U);
    LiveFrame frame;
    ASSERT_TRUE(bus->Receive(frame));
    EXPECT_EQ(frame.identifier, 5U);
    EXPECT_EQ(bus->Health().state, BusState::kDown);
}

TEST_F(SocketCanBus, IsDownWhereTheKernelDoesNotSayHowItIs)
{
    Verifies(req::SRS_LIVE_024);
    kernel.is_link_mute = true;
    EXPECT_EQ(Open()->Health().state, BusState::kDown);
    kernel.is_link_mute = false;
    kernel.is_link_gone = true;
    EXPECT_EQ(Open()->Health().state, BusState::kDown);
    kernel.is_link_gone = false;
    EXPECT_EQ(Open()->Health().state, BusState::kActive);
}

TEST_F(SocketCanBus, IsOffTheBusUntilItIsRestartedByHand)
{
    Verifies(req::SRS_LIVE_022);
    const auto bus = Open();
    EXPECT_FALSE(bus->Restart()); // It is not off.
    kernel.send_failures = {ENOBUFS};
    ASSERT_EQ(bus->Send(Live(0x1U, {})), SendResult::kSent);
    Change(*bus, [](auto& interface) { interface.state = kOff; });
    EXPECT_EQ(bus->Health().state, BusState::kBusOff);
    EXPECT_EQ(bus->Health().dropped_frames, 1U);
    EXPECT_EQ(bus->Send(Live(0x2U, {})), SendResult::kBusOff);
    EXPECT_TRUE(kernel.orders.empty());
    // A restart that the kernel refuses, one that it takes
    kernel.order_answers = {EPERM};
    EXPECT_FALSE(bus->Restart());
    EXPECT_EQ(bus->Health().state, BusState::kBusOff);
    EXPECT_TRUE(bus->Restart());
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    EXPECT_EQ(bus->Health().restarts, 0U); // The kernel tells of it by an error frame.
    EXPECT_EQ(bus->Send(Live(0x3U, {})), SendResult::kSent);
    EXPECT_EQ(kernel.orders, (Lines{"restart 7", "restart 7"}));
}

TEST_F(SocketCanBus, SwitchesAnInterfaceOffAndOnWhoseDriverHasNoRestart)
{
    Verifies(req::SRS_LIVE_022);
    const auto bus = Open();
    Change(*bus, [](auto& interface) { interface.state = kOff; });
    kernel.order_answers = {EOPNOTSUPP, EPERM};
    EXPECT_FALSE(bus->Restart());
    kernel.order_answers = {EOPNOTSUPP, 0, EPERM};
    EXPECT_FALSE(bus->Restart());
    EXPECT_EQ(bus->Health().restarts, 0U);
    kernel.order_answers = {EOPNOTSUPP};
    EXPECT_TRUE(bus->Restart());
    EXPECT_EQ(bus->Health().restarts, 1U);
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    EXPECT_EQ(kernel.orders,
              (Lines{"restart 7", "down 7", "restart 7", "down 7", "up 7", "restart 7", "down 7", "up 7"}));
}

TEST_F(SocketCanBus, TakesNoOrderThatHasNoProperAnswerForDone)
{
    Verifies(req::SRS_LIVE_022);
    const auto bus = Open();
    Change(*bus, [](auto& interface) { interface.state = kOff; });
    kernel.restarts = false;
    kernel.is_link_strange = true;
    EXPECT_FALSE(bus->Restart());
    kernel.is_link_strange = false;
    Change(*bus, [](auto& interface) { interface.state = kOff; });
    kernel.is_link_mute = true;
    EXPECT_FALSE(bus->Restart());
    kernel.is_link_mute = false;
    Change(*bus, [](auto& interface) { interface.state = kOff; });
    kernel.is_link_gone = true;
    EXPECT_FALSE(bus->Restart());
}

TEST_F(SocketCanBus, RestartsByPolicyAndCountsWhatIsRefused)
{
    Verifies(req::SRS_LIVE_022);
    LiveOptions options;
    options.restart = RestartPolicy::kTimed;
    options.restart_after_ms = 20U;
    const auto bus = Open(options);
    kernel.order_answers = {EPERM};
    const std::uint64_t start_ns = LiveNow();
    Change(*bus, [](auto& interface) { interface.state = kOff; });
    EXPECT_TRUE(kernel.orders.empty());
    // Then after 20 ms, and again after as long because it was refused
    EXPECT_TRUE(Until(*bus, [&bus] { return bus->Health().state == BusState::kActive; }));
    EXPECT_GE(LiveNow() - start_ns, 40'000'000U);
    EXPECT_EQ(kernel.orders, (Lines{"restart 7", "restart 7"}));
    EXPECT_EQ(bus->Health().refused_restarts, 1U);
}

TEST_F(SocketCanBus, RestartsNothingThatWasMadeAgainAndCannotBeUsed)
{
    Verifies(req::SRS_LIVE_022);
    const auto bus = Open();
    // Given an interface that is made again, off the bus, and gone when the socket is bound to it
    {
        const FailingCall bind{SystemCall::kBind, ENODEV};
        Change(*bus,
               [](auto& interface)
               {
                   interface.index = 9;
                   interface.state = kOff;
               });
    }
    EXPECT_EQ(bus->Health().state, BusState::kBusOff);
    EXPECT_FALSE(bus->Restart());
    EXPECT_TRUE(kernel.orders.empty());
}

canfd_frame ErrorFrame(const std::uint32_t classes, const std::initializer_list<std::uint8_t> data)
{
    canfd_frame frame{};
    frame.can_id = CAN_ERR_FLAG | classes;
    frame.len = 8U;
    std::copy(data.begin(), data.end(), frame.data);
    return frame;
}

TEST_F(SocketCanBus, AsksTheKernelForTheStateOfAControllerBehindAnErrorFrame)
{
    Verifies(req::SRS_LIVE_021);
    Verifies(req::SRS_LIVE_022);
    const auto bus = Open();
    // Given an error frame of bus-off that is older than what the kernel says
    can0().state = std::uint8_t{2U};
    can0().transmit_errors = 130U;
    can0().receive_errors = 5U;
    kernel.Arrive(ErrorFrame(CAN_ERR_BUSOFF, {}));
    LiveFrame frame;
    ASSERT_TRUE(bus->Receive(frame));
    EXPECT_TRUE(frame.error);
    EXPECT_EQ(bus->Health().state, BusState::kPassive);
    EXPECT_EQ(bus->Health().transmit_errors, 130U);
    EXPECT_EQ(bus->Health().receive_errors, 5U);
    EXPECT_EQ(bus->Health().bus_offs, 1U);
    EXPECT_EQ(bus->Health().error_frames, 1U);
}

TEST_F(SocketCanBus, LearnsFromErrorFramesWhereThereIsNoController)
{
    Verifies(req::SRS_LIVE_021);
    Verifies(req::SRS_LIVE_022);
    can0().state = std::nullopt;
    const auto bus = Open();
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    kernel.Arrive(ErrorFrame(CAN_ERR_CRTL | CAN_ERR_CNT, {0U, CAN_ERR_CRTL_TX_WARNING, 0U, 0U, 0U, 0U, 97U, 3U}));
    Serve(*bus);
    EXPECT_EQ(bus->Health().state, BusState::kWarning);
    EXPECT_EQ(bus->Health().transmit_errors, 97U);
    EXPECT_EQ(bus->Health().receive_errors, 3U);
    // One that says nothing of the state, and news of the kernel that say nothing either
    kernel.Arrive(ErrorFrame(CAN_ERR_ACK, {}));
    kernel.TellNews();
    Serve(*bus);
    EXPECT_EQ(bus->Health().state, BusState::kWarning);
    kernel.Arrive(ErrorFrame(CAN_ERR_RESTARTED, {}));
    Serve(*bus);
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    EXPECT_EQ(bus->Health().restarts, 1U);
    // A controller that errs at an interface that is down does not make it work
    Change(*bus, [](auto& interface) { interface.is_up = false; });
    kernel.Arrive(ErrorFrame(CAN_ERR_BUSOFF, {}));
    Serve(*bus);
    EXPECT_EQ(bus->Health().state, BusState::kDown);
    EXPECT_EQ(bus->Health().error_frames, 4U);
}

TEST_F(SocketCanBus, CountsAnAbsenceThatIsOverWhenTheKernelIsAsked)
{
    Verifies(req::SRS_LIVE_580);
    const auto bus = Open();
    kernel.Arrive(ErrorFrame(CAN_ERR_BUSOFF, {}));
    Serve(*bus);
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    EXPECT_EQ(bus->Health().absences, 1U);
    EXPECT_EQ(bus->Health().absence, BusState::kBusOff);
    // One that the kernel tells of as well, before its error frame or behind it, counts once
    can0().state = std::uint8_t{3U};
    kernel.Arrive(ErrorFrame(CAN_ERR_BUSOFF, {}));
    Serve(*bus);
    EXPECT_EQ(bus->Health().state, BusState::kBusOff);
    EXPECT_EQ(bus->Health().absences, 2U);
    kernel.Arrive(ErrorFrame(CAN_ERR_BUSOFF, {}));
    can0().state = std::uint8_t{0U};
    Serve(*bus);
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    EXPECT_EQ(bus->Health().absences, 2U);
    // Its restart is the end of one, and another error is none
    kernel.Arrive(ErrorFrame(CAN_ERR_RESTARTED, {}));
    Serve(*bus);
    EXPECT_EQ(bus->Health().absences, 2U);
    // An interface that goes down and up
    Change(*bus, [](auto& interface) { interface.is_up = false; });
    Change(*bus, [](auto& interface) { interface.is_up = true; });
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    EXPECT_EQ(bus->Health().absences, 3U);
    EXPECT_EQ(bus->Health().absence, BusState::kDown);
}

TEST_F(SocketCanBus, CountsAnOverflowOfTheControllerAsALostFrame)
{
    Verifies(req::SRS_LIVE_584);
    const auto bus = Open();
    kernel.dropped = 12U;
    kernel.Arrive(ErrorFrame(CAN_ERR_CRTL, {0U, CAN_ERR_CRTL_RX_OVERFLOW}));
    Serve(*bus);
    EXPECT_EQ(bus->Health().lost_frames, 13U);
    // What is lost on the way out is told to nobody
    kernel.Arrive(ErrorFrame(CAN_ERR_CRTL, {0U, CAN_ERR_CRTL_TX_OVERFLOW}));
    kernel.dropped = 14U;
    kernel.Arrive(0x1U);
    Serve(*bus);
    EXPECT_EQ(bus->Health().lost_frames, 15U);
}

TEST_F(SocketCanBus, SaysWhatIsNoFrame)
{
    Verifies(req::SRS_LIVE_583);
    const auto bus = Open();
    EXPECT_EQ(bus->Problem(), "");
    canfd_frame odd{};
    odd.len = 9U;
    kernel.Arrive(odd);
    Serve(*bus);
    EXPECT_EQ(bus->Problem(), "a reading of 16 bytes that is no frame of CAN, expected one of 0 to 8 or 64 bytes");
}

TEST(LiveLinkSystemTest, SaysThatTheKernelTellsNothingOfInterfaces)
{
    Verifies(req::SRS_LIVE_020);
    const auto problem = [] { return ProblemOf([] { const LiveLink link; }); };
    for (const int passed : {0, 1})
    {
        const FailingCall socket{SystemCall::kSocket, EMFILE, passed};
        EXPECT_EQ(problem(), "rtnetlink: Too many open files, expected news of interfaces");
    }
    {
        const FailingCall bind{SystemCall::kBind, EADDRINUSE};
        EXPECT_EQ(problem(), "rtnetlink: Address already in use, expected news of interfaces");
    }
    const FailingCall option{SystemCall::kSetOption, EDOM};
    EXPECT_EQ(problem(), "rtnetlink: Numerical argument out of domain, expected news of interfaces");
}

} // namespace
} // namespace counterpoint::host
