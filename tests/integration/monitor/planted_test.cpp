// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A recording of the simulated emergency-stop chain: clean as it is, and with violations planted in it.
#include "simulator/judge/run.hpp"
#include "simulator/report/reports.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/monitor/recordings.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace counterpoint::monitor
{
namespace
{
using test::CandumpLine;
using test::FramesOf;
using test::ViolationsOf;
using Texts = std::vector<std::string>;

std::string Example(const std::string& name)
{
    return cia306::test::SourceFolder() + "/examples/emergency_stop/" + name;
}

/// The chain without a fault for so long, as the simulator writes it.
std::vector<LogFrame> Simulated(const runtime::Nanoseconds duration)
{
    simulator::Run run(Example("chain.yaml"), std::nullopt, duration, true);
    run.Simulate([](runtime::Nanoseconds) {});
    return FramesOf(simulator::CandumpReport(run));
}

Network Chain()
{
    return Network({{Example("sensor.dcf"), std::nullopt},
                    {Example("controller.dcf"), std::nullopt},
                    {Example("actuator.dcf"), std::nullopt}},
                   std::nullopt);
}

std::string Text(const Time time, const Cause cause)
{
    return std::to_string(time / kMicrosecond) + " " + CauseName(cause);
}

/// Alters a recording pair by pair. A pair stands as two frames, one behind the other.
class Planter
{
  public:
    explicit Planter(std::vector<LogFrame> recording) : frames(std::move(recording))
    {
    }
    /// The next pair of 101h that is so far away from the last one that was altered that no two faults meet.
    std::size_t NextPair()
    {
        std::size_t left = 6U;
        for (; left != 0U; ++at_)
        {
            left -= frames.at(at_).identifier == 0x101U ? 1U : 0U;
        }
        return at_ - 1U;
    }
    void Expect(const Time time, const Cause cause)
    {
        expected.push_back(Text(time, cause));
    }
    std::vector<LogFrame> frames;
    Texts expected;

  private:
    std::size_t at_{0U};
};

void PlantLength(Planter& planter)
{
    for (const std::uint8_t length : {std::uint8_t{1U}, std::uint8_t{3U}, std::uint8_t{8U}})
    {
        for (const std::size_t half : {0U, 1U})
        {
            LogFrame& frame = planter.frames.at(planter.NextPair() + half);
            frame.length = length;
            planter.Expect(frame.time, Cause::kLength);
        }
    }
}

void PlantBits(Planter& planter)
{
    for (const std::uint32_t bit : {0U, 7U, 8U, 15U})
    {
        const std::size_t pair = planter.NextPair();
        planter.frames.at(pair + bit % 2U).data.at(bit / 8U) ^= static_cast<std::uint8_t>(1U << (bit % 8U));
        planter.Expect(planter.frames.at(pair + 1U).time, Cause::kNotInverse);
    }
}

void PlantOrder(Planter& planter)
{
    // The normal frame is missing
    std::size_t pair = planter.NextPair();
    planter.Expect(planter.frames.at(pair + 1U).time, Cause::kInverseFirst);
    planter.frames.erase(planter.frames.begin() + static_cast<std::ptrdiff_t>(pair));
    // The normal frame comes twice
    pair = planter.NextPair();
    LogFrame again = planter.frames.at(pair);
    again.time += 20 * kMicrosecond;
    planter.Expect(again.time, Cause::kNormalTwice);
    planter.frames.insert(planter.frames.begin() + static_cast<std::ptrdiff_t>(pair) + 1, again);
    // Both frames change places: one violation
    pair = planter.NextPair();
    std::swap(planter.frames.at(pair).identifier, planter.frames.at(pair + 1U).identifier);
    std::swap(planter.frames.at(pair).data, planter.frames.at(pair + 1U).data);
    planter.Expect(planter.frames.at(pair).time, Cause::kInverseFirst);
}

void PlantTimes(Planter& planter)
{
    // The inverse frame is missing, and comes too late
    std::size_t pair = planter.NextPair();
    planter.Expect(planter.frames.at(pair).time + 20 * kMillisecond, Cause::kSrvt);
    planter.frames.erase(planter.frames.begin() + static_cast<std::ptrdiff_t>(pair) + 1);
    pair = planter.NextPair();
    planter.Expect(planter.frames.at(pair).time + 20 * kMillisecond, Cause::kSrvt);
    planter.frames.at(pair + 1U).time = planter.frames.at(pair).time + 20001 * kMicrosecond;
    // Two pairs are missing
    pair = planter.NextPair();
    const Time last = planter.frames.at(pair).time;
    planter.Expect(last + 50 * kMillisecond, Cause::kSct);
    planter.frames.erase(std::remove_if(planter.frames.begin(), planter.frames.end(),
                                        [last](const LogFrame& frame)
                                        {
                                            const bool is_sensor =
                                                frame.identifier == 0x101U || frame.identifier == 0x102U;
                                            return is_sensor && frame.time > last + kMillisecond &&
                                                   frame.time < last + 60 * kMillisecond;
                                        }),
                         planter.frames.end());
    // A remote frame
    LogFrame remote = planter.frames.at(planter.NextPair());
    remote.is_remote = true;
    remote.time += kMillisecond;
    planter.Expect(remote.time, Cause::kRemote);
    planter.frames.push_back(remote);
}

TEST(Planted, ACleanRecordingHasNoViolation)
{
    Verifies(req::SRS_MON_013);
    const std::vector<LogFrame> frames = Simulated(10000000000);
    EXPECT_GT(frames.size(), 1500U);
    EXPECT_EQ(ViolationsOf(Chain(), frames), Texts{});
}

TEST(Planted, ExactlyThePlantedViolationsAreReported)
{
    Verifies(req::SRS_MON_013);
    Verifies(req::SRS_MON_005);
    Planter planter(Simulated(10000000000));
    PlantLength(planter);
    PlantBits(planter);
    PlantOrder(planter);
    PlantTimes(planter);
    PlantBits(planter);
    ASSERT_GE(planter.expected.size(), 20U);
    std::stable_sort(planter.frames.begin(), planter.frames.end(),
                     [](const LogFrame& left, const LogFrame& right) { return left.time < right.time; });
    // By way of the file, so that the reader is a part of the test
    std::string candump;
    for (const LogFrame& frame : planter.frames)
    {
        candump += CandumpLine(frame);
    }
    Texts found = ViolationsOf(Chain(), FramesOf(candump));
    EXPECT_EQ(found, planter.expected);
}
} // namespace
} // namespace counterpoint::monitor
