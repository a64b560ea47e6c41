// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// How long 127 slaves take, on a bus that carries one frame after the other, against what the bus allows at best.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <algorithm>
#include <cstdio>
#include <deque>
#include <iterator>

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint64_t kCycleUs = 1000U;
constexpr std::uint64_t kBootUs = 20'000U;
constexpr std::uint64_t kSlaveUs = 500U; ///< From a request to its answer.

/// A frame of 11 bits of identifier with as many stuff bits as there can be, and the pause behind it.
std::uint64_t FrameUs(const std::uint64_t bytes, const std::uint64_t bits_per_ms)
{
    const std::uint64_t bits = 47U + (8U * bytes) + ((33U + (8U * bytes)) / 4U);
    return (1000U * bits) / bits_per_ms;
}

/// Frames of one node in their order, each not before its time.
class Mailbox final : public cia301::FrameSink
{
  public:
    struct Waiting
    {
        std::uint64_t ready_us;
        CanFrame frame;
    };
    bool Send(const CanFrame& frame) noexcept override
    {
        frames.push_back(Waiting{now_us + delay_us, frame});
        return true;
    }

    std::deque<Waiting> frames{};
    std::uint64_t now_us{0U};
    std::uint64_t delay_us{0U};
};

/// Manager without a node-ID, so that there can be 127 slaves.
template <std::uint8_t LaneCount> class BusRun final : public NodeListener, public NmtListener, public StartUpListener
{
  public:
    BusRun(std::uint64_t bits_per_ms, std::uint32_t objects, std::uint32_t time_out_us)
        : bits_per_ms_(bits_per_ms), times_{time_out_us, 3U}
    {
        for (std::uint32_t i = 0U; i < objects; ++i)
        {
            BootRig::AddEntry(dcf_, static_cast<std::uint16_t>(0x2000U + i), 0U, {1U, 2U, 3U, 4U});
        }
        for (std::uint8_t node = 1U; node <= kLastNode; ++node)
        {
            setups_[node].assignment = kInNetwork | kBootSlave | kMandatory;
            setups_[node].device_type = 0x191U;
            setups_[node].vendor_id = 0x2AU;
            setups_[node].product_code = 7U;
            setups_[node].revision_number = 3U;
            setups_[node].serial_number = 0x1234U;
            setups_[node].concise_dcf = Bytes{dcf_.data(), static_cast<std::uint32_t>(dcf_.size())};
            boxes_[node].delay_us = kSlaveUs;
            slaves_[node] = std::make_unique<FakeSlave>(node, boxes_[node]);
            slaves_[node]->PutIdentity();
            slaves_[node]->boot_ms = kBootUs / 1000U;
            for (std::uint32_t i = 0U; i < objects; ++i)
            {
                slaves_[node]->Put32(static_cast<std::uint16_t>(0x2000U + i), 0U, 0U);
            }
        }
        nmt_.SetActive(true);
    }
    void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept override
    {
        if (event == NodeEvent::kBootUp)
        {
            sdo_.OnBootUp(node);
        }
        start_up_.OnNodeEvent(node, event, now);
    }
    void OnNmtSent(const NmtRequest&, Instant) noexcept override
    {
    }
    void OnNodeStatus(NodeId, Instant) noexcept override
    {
    }
    void OnMasterState(std::int16_t, Instant) noexcept override
    {
    }

    /// Time until every slave is OPERATIONAL.
    std::uint64_t Measure()
    {
        for (std::uint8_t node = 1U; node <= kLastNode; ++node)
        {
            slaves_[node]->Power(Now());
        }
        const std::uint64_t boot_ups_us = 127U * FrameUs(1U, bits_per_ms_);
        while (now_us_ < ((10U * kBootUs) + boot_ups_us)) // Until their first boot-up messages are through.
        {
            Step();
        }
        const std::uint64_t begin_us = now_us_;
        frames_ = 0;
        start_up_.Begin(Now());
        while (!IsAllOperational() && (now_us_ < (begin_us + 60'000'000U)))
        {
            Step();
        }
        return now_us_ - begin_us;
    }
    [[nodiscard]] int SdoFrames() const
    {
        return frames_;
    }

  private:
    [[nodiscard]] Instant Now() const
    {
        return Instant{static_cast<std::uint32_t>(now_us_)};
    }
    [[nodiscard]] bool IsAllOperational() const
    {
        return std::all_of(std::next(slaves_.begin()), slaves_.end(), [](const std::unique_ptr<FakeSlave>& slave)
                           { return slave->State() == cia301::NodeState::kOperational; });
    }
    /// The node whose frame wins the bus; kNodeRoom: nobody has one.
    [[nodiscard]] std::size_t Winner() const
    {
        std::size_t winner = kNodeRoom;
        for (std::size_t i = 0U; i < kNodeRoom; ++i)
        {
            const bool is_ready = !boxes_[i].frames.empty() && (boxes_[i].frames.front().ready_us <= now_us_);
            const bool is_first =
                is_ready && ((winner == kNodeRoom) || (boxes_[i].frames.front().frame.identifier <
                                                       boxes_[winner].frames.front().frame.identifier));
            winner = is_first ? i : winner;
        }
        return winner;
    }
    void Advance(std::uint64_t to_us)
    {
        while (next_cycle_us_ <= to_us)
        {
            SetTime(next_cycle_us_);
            next_cycle_us_ += kCycleUs;
            for (std::uint8_t node = 1U; node <= kLastNode; ++node)
            {
                slaves_[node]->OnCycle(Now());
            }
            table_.OnCycle(Now());
            sdo_.OnCycle(Now());
            start_up_.OnCycle(Now());
            nmt_.OnCycle(Now());
        }
        SetTime(to_us);
    }
    void SetTime(std::uint64_t to_us)
    {
        now_us_ = to_us;
        for (Mailbox& box : boxes_)
        {
            box.now_us = to_us;
        }
    }
    /// One frame, or 10 us in which nobody has one.
    void Step()
    {
        const std::size_t winner = Winner();
        if (winner == kNodeRoom)
        {
            Advance(now_us_ + 10U);
        }
        else
        {
            const CanFrame frame = boxes_[winner].frames.front().frame;
            boxes_[winner].frames.pop_front();
            Advance(now_us_ + FrameUs(frame.length_bytes, bits_per_ms_));
            frames_ += (frame.length_bytes == 8U) ? 1 : 0;
            Deliver(winner, frame);
        }
    }
    void Deliver(std::size_t sender, const CanFrame& frame)
    {
        if (sender != 0U)
        {
            table_.OnFrame(frame, Now());
            sdo_.OnFrame(frame, Now());
            start_up_.OnFrame(frame, Now());
        }
        else if (frame.identifier == 0U)
        {
            std::for_each(std::next(slaves_.begin()), slaves_.end(),
                          [this, &frame](auto& slave)
                          {
                              slave->OnFrame(frame, Now());
                              slave->OnCycle(Now());
                          });
        }
        else
        {
            FakeSlave& slave = *slaves_.at(frame.identifier & 0x7FU);
            slave.OnFrame(frame, Now());
            slave.OnCycle(Now());
        }
    }

    std::uint64_t bits_per_ms_;
    SdoTimes times_;
    std::uint64_t now_us_{0U};
    std::uint64_t next_cycle_us_{kCycleUs};
    int frames_{0};
    Octets dcf_{};
    std::array<Mailbox, kNodeRoom> boxes_{}; ///< 0: the manager.
    std::array<std::unique_ptr<FakeSlave>, kNodeRoom> slaves_{};
    std::array<SlaveSetup, kNodeRoom> setups_{};
    NetworkSetup setup_{NodeId{0U}, kIsMaster, 0U, 0U, 0U, setups_.data()};
    std::array<NodeRecord, kNodeRoom> nodes_{};
    std::array<NmtRequest, 256> queue_{};
    std::array<BootRecord, kNodeRoom> boots_{};
    FakeGate gate_{setup_};
    NodeTable table_{NodeTableParts{nodes_.data(), setup_, boxes_[0], *this}};
    NmtMaster nmt_{NmtMasterParts{setup_, NmtQueueRoom{queue_.data(), 256U}, boxes_[0], table_, *this, gate_}};
    SdoLanes<LaneCount> lanes_{boxes_[0], times_};
    SdoPool sdo_{lanes_.All(), times_};
    Cia302StartUp start_up_{StartUpParts{setup_, table_, nmt_, sdo_, gate_, boxes_[0], *this}, boots_.data()};
};

