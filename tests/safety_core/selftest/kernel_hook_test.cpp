// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Self tests in a kernel with both real channels, over their live memory and that of the kernel.
#include "safety_core/selftest/self_test.hpp"

#include "tests/safety_core/kernel/rig.hpp"
#include "tests/safety_core/selftest/device.hpp"
#include "verification/trace/ids/selftest.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace counterpoint
{
namespace
{

using selftest::SelfTest;
using selftest::StartAnswer;

/// Everything that must be there before the kernel is.
struct TestedParts
{
    host::HostMemory cells{};
    host::DefectiveMemory memory{cells};
    selftest::WatchedLock lock{};
    selftest::ProbedOutput probed{};
    SelfTest self_test{selftest::SelfTestPorts{memory, lock, probed}};
};

/// Stands between kernel and self test: leaves it out, repeats its last word, or lets the parts seem unsound.
class SelfTestTap final : public SelfTestPart
{
  public:
    explicit SelfTestTap(SelfTestPart& real) : real_(real)
    {
    }
    SelfTestOutcome OnCycle() noexcept override
    {
        ++calls;
        if (!is_frozen)
        {
            last = real_.OnCycle();
        }
        return last;
    }

    SelfTestOutcome last{};
    std::uint32_t calls{0U};
    bool is_frozen{false};

  private:
    SelfTestPart& real_;
};

struct TappedParts : TestedParts
{
    SelfTestTap tap{self_test};
};

/// The rig of the kernel, with self tests over both channels, the kernel, the configuration and its tables. On the
/// heap: what stands on the running stack is left out.
class TestedDevice : public TappedParts, public Rig
{
  public:
    TestedDevice() : Rig(&tap)
    {
        ram = {SpanOf(&storage_a, sizeof storage_a), SpanOf(&storage_b, sizeof storage_b),
               SpanOf(&real_a, sizeof real_a),       SpanOf(&real_b, sizeof real_b),
               SpanOf(&kernel, sizeof kernel),       SpanOf(stack.data(), sizeof stack)};
        constants = {SpanOf(setups.data(), sizeof setups), SpanOf(objects.data(), sizeof objects),
                     SpanOf(&config, sizeof config)};
        parts = {cells.PlaceOf(&a),        cells.PlaceOf(&b),           cells.PlaceOf(&ports),  cells.PlaceOf(&output),
                 cells.PlaceOf(&watchdog), cells.PlaceOf(&application), cells.PlaceOf(&real_a), cells.PlaceOf(&real_b)};
        setup.parts = {parts.data(), 8U};
        setup.stack = {{cells.PlaceOf(stack.data()), 256U}, 4U};
        setup.program = {{&table_span, 1U}, 32U, selftest::SignatureSource::kTaken, 0U};
        setup.constants = {{constants.data(), 3U}, 32U, selftest::SignatureSource::kTaken, 0U};
        setup.ram = {{ram.data(), 6U}, &workspace, 16U};
        setup.interval_cycles = 2000U;
    }
    void TestBody() override
    {
    }
    hal::MemorySpan SpanOf(const void* const object, const std::size_t bytes) const
    {
        return {cells.PlaceOf(object), static_cast<std::uint32_t>(bytes / 4U)};
    }
    /// Start-up test, then OPERATIONAL with a released SRDO 1.
    void Run()
    {
        report = self_test.Start(setup);
        ASSERT_EQ(report.answer, StartAnswer::kPassed);
        Operate();
        ReceivePair();
        Cycle();
        ASSERT_EQ(Open(), 1U);
        ASSERT_EQ(NormalOut(), 0x3412U);
    }
    /// Cycles with a pair each 10 ms until a device fault; 0 if there is none within the interval.
    std::uint32_t CyclesToFault()
    {
        for (std::uint32_t cycle = 1U; cycle <= report.cycles; ++cycle)
        {
            if ((cycle % 10U) == 0U)
            {
                ReceivePair();
            }
            Cycle();
            if (kernel.DeviceState().fault != DeviceFault::kNone)
            {
                return cycle;
            }
        }
        return 0U;
    }

    alignas(256) std::array<std::uint32_t, 256> stack{};
    std::array<std::uint32_t, 64> table{};
    hal::MemorySpan table_span{SpanOf(table.data(), sizeof table)};
    std::array<hal::MemorySpan, 6> ram{};
    std::array<hal::MemorySpan, 3> constants{};
    std::array<hal::Address, 8> parts{};
    selftest::RamWorkspace workspace{};
    selftest::SelfTestSetup setup{};
    selftest::StartReport report{};
};

class KernelHook : public ::testing::Test
{
  protected:
    void StuckBitIsFound(const void* const object)
    {
        device->Run();
        const hal::Address place = device->cells.PlaceOf(object);
        // A bit is stuck at what it is at this moment: nothing changes yet.
        const bool is_one = (device->cells.Read(place) & 0x80U) != 0U;
        const host::CellDefect stuck = is_one ? host::CellDefect::kStuckAtOne : host::CellDefect::kStuckAtZero;
        device->memory.Break({stuck, {place, 7U}, {place, 7U}});
        EXPECT_NE(device->CyclesToFault(), 0U);
        EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kSelfTest);
        EXPECT_EQ(device->self_test.FirstFailed(), selftest::TestId::kRam);
        EXPECT_EQ(device->Open(), 0U);
    }

    /// Words of the self test that count one further in a cycle.
    static std::vector<std::size_t> CountersOf(TestedDevice& some)
    {
        const hal::Address first = some.cells.PlaceOf(&some.self_test);
        const auto read = [&some, first](const std::size_t word)
        { return some.cells.Read(first + static_cast<hal::Address>(4U * word)); };
        std::array<std::uint32_t, sizeof(SelfTest) / 4U> before{};
        for (std::size_t word = 0U; word < before.size(); ++word)
        {
            before[word] = read(word);
        }
        std::array<bool, sizeof(SelfTest) / 4U> counts{};
        counts.fill(true);
        for (std::uint32_t cycle = 1U; cycle <= 3U; ++cycle)
        {
            some.Cycle();
            for (std::size_t word = 0U; word < before.size(); ++word)
            {
                counts[word] = counts[word] && (read(word) == (before[word] + cycle));
            }
        }
        std::vector<std::size_t> counters;
        for (std::size_t word = 0U; word < before.size(); ++word)
        {
            if (counts[word])
            {
                counters.push_back(word);
            }
        }
        return counters;
    }

    std::unique_ptr<TestedDevice> device{std::make_unique<TestedDevice>()};
};

TEST_F(KernelHook, TestedDeviceWorksThroughManyRounds)
{
    Verifies(req::SRS_STS_063);
    Verifies(req::SRS_STS_012);
    device->Run();
    // When it runs for three intervals, then it is released all the time and no self test disturbs it
    for (std::uint32_t interval = 0U; interval < 3U; ++interval)
    {
        EXPECT_EQ(device->CyclesToFault(), 0U);
        EXPECT_EQ(device->Open(), 1U);
        EXPECT_EQ(device->NormalOut(), 0x3412U);
    }
    EXPECT_TRUE(device->WatchdogAlive());
    EXPECT_EQ(device->self_test.Ram().LeftOut(), 0U);
}

TEST_F(KernelHook, StuckBitInLiveMemoryOfEachPartIsFoundWithinTheInterval)
{
    Verifies(req::SRS_STS_214);
    Verifies(req::SRS_STS_063);
    StuckBitIsFound(&device->storage_a);
    device = std::make_unique<TestedDevice>();
    StuckBitIsFound(&device->storage_b);
    device = std::make_unique<TestedDevice>();
    StuckBitIsFound(&device->kernel);
    device = std::make_unique<TestedDevice>();
    StuckBitIsFound(&device->stack[100]);
}

TEST_F(KernelHook, FlippedByteOfTablesAndConfigurationIsFoundWithinTheInterval)
{
    Verifies(req::SRS_STS_003);
    // Given a table, and the device's own description in memory
    device->Run();
    device->table[63] ^= 0x0100'0000U;
    EXPECT_NE(device->CyclesToFault(), 0U);
    EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kSelfTest);
    EXPECT_EQ(device->self_test.FirstFailed(), selftest::TestId::kProgram);
    EXPECT_EQ(device->Open(), 0U);

    device = std::make_unique<TestedDevice>();
    device->Run();
    device->config.output_time_us ^= 1U;
    EXPECT_NE(device->CyclesToFault(), 0U);
    EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kSelfTest);
    EXPECT_EQ(device->self_test.FirstFailed(), selftest::TestId::kConstants);
    EXPECT_EQ(device->Open(), 0U);
}

