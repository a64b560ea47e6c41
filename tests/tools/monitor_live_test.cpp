// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The monitor on a bus of a server that says what is no frame, or that the bus was away.
#include "canopen/cia306/text/text_file.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/runtime/stepped_time/stepped_process.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <string>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace counterpoint::tools
{
namespace
{
/// Greets its one client, and says what the test has it say.
class SayingServer
{
  public:
    explicit SayingServer(const std::string& text)
    {
        sockaddr_in own{};
        own.sin_family = AF_INET;
        own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t bytes = sizeof(own);
        EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&own), sizeof(own)), 0);
        EXPECT_EQ(::getsockname(listener_, reinterpret_cast<sockaddr*>(&own), &bytes), 0);
        EXPECT_EQ(::listen(listener_, 1), 0);
        address_ = "socketcand:127.0.0.1:" + std::to_string(ntohs(own.sin_port)) + "/can0";
        thread_ = std::thread(
            [this, all = "< hi >< ok >< ok >< ok >" + text]
            {
                connection_ = ::accept(listener_, nullptr, nullptr);
                static_cast<void>(::send(connection_, all.data(), all.size(), MSG_NOSIGNAL));
            });
    }
    ~SayingServer()
    {
        thread_.join();
        static_cast<void>(::close(connection_));
        static_cast<void>(::close(listener_));
    }
    SayingServer(const SayingServer&) = delete;
    SayingServer& operator=(const SayingServer&) = delete;
    [[nodiscard]] const std::string& Address() const
    {
        return address_;
    }

  private:
    int listener_{::socket(AF_INET, SOCK_STREAM, 0)};
    int connection_{-1};
    std::string address_;
    std::thread thread_;
};

class MonitorLiveTest : public test::CommandTest
{
  protected:
    /// Watches sensor and controller for a second of its time.
    void Watch(const std::string& said)
    {
        const SayingServer server(said);
        address = server.Address();
        const std::string examples = cia306::test::SourceFolder() + "/examples/emergency_stop/";
        test::SteppedProcess monitor({COUNTERPOINT_PROGRAM, "monitor", "--can", address, "--for", "1", "--json",
                                      "--dcf", examples + "sensor.dcf", examples + "controller.dcf"},
                                     Path("errors"));
        const std::string told = monitor.ReadAll();
        status = monitor.End();
        errors = cia306::ReadTextFile(Path("errors"));
        document = nlohmann::json::parse(told);
    }

    std::string address;
    int status{-1};
    std::string errors;
    nlohmann::json document;
};

// Given elements that are no frames, then they are told with what was wrong with the last one, and there is no verdict.
TEST_F(MonitorLiveTest, WhatCouldNotBeReadIsToldAndIsNoVerdict)
{
    Verifies(req::SRS_MON_581);
    Watch("< frame 103 zz 0101 >< frame 705 1.0 05 >< frame 1G4 1.0 FE >");
    EXPECT_EQ(status, 2);
    EXPECT_EQ(document["malformed"], 2);
    EXPECT_EQ(document["lost_frames"], 0);
    EXPECT_EQ(document["frames"], 1);
    EXPECT_EQ(document["holds"], false);
    EXPECT_EQ(errors,
              "counterpoint monitor: " + address +
                  " gave what is no frame: 2 malformed elements of the bus left out, the last: frame: identifier "
                  "'1G4', expected 1 to 3 hexadecimal digits up to 7FF, or 8 up to 1FFFFFFF\n");
}

// Given a bus-off between the frames of a pair, that is over with the next frame, then it is told in words, and the
// pair that it cut is none.
TEST_F(MonitorLiveTest, ABusOffIsToldAndCutsNoPair)
{
    Verifies(req::SRS_MON_580);
    Watch("< frame 101 1.0 0102 >< error 040 1.0 >< frame 102 1.0 FEFD >");
    EXPECT_EQ(status, 1); // No pair came.
    EXPECT_EQ(document["absences"], 1);
    EXPECT_EQ(document["violation_count"], 0) << document;
    EXPECT_EQ(errors, "counterpoint monitor: " + address + " went bus-off; nothing is judged until it is back\n" +
                          "counterpoint monitor: " + address + " is back\n");
}
} // namespace
} // namespace counterpoint::tools
