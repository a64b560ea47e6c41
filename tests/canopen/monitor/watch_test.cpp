// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// One pair, frame by frame: controller (SCT 50 ms, SRVT 20 ms) listens to the sensor's 101h and 102h.
#include "canopen/monitor/report.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/monitor/recordings.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <unistd.h>

namespace counterpoint::monitor
{
namespace
{
using test::Frame;
using test::ViolationsOf;
using Frames = std::vector<LogFrame>;
using Texts = std::vector<std::string>;

class Watch : public ::testing::Test
{
  protected:
    Watch()
    {
        std::filesystem::remove(LatePath());
    }
    [[nodiscard]] static std::string LatePath()
    {
        return (std::filesystem::temp_directory_path() / ("watch_late_" + std::to_string(::getpid()) + ".dcf"))
            .string();
    }
    [[nodiscard]] static std::string Example(const std::string& name)
    {
        return cia306::test::SourceFolder() + "/examples/emergency_stop/" + name + ".dcf";
    }
    /// The controller with 5F05h:01 late.
    [[nodiscard]] static std::string LateController()
    {
        std::string text = cia306::test::ExampleText("controller");
        const std::size_t section = text.find("[5F05sub1]");
        const std::size_t value = text.find("ParameterValue=", section);
        text.replace(value, std::string("ParameterValue=0x00").size(), "ParameterValue=0x3C");
        cia306::WriteTextFile(LatePath(), text);
        return LatePath();
    }
    [[nodiscard]] static Frames Pair(const Time us, const Time srvt_us = 200)
    {
        return {Frame(us, 0x101U, {1U, 2U}), Frame(us + srvt_us, 0x102U, {0xFEU, 0xFDU})};
    }
    /// Valid pairs at 0 and 25 ms, the frames, valid pairs from `then_us` on.
    [[nodiscard]] static Frames Among(const Frames& frames, const Time then_us)
    {
        Frames all = Pair(0);
        for (const Frames& part : {Pair(25000), frames, Pair(then_us), Pair(then_us + 25000)})
        {
            all.insert(all.end(), part.begin(), part.end());
        }
        return all;
    }

