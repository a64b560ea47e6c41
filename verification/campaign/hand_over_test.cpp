// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a person sees while a campaign runs, and the command that hands over to its program.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/progress.hpp"

#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <sys/wait.h>
#include <unistd.h>

namespace counterpoint::campaign::test
{
namespace
{
/// Quick, and found at once.
constexpr const char* kQuick = "at: [500 ms]\ncycles: 2\nparts: [flow_monitor]\nkinds: [flip]\n";

using HandOverTest = CampaignTest;

TEST(ProgressTest, TellsPartRateAndTimeLeft)
{
    Verifies(req::SRS_CMG_012);
    // 300 000 of a million after 100 s, of which 100 000 were there before
    EXPECT_EQ(ProgressText(300000U, 1000000U, 100000U, 100.0),
              "campaign 30.0 %, 2000 experiments a second, 350 s left");
    std::ostringstream no_terminal;
    {
        Progress progress(no_terminal, 10U, 0U);
        progress.Show(5U);
    }
    EXPECT_EQ(no_terminal.str(), "");
}

TEST(ProgressTest, IsALineOfATerminalFromTwoSecondsOnThatGoesAtTheEnd)
{
    Verifies(req::SRS_CMG_012);
    // Given a terminal as standard error
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_GE(terminal, 0);
    ASSERT_EQ(::grantpt(terminal) + ::unlockpt(terminal), 0);
    const int line = ::open(::ptsname(terminal), O_RDWR | O_NOCTTY);
    const int before = ::dup(STDERR_FILENO);
    ASSERT_GE(::dup2(line, STDERR_FILENO), 0);
    // When experiments end from 1999 ms on, half a second apart and nearer
    std::chrono::steady_clock::time_point now{};
    {
        Progress progress(std::cerr, 1000U, 0U, [&now] { return now; });
        for (const auto& [ms, done] : {std::pair(1999, 150U), {2000, 200U}, {2499, 240U}, {2500, 250U}})
        {
            now = std::chrono::steady_clock::time_point(std::chrono::milliseconds(ms));
            progress.Show(done);
        }
    }
    ASSERT_GE(::dup2(before, STDERR_FILENO), 0);
    static_cast<void>(::close(line));
    static_cast<void>(::close(before));
    // Then each is a line; nobody has the terminal open, so that reading ends where they end
    std::string text;
    for (char byte = '\0'; ::read(terminal, &byte, 1U) == 1;)
    {
        text += byte;
    }
    static_cast<void>(::close(terminal));
    EXPECT_EQ(text, "\r\033[Kcampaign 20.0 %, 100 experiments a second, 8 s left"
                    "\r\033[Kcampaign 25.0 %, 100 experiments a second, 8 s left"
                    "\r\033[K");
}

TEST_F(HandOverTest, CommandHandsOverToTheProgramBesideIt)
{
    Verifies(req::SRS_CMG_013);
    // Given command lines that hold, that do not, and that are refused
    const std::string plan = PlanFile("plan.yaml", "actuator", kQuick);
    const std::string late = PlanFile("late.yaml", "actuator", std::string(kQuick) + "voices: [channel_b.srvt]\n");
    const auto run = [this](const std::string& line)
    {
        const int status = std::system((line + " > " + Path("out") + " 2> " + Path("err")).c_str());
        return std::to_string(WEXITSTATUS(status)) + "\n" + cia306::ReadTextFile(Path("out")) + "\n" +
               cia306::ReadTextFile(Path("err"));
    };
    for (const auto& [arguments, status] : {std::pair(plan + " --jobs 1", '0'),
                                            {plan + " --replay 3", '0'},
                                            {late + " --jobs 1", '1'},
                                            {Path("none.yaml"), '2'}})
    {
        // Then the program beside it answers, as if it had been called
        const std::string answer = run(std::string(COUNTERPOINT_PROGRAM) + " campaign " + arguments);
        EXPECT_EQ(answer.front(), status) << answer;
        EXPECT_EQ(answer, run(std::string(COUNTERPOINT_CAMPAIGN) + " campaign " + arguments));
    }
}

TEST_F(HandOverTest, WithoutTheProgramBesideItTheCommandSaysSo)
{
    Verifies(req::SRS_CMG_120);
    const std::string plan = PlanFile("plan.yaml", "actuator", kQuick);
    // Given the program alone in a folder
    std::filesystem::copy_file(COUNTERPOINT_PROGRAM, Path("counterpoint"));
    const int status =
        std::system((Path("counterpoint") + " campaign " + plan + " > " + Path("out") + " 2> " + Path("err")).c_str());
    EXPECT_EQ(WEXITSTATUS(status), 2);
    EXPECT_EQ(cia306::ReadTextFile(Path("out")), "");
    EXPECT_EQ(cia306::ReadTextFile(Path("err")), "counterpoint campaign: no program " + Path("counterpoint_campaign") +
                                                     " (No such file or directory), expected it beside this one, as a "
                                                     "build of this tree has it\n");
}
} // namespace
} // namespace counterpoint::campaign::test
