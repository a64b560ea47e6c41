// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// 1 MB over the simulated bus at 1 Mbit/s, against the time that its frames alone take.
#include "canopen/cia301/sdo/client.hpp"
#include "canopen/cia301/sdo/server_port.hpp"
#include "hal/host/virtual/bus.hpp"
#include "hal/host/virtual/frame_bits.hpp"
#include "tests/canopen/cia301/fake_objects.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/verifies.hpp"

#include <vector>

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kMegabyte = 1048576U;
constexpr host::BusTime kStep = 100 * host::kMicrosecond;

/// A device that acts every 100 us and has three mailboxes.
class Station final : public host::BusListener, public FrameSink
{
  public:
    explicit Station(host::VirtualBus& bus)
        : bus_(bus), node_(bus.Attach(*this, host::NodeSetup{CanPortId::kFirst, 3U}))
    {
    }
    bool Send(const CanFrame& frame) noexcept override
    {
        return bus_.Submit(node_, frame) == hal::TransmitStatus::kAccepted;
    }
    void OnReceived(const CanFrame& frame, host::BusTime) override
    {
        heard.push_back(frame);
    }
    void OnConfirmed(const CanFrame&, host::BusTime) override
    {
    }

    std::vector<CanFrame> heard{};

  private:
    host::VirtualBus& bus_;
    host::NodeIndex node_;
};

/// Adds up what the frames take on the wire, with the three bits after each.
class Meter final : public host::BusObserver
{
  public:
    void OnBusRecord(const host::BusRecord& record) override
    {
        bits += host::MeasureFrame(record.sent.frame).WithIntermission();
        ++frames;
    }

    std::int64_t bits{0};
    std::int64_t frames{0};
};

class SdoThroughputTest : public ::testing::Test
{
  public:
    /// Runs until the client is done; the instant of that, 0: never.
    host::BusTime Run()
    {
        host::BusTime ended = 0;
        for (host::BusTime now = 0; (now < 60 * host::kSecond) && (ended == 0); now += kStep)
        {
            bus.Advance(now, &meter);
            const Instant instant{static_cast<std::uint32_t>(now / host::kMicrosecond)};
            const Moment moment{NodeState::kPreOperational, instant};
            for (const CanFrame& frame : server_station.heard)
            {
                port.OnFrame(frame, moment);
            }
            for (const CanFrame& frame : client_station.heard)
            {
                client.OnFrame(frame, instant);
            }
            server_station.heard.clear();
            client_station.heard.clear();
            port.OnCycle(moment);
            client.OnCycle(instant);
            ended = (client.State() == SdoClientState::kBusy) ? 0 : now;
        }
        return ended;
    }
    /// The share of the time that the bus was in use, as percent.
    void ExpectFast(const host::BusTime ended)
    {
        ASSERT_GT(ended, 0);
        EXPECT_EQ(client.Outcome().abort, SdoAbort::kNone);
        EXPECT_EQ(client.Outcome().size_bytes, kMegabyte);
        // 149 797 segments, an acknowledgement after each 127, at most 5 frames around them: nothing was repeated
        EXPECT_GE(meter.frames, 149797 + 1180 + 3);
        EXPECT_LE(meter.frames, 149797 + 1180 + 5);
        const double share = 100.0 * static_cast<double>(meter.bits) * 1000.0 / static_cast<double>(ended);
        RecordProperty("percent", std::to_string(share));
        EXPECT_GE(share, 95.0);
        EXPECT_LE(share, 100.1);
    }

    std::vector<std::uint8_t> value = std::vector<std::uint8_t>(kMegabyte);
    std::vector<std::uint8_t> buffer = std::vector<std::uint8_t>(kMegabyte);
    std::vector<std::uint8_t> own = std::vector<std::uint8_t>(kMegabyte);
    std::uint32_t length{kMegabyte};
    Entry entry{0x2000U, 0U,      DataType::kDomain, Access::kReadWrite,
                kInBoth, kInBoth, kMegabyte,         value.data(),
                &length, nullptr, nullptr,           nullptr};
    FakeObjects foreign{};
    Dictionary dictionary{EntryTable{&entry, 1U}, foreign};
    SdoServer server{SdoServerParts{dictionary, Room{buffer.data(), kMegabyte}, 1000000U, 127U}};
    host::VirtualBus bus{host::BitRate::k1M};
    Meter meter{};
    Station server_station{bus};
    Station client_station{bus};
    SdoServerPort port{server, server_station, NodeId{5U}};
    SdoClient client{SdoClientParts{client_station, NodeId{5U}, 1000000U, 127U}};
};

TEST_F(SdoThroughputTest, BlockUploadOfOneMegabyte)
{
    Verifies(req::SRS_SDC_010);
    dictionary.SetNmtState(NmtState::kPreOperational);
    for (std::uint32_t i = 0U; i < kMegabyte; ++i)
    {
        value[i] = static_cast<std::uint8_t>((i * 193U) >> 5U);
    }
    ASSERT_TRUE(client.StartUpload({0x2000U, 0U}, Room{own.data(), kMegabyte}, SdoMode::kBlock, Instant{0U}));
    ExpectFast(Run());
    EXPECT_TRUE(own == value);
}

TEST_F(SdoThroughputTest, BlockDownloadOfOneMegabyte)
{
    Verifies(req::SRS_SDC_010);
    dictionary.SetNmtState(NmtState::kPreOperational);
    for (std::uint32_t i = 0U; i < kMegabyte; ++i)
    {
        own[i] = static_cast<std::uint8_t>((i * 193U) >> 5U);
    }
    ASSERT_TRUE(client.StartDownload({0x2000U, 0U}, Bytes{own.data(), kMegabyte}, SdoMode::kBlock, Instant{0U}));
    ExpectFast(Run());
    EXPECT_TRUE(own == value);
}

} // namespace
} // namespace counterpoint::cia301