    Network early{{{Example("sensor"), std::nullopt}, {Example("controller"), std::nullopt}}, std::nullopt};
    Network late{{{Example("sensor"), std::nullopt}, {LateController(), std::nullopt}}, std::nullopt};
};

TEST_F(Watch, ValidPairsUpToTheLimitsAreNoViolation)
{
    Verifies(req::SRS_MON_005);
    Verifies(req::SRS_MON_006);
    EXPECT_EQ(ViolationsOf(early, Among(Pair(75000, 20000), 125000)), Texts{});
    // With late detection the whole next pair has to come within SCT
    EXPECT_EQ(ViolationsOf(late, Among(Pair(55000, 20000), 100000)), Texts{});
    EXPECT_EQ(ViolationsOf(late, Among(Pair(55001, 20000), 100000)), (Texts{"75000 SCT expired"}));
}

TEST_F(Watch, OneMicrosecondBeyondALimitIsAViolationAtTheLimit)
{
    Verifies(req::SRS_MON_006);
    Verifies(req::SRS_MON_007);
    EXPECT_EQ(ViolationsOf(early, Among(Pair(75001), 100000)), (Texts{"75000 SCT expired"}));
    EXPECT_EQ(ViolationsOf(early, Among(Pair(50000, 20001), 100000)), (Texts{"70000 SRVT expired"}));
    EXPECT_EQ(ViolationsOf(late, Among(Pair(50000, 20001), 100000)), (Texts{"70001 SRVT expired"})); // Late.
}

TEST_F(Watch, EachFrameRuleHasItsCause)
{
    Verifies(req::SRS_MON_005);
    const LogFrame normal = Frame(50000, 0x101U, {1U, 2U});
    const LogFrame inverse = Frame(50200, 0x102U, {0xFEU, 0xFDU});
    EXPECT_EQ(ViolationsOf(early, Among({Frame(50000, 0x101U, {1U}), inverse}, 75000)), (Texts{"50000 wrong length"}));
    EXPECT_EQ(ViolationsOf(early, Among({Frame(50000, 0x101U, {1U, 2U, 3U}), inverse}, 75000)),
              (Texts{"50000 wrong length"}));
    EXPECT_EQ(ViolationsOf(early, Among({normal, Frame(50200, 0x102U, {0xFEU})}, 75000)),
              (Texts{"50200 wrong length"}));
    EXPECT_EQ(ViolationsOf(early, Among({inverse}, 75000)), (Texts{"50200 inverse first"}));
    EXPECT_EQ(ViolationsOf(early, Among({normal, Frame(50200, 0x102U, {0xFEU, 0xFCU})}, 75000)),
              (Texts{"50200 not inverse"}));
    EXPECT_EQ(ViolationsOf(early, Among({normal, Frame(50100, 0x101U, {1U, 2U}), inverse}, 75000)),
              (Texts{"50100 normal twice"}));
}

/// One pair of identifiers with its limits, without files.
struct Timing
{
    Time refresh_us;
    Time sct_us;
    Time srvt_us;
};

struct SeenByWatch final : BreachSink
{
    void OnBreach(const std::size_t /*watch*/, const Breach& breach) override
    {
        texts.push_back(std::to_string(breach.time / kMicrosecond) + " " + CauseName(breach.cause));
    }
    Texts texts;
};

/// What a watch of 101h and 102h makes of the frames: violations, pairs, greatest cycle.
struct Watched
{
    Texts texts;
    std::size_t pairs{0U};
    Time greatest_us{0};
};

Watched WatchedOf(const Timing& timing, const bool is_late, const Frames& frames)
{
    SeenByWatch seen;
    SrdoWatch watch(0U, {0x101U, 0x102U, 16U, timing.sct_us * kMicrosecond, timing.srvt_us * kMicrosecond, is_late},
                    seen);
    for (const LogFrame& frame : frames)
    {
        watch.OnFrame(frame);
    }
    return {seen.texts, watch.PairCount(), watch.Cycle().greatest / kMicrosecond};
}

/// Pair by pair, 200 us from normal to inverse frame.
Frames Sound(const Time refresh_us, const std::size_t pairs, const bool is_changing)
{
    Frames frames;
    for (std::size_t pair = 0U; pair < pairs; ++pair)
    {
        const Time us = static_cast<Time>(pair) * refresh_us;
        const auto value = static_cast<std::uint8_t>(is_changing ? pair : 1U);
        frames.push_back(Frame(us, 0x101U, {value, 0U}));
        frames.push_back(Frame(us + 200, 0x102U, {static_cast<std::uint8_t>(0xFFU - value), 0xFFU}));
    }
    return frames;
}

// Given 60 pairs 10 ms apart with the same data and SRVT 20 ms, when the normal frame of pair 20 is lost, then that is
// one violation, and 59 pairs are left; it was one of every later pair.
TEST_F(Watch, ALostNormalFrameIsOneViolation)
{
    Verifies(req::SRS_MON_030);
    for (const bool is_late : {false, true})
    {
        Frames frames = Sound(10000, 60U, false);
        frames.erase(frames.begin() + 40);
        const Watched watched = WatchedOf({10000, 50000, 20000}, is_late, frames);
        EXPECT_EQ(watched.texts, (Texts{"200200 inverse first"}));
        EXPECT_EQ(watched.pairs, 59U);
        EXPECT_EQ(watched.greatest_us, 20000);
    }
}

// Given any single frame of a sound recording that is lost, or any single pair whose frames changed places, then the
// watch tells one violation, and every other pair is one, but the one that the second normal frame discards.
TEST_F(Watch, AnySingleFaultOfASoundRecordingIsOneViolation)
{
    Verifies(req::SRS_MON_030);
    constexpr std::size_t kPairs = 20U;
    for (const Timing& timing : {Timing{25000, 50000, 20000}, Timing{10000, 50000, 20000}, Timing{25000, 50000, 30000},
                                 Timing{20000, 50000, 20000}, Timing{10000, 30000, 10000}, Timing{10000, 15000, 12000},
                                 Timing{5000, 60000, 50000}, Timing{20000, 25000, 1000}})
    {
        for (std::size_t place = 0U; place < 8U * (kPairs - 2U); ++place)
        {
            const bool is_late = (place & 1U) != 0U;
            const bool is_changing = (place & 2U) != 0U;
            const bool is_inverse = (place & 4U) != 0U;
            const std::size_t pair = 1U + place / 8U;
            const auto normal = static_cast<std::ptrdiff_t>(2U * pair);
            const std::string what = std::to_string(timing.refresh_us) + " " + std::to_string(timing.sct_us) + " " +
                                     std::to_string(timing.srvt_us) + " place " + std::to_string(place);
            Frames lost = Sound(timing.refresh_us, kPairs, is_changing);
            lost.erase(lost.begin() + normal + (is_inverse ? 1 : 0));
            const Watched of_lost = WatchedOf(timing, is_late, lost);
            EXPECT_EQ(of_lost.texts.size(), 1U) << what;
            const bool is_twice = of_lost.texts.front().find("normal twice") != std::string::npos;
            EXPECT_EQ(of_lost.pairs, kPairs - (is_twice ? 2U : 1U)) << what;
            EXPECT_TRUE(!is_twice || is_inverse) << what;
            Frames exchanged = Sound(timing.refresh_us, kPairs, is_changing);
            std::swap(exchanged.at(2U * pair).identifier, exchanged.at(2U * pair + 1U).identifier);
            std::swap(exchanged.at(2U * pair).data, exchanged.at(2U * pair + 1U).data);
            const Watched of_exchanged = WatchedOf(timing, is_late, exchanged);
            EXPECT_EQ(of_exchanged.texts,
                      (Texts{std::to_string(static_cast<Time>(pair) * timing.refresh_us) + " inverse first"}))
                << what;
            EXPECT_EQ(of_exchanged.pairs, kPairs - 1U) << what;
            EXPECT_EQ(of_exchanged.greatest_us, 2 * timing.refresh_us) << what;
        }
    }
}

// What follows the normal frame that fits decides: a wrong inverse frame is told by its cause, one beyond SRVT has no
// normal frame, and one behind a stop is what is left.
TEST_F(Watch, TheFrameBehindAFittingNormalFrameDecides)
{
    Verifies(req::SRS_MON_030);
    Verifies(req::SRS_MON_340);
    const LogFrame first = Frame(50200, 0x102U, {0xFEU, 0xFDU});
    const LogFrame fitting = Frame(60000, 0x101U, {1U, 2U});
    const Texts one{"50200 inverse first"};
    EXPECT_EQ(ViolationsOf(early, Among({first, fitting, Frame(80000, 0x102U, {0xFEU, 0xFDU})}, 85000)), one);
    EXPECT_EQ(ViolationsOf(early, Among({first, fitting, Frame(80001, 0x102U, {0xFEU, 0xFDU})}, 85000)),
              (Texts{"50200 inverse first", "80001 inverse first"}));
    EXPECT_EQ(ViolationsOf(early, Among({first, fitting, Frame(60200, 0x102U, {0xFEU, 0xFCU})}, 85000)),
              (Texts{"50200 inverse first", "60200 not inverse"}));
    EXPECT_EQ(ViolationsOf(early, Among({first, fitting, Frame(60200, 0x102U, {0xFEU})}, 85000)),
              (Texts{"50200 inverse first", "60200 wrong length"}));
    EXPECT_EQ(ViolationsOf(early,
                           Among({first, fitting, Frame(60100, 0x000U, {2U, 1U}), Frame(60200, 0x102U, {0xFEU, 0xFDU})},
                                 900000)),
              one);
    // Two exchanged pairs with other data are two violations
    EXPECT_EQ(ViolationsOf(early, Among({first, Frame(50400, 0x101U, {1U, 2U}), Frame(60000, 0x102U, {0xF0U, 0xF0U}),
                                         Frame(60200, 0x101U, {0x0FU, 0x0FU})},
                                        70000)),
              (Texts{"50200 inverse first", "60000 not inverse"}));
}

/// Greatest cycle of the sensor's SRDO 1, in microseconds, when the recording is over.
Time GreatestCycleUs(const Network& network, const Frames& frames)
{
    Analysis analysis(network, [](const Violation&) {});
    for (const LogFrame& frame : frames)
    {
        analysis.Take(frame);
    }
    analysis.End();
    for (std::size_t number = 0U; number < network.Watches().size(); ++number)
    {
        if (network.Watches()[number].setup.normal_id == 0x101U)
        {
            return analysis.Watches()[number].Cycle().greatest / 1000;
        }
    }
    return -1;
}

TEST_F(Watch, TheCycleRunsFromValidPairToValidPair)
{
    Verifies(req::SRS_MON_010);
    // Clean: 25 ms
    EXPECT_EQ(GreatestCycleUs(early, Among(Pair(50000), 75000)), 25000);
    // Eight inverse frames are lost: 225 ms without a pair
    Frames lost;
    for (Time us = 50000; us < 250000; us += 25000)
    {
        lost.push_back(Frame(us, 0x101U, {1U, 2U}));
    }
    for (const Network* const network : {&early, &late})
    {
        EXPECT_EQ(GreatestCycleUs(*network, Among(lost, 250000)), 225000);
    }
    // The same with every other cause: wrong bits, wrong length, inverse first, normal lost, nothing at all
    const Frames wrong{Frame(50000, 0x101U, {1U, 2U}), Frame(50200, 0x102U, {0xFEU, 0xFCU})};
    const Frames shorter{Frame(50000, 0x101U, {1U}), Frame(50200, 0x102U, {0xFEU})};
    for (const Frames& frames : {wrong, shorter, Frames{Frame(50200, 0x102U, {0xFEU, 0xFDU})}, Frames{}})
    {
        EXPECT_EQ(GreatestCycleUs(early, Among(frames, 75000)), 50000);
    }
    // A recording that ends without a pair for longer than SCT, and one that ends within SCT
    Frames silent = Among({}, 50000); // The last pair at 75 ms
    silent.push_back(Frame(300000, 0x705U, {5U}));
    EXPECT_EQ(GreatestCycleUs(early, silent), 225000);
    silent.back() = Frame(120000, 0x705U, {5U});
    EXPECT_EQ(GreatestCycleUs(early, silent), 25000);
    // What a stopped producer leaves out is none: stopped at 80 ms, again from 300 ms on
    Frames stopped = Among({}, 50000);
    stopped.push_back(Frame(80000, 0x000U, {2U, 1U}));
    for (const Time us : {300000, 325000})
    {
        const Frames pair = Pair(us);
        stopped.insert(stopped.end(), pair.begin(), pair.end());
    }
    EXPECT_EQ(GreatestCycleUs(early, stopped), 25000);
    // but what it was late before that is, also where the consumer ends; who has no part in it (node 3) ends nothing
    for (const LogFrame& end : {Frame(200000, 0x000U, {2U, 1U}), Frame(200000, 0x000U, {2U, 2U}),
                                Frame(200000, 0x702U, {4U}), Frame(200000, 0x000U, {2U, 3U})})
    {
        stopped[8] = end;
        EXPECT_EQ(GreatestCycleUs(early, stopped), (end.data[1] == 3U) ? 225000 : 125000);
    }
}

TEST_F(Watch, EachSenderOfAGfcHasItsOwnRefreshTimeAndTheGreatestEndsTheWait)
{
    Verifies(req::SRS_MON_016);
    // Given a sensor with a refresh time of 40 ms, and the controller, which sends by 103h, with 25 ms
    std::string text = cia306::test::ExampleText("sensor");
    const std::size_t value = text.find("ParameterValue=25", text.find("[1301sub2]"));
    ASSERT_NE(value, std::string::npos);
    cia306::WriteTextFile(LatePath(), text.replace(value, 17U, "ParameterValue=40"));
    const Network network({{LatePath(), std::nullopt}, {Example("controller"), std::nullopt}}, std::nullopt);
    const LogFrame gfc = Frame(40000, 0x001U, {});
    const auto controller_at = [](const Time us)
    { return Frames{Frame(us, 0x103U, {0U, 0U}), Frame(us + 200, 0x104U, {0xFFU, 0xFFU})}; };
    const auto with = [&gfc, &controller_at](const Time controller_us, const Time sensor_us)
    {
        Frames frames{gfc};
        const Frames pair = controller_at(controller_us);
        frames.insert(frames.end(), pair.begin(), pair.end());
        return Among(frames, sensor_us);
    };
    // Then 25 ms behind it the controller follows, a microsecond later it does not
    EXPECT_EQ(ViolationsOf(network, with(65000, 80001)), (Texts{"75000 SCT expired"}));
    EXPECT_EQ(ViolationsOf(network, with(65001, 80001)), (Texts{"75000 SCT expired", "80000 GFC not followed"}));
    // and the sensor follows 40 ms behind it
    EXPECT_EQ(ViolationsOf(network, with(65001, 80000)), (Texts{"75000 SCT expired"}));
}

TEST_F(Watch, AnSrdoFollowsEachGfc)
{
    Verifies(req::SRS_MON_016);
    // Sensor and controller may send it; their refresh time is 25 ms. The sensor's next normal frame counts
    const LogFrame gfc = Frame(40000, 0x001U, {});
    EXPECT_EQ(ViolationsOf(early, Among({gfc}, 65000)), Texts{});
    EXPECT_EQ(ViolationsOf(early, Among({gfc}, 65001)), (Texts{"65000 GFC not followed"}));
    EXPECT_EQ(
        ViolationsOf(early, Among({gfc, Frame(60000, 0x103U, {0U, 0U}), Frame(60200, 0x104U, {0xFFU, 0xFFU})}, 70000)),
        Texts{});
    // A second GFC changes nothing, one with data is none, an inverse frame follows nothing, and the end is an expiry,
    // too
    EXPECT_EQ(ViolationsOf(early, Among({gfc, Frame(60000, 0x001U, {})}, 70000)), (Texts{"65000 GFC not followed"}));
    EXPECT_EQ(ViolationsOf(early, Among({Frame(40000, 0x001U, {1U})}, 70000)), Texts{});
    EXPECT_EQ(ViolationsOf(early, Among({gfc, Frame(50000, 0x104U, {0xFFU, 0xFFU})}, 70000)),
              (Texts{"50000 inverse first", "65000 GFC not followed"}));
    EXPECT_EQ(ViolationsOf(early, {gfc}, 66000), (Texts{"65000 GFC not followed"}));
    LogFrame extended = gfc;
    extended.is_extended = true;
    EXPECT_EQ(ViolationsOf(early, {extended}, 66000), Texts{});
    // Violations stay in the order of their times
    EXPECT_EQ(ViolationsOf(early, Among({gfc}, 120000)), (Texts{"65000 GFC not followed", "75000 SCT expired"}));
    // A device that only listens sends none, so that nothing is awaited
    const Network listener({{Example("actuator"), std::nullopt}}, std::nullopt);
    EXPECT_EQ(ViolationsOf(listener, {gfc}, 200000), Texts{});
}

TEST_F(Watch, ASilentBusLastsAsLongAsItIsWatched)
{
    Verifies(req::SRS_MON_010);
    Analysis analysis(early, [](const Violation&) {});
    analysis.Advance(40000 * kSecond);
    analysis.Advance(40002 * kSecond);
    EXPECT_EQ(analysis.Last() - analysis.First(), 2 * kSecond);
    EXPECT_EQ(analysis.FrameCount(), 0U);
}

TEST_F(Watch, TheDocumentTellsTheTimesOfFramesNotOfTheWatching)
{
    Verifies(req::SRS_MON_011);
    const std::vector<Violation> none;
    Analysis analysis(early, [](const Violation&) {});
    const auto times = [this, &none, &analysis]()
    {
        const std::string document = JsonReport({early, analysis, none, "bus"});
        const std::size_t begin = document.find("\"first_s\"");
        return document.substr(begin, document.find(" \"services\"") - begin);
    };
    // Given a bus that is watched from 10 s on, and is silent
    analysis.Advance(10 * kSecond);
    analysis.Advance(11 * kSecond);
    EXPECT_EQ(times(), "\"first_s\": null,\n  \"last_s\": null,\n ");
    // When frames come at 12 and 13 s, and none until 20 s
    analysis.Take(Frame(12000000, 0x701U, {5U}));
    analysis.Take(Frame(13000000, 0x701U, {5U}));
    analysis.Advance(20 * kSecond);
    // Then their times are told
    EXPECT_EQ(times(), "\"first_s\": 12.0,\n  \"last_s\": 13.0,\n ");
}

TEST_F(Watch, OtherFramesAreNoCandidates)
{
    Verifies(req::SRS_MON_341);
    LogFrame extended = Frame(50000, 0x102U, {1U});
    LogFrame wide = extended;
    LogFrame error = extended;
    extended.is_extended = true;
    wide.is_fd = true;
    error.is_error = true;
    EXPECT_EQ(ViolationsOf(early, Among({extended, wide, error}, 75000)), Texts{});
    LogFrame remote = Frame(50000, 0x101U, {1U, 2U});
    remote.is_remote = true;
    EXPECT_EQ(ViolationsOf(early, Among({remote}, 75000)), (Texts{"50000 remote frame"}));
}

TEST_F(Watch, AMissingInverseFrameIsFoundEarlyOrLate)
{
    Verifies(req::SRS_MON_007);
    const LogFrame normal = Frame(50000, 0x101U, {1U, 2U});
    EXPECT_EQ(ViolationsOf(early, Among({normal}, 75000)), (Texts{"70000 SRVT expired"}));
    // Late: the next normal frame comes first, and that pair is lost with it
    EXPECT_EQ(ViolationsOf(late, Among({normal}, 75000)), (Texts{"75000 normal twice"}));
    // or SCT of the pair at 25 ms
    EXPECT_EQ(ViolationsOf(late, Among({normal}, 75001)), (Texts{"75000 SCT expired"}));
    // An inverse frame after SRVT, but SCT before it
    EXPECT_EQ(ViolationsOf(late, Among({Frame(60000, 0x101U, {1U, 2U}), Frame(81000, 0x102U, {0xFEU, 0xFDU})}, 100000)),
              (Texts{"75000 SCT expired"}));
}

TEST_F(Watch, SilenceIsReportedOnceUntilAValidPairComes)
{
    Verifies(req::SRS_MON_006);
    EXPECT_EQ(ViolationsOf(early, Pair(0), 10000000), (Texts{"50000 SCT expired"}));
    EXPECT_EQ(ViolationsOf(early, Among({}, 900000)), (Texts{"75000 SCT expired"}));
    // Before the first valid pair nothing is supervised
    EXPECT_EQ(ViolationsOf(early, {Frame(0, 0x080U, {})}, 10000000), Texts{});
    EXPECT_EQ(ViolationsOf(early, {Frame(0, 0x101U, {1U, 2U})}, 10000000), (Texts{"20000 SRVT expired"}));
}

TEST_F(Watch, AProducerThatIsStoppedIsNoViolation)
{
    Verifies(req::SRS_MON_009);
    for (const LogFrame& stop : {Frame(30000, 0x000U, {2U, 1U}), Frame(30000, 0x000U, {128U, 0U}),
                                 Frame(30000, 0x701U, {127U}), Frame(30000, 0x701U, {0U}), Frame(30000, 0x702U, {4U})})
    {
        EXPECT_EQ(ViolationsOf(early, Among({stop}, 900000)), Texts{}) << stop.identifier;
    }
    // Commands and states of others, and a start, stop nothing
    for (const LogFrame& other :
         {Frame(30000, 0x000U, {2U, 9U}), Frame(30000, 0x000U, {1U, 0U}), Frame(30000, 0x701U, {5U}),
          Frame(30000, 0x701U, {0x85U}), Frame(30000, 0x000U, {2U})})
    {
        EXPECT_EQ(ViolationsOf(early, Among({other}, 900000)).size(), 1U) << other.identifier;
    }
}

// Given a recording that begins within a pair, then its inverse frame is no violation; one that comes later than SRVT,
// or after a normal frame that was seen, is.
TEST_F(Watch, ARecordingMayBeginWithinAPair)
{
    Verifies(req::SRS_MON_340);
    const LogFrame rest = Frame(15000, 0x102U, {0xFEU, 0xFDU});
    EXPECT_EQ(ViolationsOf(early, {rest}), Texts{});
    EXPECT_EQ(ViolationsOf(early, {Frame(0, 0x705U, {5U}), rest}), Texts{});
    EXPECT_EQ(ViolationsOf(early, {Frame(0, 0x705U, {5U}), Frame(20001, 0x102U, {0xFEU, 0xFDU})}),
              (Texts{"20001 inverse first"}));
    EXPECT_EQ(ViolationsOf(early, {rest, Frame(16000, 0x102U, {0xFEU, 0xFDU})}), (Texts{"16000 inverse first"}));
    Frames seen = Pair(0);
    seen.push_back(rest);
    EXPECT_EQ(ViolationsOf(early, seen), (Texts{"15000 inverse first"}));
}

// Given a stop between the frames of a pair, then the inverse frame that was under way is no violation.
TEST_F(Watch, AProducerMayBeStoppedWithinAPair)
{
    Verifies(req::SRS_MON_009);
    Verifies(req::SRS_MON_340);
    Frames frames = Pair(50000);
    frames.insert(frames.begin() + 1, Frame(50100, 0x000U, {2U, 1U}));
    EXPECT_EQ(ViolationsOf(early, Among(frames, 900000)), Texts{});
    frames.push_back(Frame(51000, 0x102U, {0xFEU, 0xFDU}));
    EXPECT_EQ(ViolationsOf(early, Among(frames, 900000)), (Texts{"51000 inverse first"}));
}

// Given a bus that was not seen for a time, then nothing of that time is judged, a pair that was cut by either end of
// it neither, and supervision begins with the next valid pair.
TEST_F(Watch, WhatWasNotSeenIsNotJudged)
{
    Verifies(req::SRS_MON_120);
    Texts texts;
    Analysis analysis(early, [&texts](const Violation& violation)
                      { texts.push_back(std::to_string(violation.breach.time / kMicrosecond)); });
    for (const LogFrame& frame : Among({}, 50000))
    {
        analysis.Take(frame);
    }
    analysis.Take(Frame(100000, 0x101U, {1U, 2U}));
    analysis.Take(Frame(100100, 0x001U, {}));
    analysis.Interrupt();
    analysis.Take(Frame(900000, 0x102U, {0xFEU, 0xFDU}));
    analysis.Advance(990000 * kMicrosecond);
    EXPECT_EQ(texts, Texts{});
    for (const LogFrame& frame : Pair(1000000))
    {
        analysis.Take(frame);
    }
    analysis.Advance(1100000 * kMicrosecond);
    EXPECT_EQ(texts, (Texts{"1050000"}));
    EXPECT_EQ(analysis.Watches().front().PairCount(), 5U);
}

TEST_F(Watch, AnSrdoThatNobodyConsumesHasTheLimitsOfItsProducer)
{
    Verifies(req::SRS_MON_007);
    const Network twice{{{Example("sensor"), std::nullopt}}, std::nullopt};
    EXPECT_EQ(ViolationsOf(twice, Among(Pair(75001), 100000)), (Texts{"75000 SCT expired"}));
    EXPECT_EQ(ViolationsOf(twice, Among(Pair(50000, 20001), 100000)), (Texts{"70000 SRVT expired"})); // Early, its own.
    const Network given{{{Example("sensor"), std::nullopt}}, 60 * kMillisecond};
    EXPECT_EQ(ViolationsOf(given, Among(Pair(75001), 100000)), Texts{});
}

TEST_F(Watch, EachConsumerOfAPairHasItsOwnLimits)
{
    Verifies(req::SRS_MON_008);
    // Given the controller a second time, as node 3 with SRVT 10 ms
    std::string text = cia306::test::ExampleText("controller");
    const std::size_t section = text.find("[1301sub3]");
    text.replace(text.find("ParameterValue=20", section), 17U, "ParameterValue=10");
    const std::string path = (std::filesystem::temp_directory_path() / "watch_second.dcf").string();
    cia306::WriteTextFile(path, text);
    const Network network{
        {{Example("sensor"), std::nullopt}, {Example("controller"), std::nullopt}, {path, std::uint8_t{3U}}},
        std::nullopt};
    std::filesystem::remove(path);
    std::vector<std::size_t> watchers;
    Texts texts;
    Analysis analysis(network,
                      [&](const Violation& violation)
                      {
                          watchers.push_back(violation.watches.size());
                          texts.push_back(CauseName(violation.breach.cause));
                      });
    const Frames frames = Among({Frame(50000, 0x101U, {1U, 2U}), Frame(50200, 0x102U, {0xFEU, 0xFCU})}, 75000);
    for (const LogFrame& frame : frames)
    {
        analysis.Take(frame);
    }
    // Then what is wrong with a frame is one violation that both see
    EXPECT_EQ(texts, (Texts{"not inverse"}));
    EXPECT_EQ(watchers, (std::vector<std::size_t>{2U}));
    // and 15 ms are too much for the second alone
    analysis.Take(Frame(120000, 0x101U, {1U, 2U}));
    analysis.Take(Frame(135000, 0x102U, {0xFEU, 0xFDU}));
    EXPECT_EQ(texts, (Texts{"not inverse", "SRVT expired"}));
    EXPECT_EQ(watchers, (std::vector<std::size_t>{2U, 1U}));
}

// Given inverse frames 20.001 ms and more behind their normal frames, then that is the greatest SRVT, with either
// detection; the rest of an older pair behind another normal frame is not measured.
TEST_F(Watch, AnInverseFrameBeyondItsLimitIsMeasured)
{
    Verifies(req::SRS_MON_010);
    const auto greatest_us = [](const Network& network, const Frames& frames)
    {
        Analysis analysis(network, [](const Violation&) {});
        for (const LogFrame& frame : frames)
        {
            analysis.Take(frame);
        }
        return analysis.Watches().front().Srvt().greatest / 1000;
    };
    const LogFrame normal = Frame(50000, 0x101U, {1U, 2U});
    for (const Network* const network : {&early, &late})
    {
        EXPECT_EQ(greatest_us(*network, Among({normal, Frame(70001, 0x102U, {0xFEU, 0xFDU})}, 100000)), 20001);
        EXPECT_EQ(greatest_us(*network, Among({normal, Frame(76000, 0x102U, {0xFEU, 0xFDU})}, 100000)), 26000);
        EXPECT_EQ(
            greatest_us(*network,
                        Among({normal, Frame(72000, 0x101U, {1U, 2U}), Frame(74000, 0x102U, {0xFEU, 0xFDU})}, 100000)),
            network == &early ? 2000 : 200);
        EXPECT_EQ(
            greatest_us(*network,
                        Among({normal, Frame(73000, 0x000U, {2U, 1U}), Frame(74000, 0x102U, {0xFEU, 0xFDU})}, 100000)),
            200);
    }
}

TEST_F(Watch, StatisticsAndMargins)
{
    Verifies(req::SRS_MON_010);
    Analysis analysis(early, [](const Violation&) {});
    for (const Time us : {0, 20000, 50000})
    {
        for (const LogFrame& frame : Pair(us, us / 100 + 100))
        {
            analysis.Take(frame);
        }
    }
    const SrdoWatch& watch = analysis.Watches().front();
    EXPECT_EQ(watch.PairCount(), 3U);
    EXPECT_EQ(watch.Cycle().least, 20 * kMillisecond);
    EXPECT_EQ(watch.Cycle().Mean(), 25 * kMillisecond);
    EXPECT_EQ(watch.Cycle().greatest, 30 * kMillisecond);
    EXPECT_EQ(watch.Cycle().limit - watch.Cycle().greatest, 20 * kMillisecond);
    // 20 ms are the end of a bin of 1.25 ms, 30 ms another
    EXPECT_EQ(watch.Cycle().bins.at(15), 1U);
    EXPECT_EQ(watch.Cycle().bins.at(23), 1U);
    EXPECT_EQ(watch.Srvt().least, 100 * kMicrosecond);
    EXPECT_EQ(watch.Srvt().Mean(), 333333);
    EXPECT_EQ(watch.Srvt().greatest, 600 * kMicrosecond);
}
} // namespace
} // namespace counterpoint::monitor