TEST_F(KernelHook, FlippedGuardWordClosesTheOutputInTheSameCycle)
{
    Verifies(req::SRS_STS_020);
    Verifies(req::SRS_STS_063);
    device->Run();
    device->stack[3] ^= 1U;
    device->Cycle();
    EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kSelfTest);
    EXPECT_EQ(device->Open(), 0U);
}

TEST_F(KernelHook, FlippedTablePointerIsFoundBeforeThePartIsCalled)
{
    Verifies(req::SRS_STS_040);
    for (std::size_t part = 0U; part < 8U; ++part)
    {
        // Given a released device
        device = std::make_unique<TestedDevice>();
        device->Run();
        const std::uint64_t question = device->watchdog.timer.Question().value;
        const hal::PermitSet permits = device->output.last;
        // When the pointer to the table of one part flips to where nothing is
        const hal::Address place = device->parts[part];
        const std::uint32_t word = device->cells.Read(place);
        device->cells.Write(place, word ^ 0x4000'0000U);
        device->Cycle();
        device->Cycle();
        // Then nobody was called: no permit, no answer; the latch knows, and the output is closed two cycles later
        EXPECT_EQ(device->output.last.kernel.response, permits.kernel.response);
        EXPECT_EQ(device->watchdog.timer.Question().value, question);
        EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kSelfTest) << part;
        EXPECT_EQ(device->Open(), 0U) << part;
        EXPECT_FALSE(device->WatchdogAlive());
        device->cells.Write(place, word);
    }
}

