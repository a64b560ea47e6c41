// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Every conformance case with each channel, then the differential sequences with both: the same on host and target. The
// lines that begin with "run=" must be the same on both. [SRS_TGT_003]
#include "verification/target/conformance/suite.hpp"

#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "verification/conformance/runner.hpp"
#include "verification/differential/differential.hpp"
#include "verification/target/target.hpp"

namespace
{
using counterpoint::kMaxMapEntries;
using counterpoint::kMaxSrdoCount;
using counterpoint::conformance::Failure;
using counterpoint::conformance::Party;
using counterpoint::conformance::Reporter;
using counterpoint::conformance::Runner;
using counterpoint::conformance::RunResult;
using counterpoint::differential::Difference;
using counterpoint::differential::Differential;
using counterpoint::differential::DifferentialResult;
using counterpoint::differential::Observer;
using counterpoint::differential::StepRecord;
using counterpoint::target::Write;
using counterpoint::target::WriteHex;
using counterpoint::target::WriteNumber;

constexpr std::uint32_t kMostPrinted = 20U;
constexpr std::uint32_t kSeed = 1U;

void WriteHex64(std::uint64_t value) noexcept
{
    WriteHex(static_cast<std::uint32_t>(value >> 32U));
    WriteHex(static_cast<std::uint32_t>(value));
}

class FailurePrinter final : public Reporter
{
  public:
    void OnFailure(const Failure& failure) noexcept override
    {
        ++count_;
        if (count_ > kMostPrinted)
        {
            return;
        }
        Write("failed: ");
        Write(failure.case_name);
        Write(" step ");
        WriteNumber(failure.step);
        Write(" origin ");
        WriteHex(failure.origin);
        Write(" ");
        Write(failure.field);
        Write(": expected ");
        WriteHex64(failure.expected);
        Write(", got ");
        WriteHex64(failure.got);
        Write("\n");
    }

  private:
    std::uint32_t count_{0U};
};

class DifferencePrinter final : public Observer
{
  public:
    void OnStep(const StepRecord& /*record*/) noexcept override
    {
    }

    void OnDifference(const Difference& difference) noexcept override
    {
        ++count_;
        if (count_ > kMostPrinted)
        {
            return;
        }
        Write("failed: seed ");
        WriteNumber(difference.seed);
        Write(" sequence ");
        WriteNumber(difference.sequence);
        Write(" step ");
        WriteNumber(difference.step);
        Write(" slot ");
        WriteNumber(difference.slot);
        Write(" ");
        Write(difference.field);
        Write(": A ");
        WriteHex64(difference.a);
        Write(", B ");
        WriteHex64(difference.b);
        Write("\n");
    }

  private:
    std::uint32_t count_{0U};
};

bool Print(const char* run, const RunResult& result) noexcept
{
    Write("run=");
    Write(run);
    Write(" cases=");
    WriteNumber(result.cases);
    Write(" failures=");
    WriteNumber(result.failures);
    Write(" hash=");
    WriteHex(result.hash);
    Write("\n");
    return (result.cases != 0U) && (result.failures == 0U);
}

counterpoint::channel_a::StorageFor<kMaxSrdoCount, kMaxMapEntries> storage_a{};
counterpoint::channel_b::StorageFor<kMaxSrdoCount, kMaxMapEntries> storage_b{};

} // namespace

namespace counterpoint::target
{

std::uint32_t RunSuite(const std::uint32_t sequences) noexcept
{
    static FailurePrinter failure_printer;
    static DifferencePrinter difference_printer;
    static counterpoint::channel_a::Channel channel_a{storage_a.Handle()};
    static counterpoint::channel_b::Channel channel_b{storage_b.Handle()};
    static Runner runner_a{channel_a, Party::kA, failure_printer};
    static Runner runner_b{channel_b, Party::kB, failure_printer};
    bool good = Print("conformance_a", RunConformance(runner_a));
    good = Print("conformance_b", RunConformance(runner_b)) && good;
    static Differential both{channel_a, channel_b, difference_printer};
    const DifferentialResult run = RunDifferential(both, kSeed, 0U, sequences, kMostPrinted);
    Write("differential steps=");
    WriteNumber(static_cast<std::uint32_t>(run.steps));
    Write("\n");
    good = Print("differential", RunResult{run.sequences, run.failures, run.hash}) && good;
    return good ? 0U : 1U;
}

} // namespace counterpoint::target