/// Reset, boot of the slaves, then the greater of what the bus and what one slave needs for S = 5 + n transfers:
///     B = t2 + T_boot + max(N (t1 + 2 S t8 + t2), S (2 t8 + T_slave)),   tn: frame of n bytes
template <std::uint8_t LaneCount>
void ExpectWithinBound(const std::uint64_t bits_per_ms, const std::uint32_t objects,
                       const std::uint32_t time_out_us = 100'000U)
{
    const std::uint64_t t1 = FrameUs(1U, bits_per_ms);
    const std::uint64_t t2 = FrameUs(2U, bits_per_ms);
    const std::uint64_t t8 = FrameUs(8U, bits_per_ms);
    const std::uint64_t transfers = 5U + objects;
    const std::uint64_t bus_us = 127U * (t1 + (2U * transfers * t8) + t2);
    const std::uint64_t slave_us = transfers * ((2U * t8) + kSlaveUs);
    const std::uint64_t bound_us = t2 + kBootUs + std::max(bus_us, slave_us);
    auto run = std::make_unique<BusRun<LaneCount>>(bits_per_ms, objects, time_out_us);
    const std::uint64_t measured_us = run->Measure();
    std::printf("127 slaves, n = %u, %u clients, %u kbit/s: B = t2 + T_boot + max(N (t1 + 2 S t8 + t2), S (2 t8 + "
                "T_slave)) = %u us with S = 5 + n, T_boot = 20000 us, T_slave = 500 us; measured %u us, ratio %.3f\n",
                static_cast<unsigned>(objects), static_cast<unsigned>(LaneCount), static_cast<unsigned>(bits_per_ms),
                static_cast<unsigned>(bound_us), static_cast<unsigned>(measured_us),
                static_cast<double>(measured_us) / static_cast<double>(bound_us));
    EXPECT_LE(measured_us * 10U, bound_us * 11U);
    // No transfer was tried twice
    EXPECT_EQ(run->SdoFrames(), static_cast<int>(127U * 2U * transfers));
}

TEST(BootTimeTest, AllSlavesAtTheSameTime)
{
    Verifies(req::SRS_BOOT_020);
    ExpectWithinBound<127U>(500U, 0U);
    ExpectWithinBound<127U>(500U, 10U);
    ExpectWithinBound<127U>(1000U, 30U);
}

TEST(BootTimeTest, FewClientsAreEnoughWhereTheBusIsSlow)
{
    Verifies(req::SRS_BOOT_020);
    Verifies(req::SRS_NMM_030);
    ExpectWithinBound<16U>(125U, 5U);
    ExpectWithinBound<16U>(500U, 20U);
}

// Given a bus on which an answer may come behind those of all others, when the time-out is longer than that, then no
// transfer is tried twice.
TEST(BootTimeTest, ManyClientsOnASlowBusWithTheTimeOutThatItNeeds)
{
    Verifies(req::SRS_BOOT_020);
    ExpectWithinBound<127U>(125U, 3U, 500'000U);
    ExpectWithinBound<127U>(50U, 1U, 1'100'000U);
    ExpectWithinBound<127U>(20U, 1U, 2'700'000U);
    ExpectWithinBound<127U>(10U, 0U, 5'300'000U);
}

} // namespace
} // namespace counterpoint::cia302
