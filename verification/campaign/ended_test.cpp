// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Processes of a campaign that somebody else ends, and files of results that have no room or that nobody may write.
#include "verification/campaign/campaign_rig.hpp"

#include "canopen/cia306/text/text_file.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace counterpoint::campaign::test
{
namespace
{
constexpr const char* kMixed = "at: [500 ms]\ncycles: 2\nsample: 20\n";

/// Its first one. 0: there is none.
pid_t ChildOf(const pid_t process)
{
    std::ifstream children("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children");
    pid_t child = 0;
    children >> child;
    return child;
}

/// The process that has no child of its own: it tries the fault. 0: there is none.
pid_t LeafOf(const pid_t process)
{
    pid_t leaf = process;
    for (pid_t child = process; child > 0; leaf = child)
    {
        child = ChildOf(leaf);
        if (child <= 0)
        {
            break;
        }
    }
    return (leaf == process) ? 0 : leaf;
}

class EndedTest : public CampaignTest
{
  protected:
    /// Runs a campaign of one process at a time in a process of its own. Whoever tries a fault is killed when `is_due`
    /// says so. The status of the campaign.
    [[nodiscard]] static int Disturbed(const std::vector<std::string>& arguments, const std::string& err,
                                       const std::function<bool()>& is_due)
    {
        const pid_t campaign = fork();
        if (campaign == 0)
        {
            const tools::test::Answer answer = Campaign(arguments);
            std::ofstream(err) << answer.err;
            _exit(answer.status);
        }
        int status = 0;
        while (waitpid(campaign, &status, WNOHANG) == 0)
        {
            const pid_t leaf = is_due() ? LeafOf(campaign) : 0;
            if (leaf > 0)
            {
                kill(leaf, SIGKILL);
            }
            std::this_thread::sleep_for(std::chrono::microseconds{20});
        }
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /// Runs a campaign as Disturbed does; of those who try a fault, up to `most` are ended as by an error of their own
    /// program. The status of the campaign.
    [[nodiscard]] static int Broken(const std::vector<std::string>& arguments, const std::string& out, int most)
    {
        const pid_t campaign = fork();
        if (campaign == 0)
        {
            const tools::test::Answer answer = Campaign(arguments);
            std::ofstream(out) << answer.out;
            _exit(answer.status);
        }
        int status = 0;
        while (waitpid(campaign, &status, WNOHANG) == 0)
        {
            const pid_t worker = ChildOf(campaign);
            const pid_t trial = (worker > 0 && most > 0) ? ChildOf(worker) : 0;
            if (trial > 0)
            {
                kill(trial, SIGSEGV);
                --most;
            }
            std::this_thread::sleep_for(std::chrono::microseconds{20});
        }
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /// Whether `step` more outcomes are in the file of results, at most ten times.
    [[nodiscard]] std::function<bool()> WhenItGrows(const std::string& file, const std::size_t step) const
    {
        return [path = Path(file), step, next = step, left = 10]() mutable
        {
            std::ifstream in(path, std::ios::binary);
            in.seekg(48);
            std::size_t count = 0U;
            for (std::array<char, 8U> outcome{}; in.read(outcome.data(), outcome.size());)
            {
                count += (outcome[0] != 0) ? 1U : 0U;
            }
            const bool is_due = count >= next && left > 0;
            next = is_due ? count + step : next;
            left -= is_due ? 1 : 0;
            std::this_thread::sleep_for(std::chrono::milliseconds{is_due ? 1 : 0}); // The next fault is being tried.
            return is_due;
        };
    }
};

TEST_F(EndedTest, FaultWhoseProcessIsKilledFromOutsideIsTriedAgain)
{
    Verifies(req::SRS_CMG_170);
    Verifies(req::SRS_CMG_008);
    // Given a campaign that nobody disturbs
    const std::string plan = PlanFile("plan.yaml", "actuator", kMixed);
    const tools::test::Answer whole = Campaign({plan, "--jobs", "1", "--out", Path("whole")});
    // When the process that tries faults is killed ten times, as a system without memory does
    const int status =
        Disturbed({plan, "--jobs", "1", "--out", Path("disturbed")}, Path("err"), WhenItGrows("disturbed", 40U));
    // Then no fault is told as safe by exception for that: the bytes are the same
    EXPECT_EQ(status, whole.status);
    EXPECT_EQ(cia306::ReadTextFile(Path("disturbed")), cia306::ReadTextFile(Path("whole")));
    EXPECT_EQ(cia306::ReadTextFile(Path("err")), "");
}

TEST_F(EndedTest, FaultWhoseProcessIsKilledEachTimeEndsTheCampaign)
{
    Verifies(req::SRS_CMG_170);
    // When each process that tries faults is killed at once
    const std::string plan = PlanFile("plan.yaml", "actuator", kMixed);
    const int status = Disturbed({plan, "--jobs", "1", "--out", Path("results")}, Path("err"), []() { return true; });
    // Then the third time of a fault is told, and what was tried can be gone on with
    EXPECT_EQ(status, 2);
    const std::string err = cia306::ReadTextFile(Path("err"));
    EXPECT_EQ(err.rfind("counterpoint campaign: error: experiment ", 0U), 0U) << err;
    EXPECT_NE(err.find(": its process was ended 3 times from outside (signal 9), expected that it may run until its "
                       "end; what was tried stays in the file of --out\n"),
              std::string::npos)
        << err;
    static_cast<void>(Campaign({plan, "--jobs", "1", "--out", Path("whole")}));
    static_cast<void>(Campaign({plan, "--jobs", "1", "--out", Path("results")}));
    EXPECT_EQ(cia306::ReadTextFile(Path("results")), cia306::ReadTextFile(Path("whole")));
}

TEST_F(EndedTest, FaultOfANetworkWhoseProcessIsKilledFromOutsideIsTriedAgain)
{
    Verifies(req::SRS_CMG_171);
    // Given forty frames of the start of three safety slaves that are lost
    const std::string plan =
        File("plan.yaml", "title: A test\nnetwork: " COUNTERPOINT_SOURCE_FOLDER
                          "/examples/campaigns/managed.yaml\nuntil: 60 ms\nparts: [sdo]\nkinds: [lost]\nsample: 40\n");
    const tools::test::Answer whole = Campaign({plan, "--jobs", "1", "--out", Path("whole")});
    EXPECT_EQ(whole.status, 0) << whole.out;
    // When processes that try one are killed
    const int status =
        Disturbed({plan, "--jobs", "1", "--out", Path("disturbed")}, Path("err"), WhenItGrows("disturbed", 3U));
    // Then none is told as silent for that
    EXPECT_EQ(status, 0);
    EXPECT_EQ(cia306::ReadTextFile(Path("disturbed")), cia306::ReadTextFile(Path("whole")));
}

TEST_F(EndedTest, ProgramOfANetworkThatEndsByTheFaultIsWrong)
{
    Verifies(req::SRS_CMG_217);
    // Given forty lost frames that are found, as above, and up to twenty of which the program ends by an access of its
    // own to memory that it does not have
    const std::string plan =
        File("plan.yaml", "title: A test\nnetwork: " COUNTERPOINT_SOURCE_FOLDER
                          "/examples/campaigns/managed.yaml\nuntil: 60 ms\nparts: [sdo]\nkinds: [lost]\nsample: 40\n");
    const int status = Broken({plan, "--jobs", "1", "--csv", Path("rows.csv")}, Path("out"), 20);
    // Then that is silent, with its reason
    EXPECT_EQ(status, 1);
    const std::string out = cia306::ReadTextFile(Path("out"));
    EXPECT_NE(out.find("silent: experiment "), std::string::npos) << out;
    EXPECT_NE(out.find("the program ended"), std::string::npos) << out;
    EXPECT_NE(cia306::ReadTextFile(Path("rows.csv")).find(",silent,"), std::string::npos);
}

TEST_F(EndedTest, SignalsOfTheProcessorAreNotFromOutside)
{
    Verifies(req::SRS_CMG_170);
    const auto ended = [](const int signal)
    {
        const pid_t child = fork();
        if (child == 0)
        {
            std::signal(signal, SIG_DFL);
            static_cast<void>(raise(signal));
            _exit(0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        return IsEndFromOutside(status);
    };
    for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGTRAP})
    {
        EXPECT_FALSE(ended(signal)) << signal;
    }
    for (const int signal : {SIGKILL, SIGTERM, SIGINT, SIGHUP})
    {
        EXPECT_TRUE(ended(signal)) << signal;
    }
    EXPECT_FALSE(IsEndFromOutside(0)); // It ended by itself.
}

TEST_F(EndedTest, RoomForAllResultsIsTakenBeforeTheFirstOne)
{
    Verifies(req::SRS_CMG_172);
    // Given a file of 100 000 outcomes, none of which is there yet
    const Results results(Path("results"), {1U, 100000U, {}});
    // Then the file system has kept the room for each of them
    struct stat known = {};
    ASSERT_EQ(stat(Path("results").c_str(), &known), 0);
    EXPECT_EQ(known.st_size, 800048);
    EXPECT_GE(known.st_blocks * 512, known.st_size);
}

TEST_F(EndedTest, FileOfResultsWithoutRoomIsRefused)
{
    Verifies(req::SRS_CMG_172);
    // Given room for files of 4096 bytes, and a plan of 800 experiments
    const std::string plan = PlanFile("plan.yaml", "actuator", kMixed);
    const pid_t child = fork();
    if (child == 0)
    {
        const rlimit small{4096U, 4096U};
        std::signal(SIGXFSZ, SIG_IGN);
        const tools::test::Answer answer = (setrlimit(RLIMIT_FSIZE, &small) == 0)
                                               ? Campaign({plan, "--jobs", "1", "--out", Path("results")})
                                               : tools::test::Answer{};
        std::ofstream(Path("err")) << answer.err;
        _exit(answer.status);
    }
    int status = 0;
    waitpid(child, &status, 0);
    // Then that is told before anything is tried, and the file takes none
    EXPECT_EQ(WEXITSTATUS(status), 2);
    EXPECT_EQ(cia306::ReadTextFile(Path("err")), Path("results") + ": error: no room for its 6448 bytes (File too "
                                                                   "large), expected a file system with room for "
                                                                   "them\n");
    EXPECT_EQ(cia306::ReadTextFile(Path("results")), "");
}

TEST_F(EndedTest, ResultsThatNobodyMayWriteAreJoined)
{
    Verifies(req::SRS_CMG_173);
    // Given a shard in a file that is sealed: not even root may write it
    const ResultsOf of{7U, 4U, {1U, 2U}};
    {
        Results shard(Path("shard"), of);
        shard.Put(0U, {Class::kMasked, Detector::kNobody, 0U, 0U, 0U});
        shard.Put(1U, {Class::kDetected, Detector::kGuard, 3U, 0U, 1234U});
    }
    const std::string bytes = cia306::ReadTextFile(Path("shard"));
    const int sealed = memfd_create("shard", MFD_ALLOW_SEALING);
    ASSERT_EQ(write(sealed, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    ASSERT_EQ(fcntl(sealed, F_ADD_SEALS, F_SEAL_WRITE), 0);
    // When it is joined
    Results all("", {7U, 4U, {}});
    all.Merge("/proc/self/fd/" + std::to_string(sealed));
    close(sealed);
    // Then its outcomes are there
    EXPECT_EQ(all.At(0U).result, Class::kMasked);
    EXPECT_EQ(all.At(2U).detector, Detector::kGuard);
    EXPECT_EQ(all.At(2U).us, 1234U);
    EXPECT_EQ(all.OpenCount(), 2U);
    // And one that is not there is told by its name
    EXPECT_THROW(all.Merge(Path("nothing")), runtime::YamlError);
}
} // namespace
} // namespace counterpoint::campaign::test