TEST_F(KernelHook, SelfTestThatStandsStillIsFoundInTheSameCycle)
{
    Verifies(req::SRS_STS_213);
    Verifies(req::SRS_STS_062);
    device->Run();
    // When it only repeats what it said last
    device->tap.is_frozen = true;
    device->Cycle();
    // Then the flow is wrong: latched, and the watchdog's answer was wrong too
    EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kFlow);
    EXPECT_FALSE(device->WatchdogAlive());
    device->Cycle();
    EXPECT_EQ(device->Open(), 0U);
}

TEST_F(KernelHook, SelfTestThatIsNotCalledIsFoundInTheSameCycle)
{
    Verifies(req::SRS_STS_213);
    device->Run();
    // When the call is left out, and in the place of its outcome are zeros beside a good word
    device->tap.is_frozen = true;
    device->tap.last = SelfTestOutcome{0U, DeviceFault::kNone, PartsView::kSound};
    device->Cycle();
    // Then the flow is wrong in that cycle, and so was the watchdog's answer
    EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kFlow);
    EXPECT_FALSE(device->WatchdogAlive());
    // When there are zeros alone, then that is a device fault in that cycle, and the watchdog gets no answer
    device = std::make_unique<TestedDevice>();
    device->Run();
    const std::uint64_t question = device->watchdog.timer.Question().value;
    device->tap.is_frozen = true;
    device->tap.last = SelfTestOutcome{};
    device->Cycle();
    EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kSelfTest);
    EXPECT_EQ(device->watchdog.timer.Question().value, question);
}

TEST_F(KernelHook, SelfTestThatRunsTwiceIsFoundInTheSameCycle)
{
    Verifies(req::SRS_STS_213);
    Verifies(req::SRS_STS_062);
    device->Run();
    // When it runs twice in a cycle, or says more than it did
    static_cast<void>(device->self_test.OnCycle());
    device->Cycle();
    EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kFlow);
    EXPECT_FALSE(device->WatchdogAlive());
}

TEST_F(KernelHook, SelfTestThatLeavesAPartOutIsFoundInTheSameCycle)
{
    Verifies(req::SRS_STS_213);
    // Given the words that count the work done on parts, stack and program; the last one is the place in the round
    device->Run();
    std::vector<std::size_t> counters = CountersOf(*device);
    ASSERT_EQ(counters.size(), 4U);
    counters.pop_back();
    for (const std::size_t word : counters)
    {
        // When the work of one of them was not done in a cycle
        device = std::make_unique<TestedDevice>();
        device->Run();
        const hal::Address place = device->cells.PlaceOf(&device->self_test) + static_cast<hal::Address>(4U * word);
        device->cells.Write(place, device->cells.Read(place) - 1U);
        device->Cycle();
        // Then the flow is wrong in that cycle, and so was the watchdog's answer
        EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kFlow) << word;
        EXPECT_FALSE(device->WatchdogAlive()) << word;
    }
}

TEST_F(KernelHook, RefusedStartUpTestNeverReleases)
{
    Verifies(req::SRS_STS_212);
    Verifies(req::SRS_STS_063);
    // Given a device that ignores the refusal
    device->probed.defective = true;
    EXPECT_EQ(device->self_test.Start(device->setup).answer, StartAnswer::kFailed);
    for (std::uint32_t cycle = 0U; cycle < 100U; ++cycle)
    {
        EXPECT_EQ(device->self_test.OnCycle().fault, DeviceFault::kSelfTest) << cycle;
    }
    device->Operate();
    device->ReceivePair();
    device->Cycle();
    EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kSelfTest);
    EXPECT_EQ(device->Open(), 0U);
    // and one that never did it
    device = std::make_unique<TestedDevice>();
    device->Operate();
    device->ReceivePair();
    device->Cycle();
    EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kSelfTest);
    EXPECT_EQ(device->Open(), 0U);
}

TEST_F(KernelHook, KernelWithoutSelfTestIsAsItWas)
{
    Verifies(req::SRS_STS_063);
    // Given a kernel that was given none
    device.reset();
    class Plain final : public Rig
    {
      public:
        void TestBody() override
        {
        }
    };
    const auto plain = std::make_unique<Plain>();
    plain->Operate();
    plain->ReceivePair();
    plain->Cycle();
    EXPECT_EQ(plain->Open(), 1U);
    EXPECT_EQ(plain->kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(KernelHook, SelfTestIsCalledOnceACycleAndItsFaultIsLatched)
{
    Verifies(req::SRS_STS_063);
    device->Run();
    const std::uint32_t calls = device->tap.calls;
    device->Cycles(5U);
    EXPECT_EQ(device->tap.calls - calls, 5U);
    // When it stands still with sound parts and a fault
    device->tap.is_frozen = true;
    device->tap.last = SelfTestOutcome{device->tap.last.progress + 1U, DeviceFault::kSelfTest, PartsView::kSound};
    device->Cycle();
    EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kSelfTest);
    // The flow was right: the watchdog lives
    EXPECT_TRUE(device->WatchdogAlive());
    EXPECT_EQ(device->Open(), 0U);
}

} // namespace
} // namespace counterpoint
