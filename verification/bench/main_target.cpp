// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/device.hpp"
#include "verification/bench/items.hpp"
#include "verification/bench/self_tests.hpp"
#include "verification/target/target.hpp"

namespace
{
using counterpoint::bench::BenchResult;

struct RamLine
{
    const char* part;
    std::uint32_t bytes;
};

void WriteRam(const RamLine& line) noexcept
{
    counterpoint::target::Write("ram=");
    counterpoint::target::Write(line.part);
    counterpoint::target::Write(" bytes=");
    counterpoint::target::WriteNumber(line.bytes);
    counterpoint::target::Write("\n");
}
} // namespace

extern "C" std::uint32_t TargetMain() noexcept;

extern "C" std::uint32_t TargetMain() noexcept
{
    WriteRam({"kernel", sizeof(counterpoint::Kernel)});
    WriteRam({"windows", sizeof(counterpoint::CauseWindows) * counterpoint::kMaxSrdoCount});
    WriteRam({"channel_a", sizeof(counterpoint::channel_a::Channel)});
    WriteRam({"storage_a", sizeof(counterpoint::channel_a::StorageFor<counterpoint::kMaxSrdoCount>)});
    WriteRam({"channel_b", sizeof(counterpoint::channel_b::Channel)});
    WriteRam({"storage_b", sizeof(counterpoint::channel_b::StorageFor<counterpoint::kMaxSrdoCount>)});
    counterpoint::target::StartCycles();
    counterpoint::target::RepaintStack();
    BenchResult result = counterpoint::bench::RunItems();
    if (result == BenchResult::kDone)
    {
        result = counterpoint::bench::RunFullLoad();
    }
    if (result == BenchResult::kDone)
    {
        result = counterpoint::bench::MeasureSelfTests();
    }
    counterpoint::target::Write("stack_used=");
    counterpoint::target::WriteNumber(counterpoint::target::StackUsed());
    counterpoint::target::Write("\nbench: ");
    counterpoint::target::Write(counterpoint::bench::NameOf(result));
    counterpoint::target::Write("\n");
    return (result == BenchResult::kDone) ? 0U : 1U;
}
