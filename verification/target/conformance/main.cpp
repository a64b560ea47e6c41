// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Every conformance case with each channel, then the differential sequences with both: the same program on host and
// target. The lines that begin with "run=" must be the same on both. [SRS-TGT-003]
#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "verification/conformance/runner.hpp"
#include "verification/target/target.hpp"

namespace
{
using counterpoint::kMaxSrdoCount;
using counterpoint::conformance::Failure;
using counterpoint::conformance::Party;
using counterpoint::conformance::Reporter;
using counterpoint::conformance::Runner;
using counterpoint::conformance::RunResult;
using counterpoint::target::Write;
using counterpoint::target::WriteHex;
using counterpoint::target::WriteNumber;

class Printer final : public Reporter
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
        WriteHex(static_cast<std::uint32_t>(failure.expected >> 32U));
        WriteHex(static_cast<std::uint32_t>(failure.expected));
        Write(", got ");
        WriteHex(static_cast<std::uint32_t>(failure.got >> 32U));
        WriteHex(static_cast<std::uint32_t>(failure.got));
        Write("\n");
    }

  private:
    static constexpr std::uint32_t kMostPrinted = 20U;
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

counterpoint::channel_a::StorageFor<kMaxSrdoCount> storage_a{};
counterpoint::channel_b::StorageFor<kMaxSrdoCount> storage_b{};

} // namespace

extern "C" std::uint32_t TargetMain() noexcept;

extern "C" std::uint32_t TargetMain() noexcept
{
    static Printer printer;
    static counterpoint::channel_a::Channel channel_a{storage_a.Handle()};
    static counterpoint::channel_b::Channel channel_b{storage_b.Handle()};
    static Runner runner_a{channel_a, Party::kA, printer};
    static Runner runner_b{channel_b, Party::kB, printer};
    bool good = Print("conformance_a", RunConformance(runner_a));
    good = Print("conformance_b", RunConformance(runner_b)) && good;
    return good ? 0U : 1U;
}
