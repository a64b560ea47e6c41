// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/self_test.hpp"

#include "hal/host/program_image.hpp"

#include <algorithm>
#include <array>

namespace counterpoint::runtime
{
namespace
{
using selftest::SignatureSource;
using selftest::TestId;

/// What the loop of a node may use of the stack: far more than it does.
constexpr std::uint32_t kStackWords = 256U * 1024U / hal::kWordBytes;
constexpr std::uint8_t kGuardWords = 8U;
/// Where a round has a choice, a signature gets slices no longer than this.
constexpr std::uint16_t kMostSignatureWords = 0xFFFFU;

struct TestName
{
    TestId test;
    const char* name;
};
constexpr std::array<TestName, 8U> kTestNames{{{TestId::kInvalid, "self test that never started"},
                                               {TestId::kParts, "parts"},
                                               {TestId::kStack, "stack guard"},
                                               {TestId::kProgram, "program"},
                                               {TestId::kConstants, "constants"},
                                               {TestId::kRam, "RAM"},
                                               {TestId::kPermits, "permits"},
                                               {TestId::kSchedule, "schedule"}}};

selftest::SpanList ListOf(const std::vector<hal::MemorySpan>& spans)
{
    return {spans.data(), static_cast<std::uint8_t>(spans.size())};
}

/// One pass by a signature of its own.
std::uint32_t ValueOf(const selftest::SpanList& memory, const hal::MemoryAccess& cells)
{
    selftest::MemorySignature signature;
    signature.Restart({memory, kMostSignatureWords, SignatureSource::kTaken, 0U});
    for (std::uint32_t slice = signature.SlicesAPass(); slice > 0U; --slice)
    {
        static_cast<void>(signature.Slice(cells));
    }
    return signature.Value();
}

std::uint64_t WordsOf(const std::vector<hal::MemorySpan>& spans)
{
    std::uint64_t words = 0U;
    for (const hal::MemorySpan& span : spans)
    {
        words += span.words;
    }
    return words;
}
} // namespace

NodeSelfTest::NodeSelfTest(const hal::SafetyOutput& output) noexcept : self_test_({memory_, lock_, output})
{
}

void NodeSelfTest::AddChannel(runtime::OwnedChannel& channel)
{
    AddPart(&channel.Voice());
    live_.push_back({memory_.PlaceOf(channel.Bytes()), static_cast<std::uint32_t>(channel.Size() / hal::kWordBytes)});
    live_.push_back(
        {memory_.PlaceOf(&channel.Voice()), static_cast<std::uint32_t>(channel.VoiceSize() / hal::kWordBytes)});
}

void NodeSelfTest::AddKernel(Kernel& kernel)
{
    live_.push_back({memory_.PlaceOf(&kernel), sizeof kernel / hal::kWordBytes});
}

void NodeSelfTest::AddConstants(const DeviceConfig& config, const runtime::DeviceModel& model)
{
    const auto add = [this](const void* const first, const std::size_t size)
    {
        if (size >= hal::kWordBytes)
        {
            constants_.push_back({memory_.PlaceOf(first), static_cast<std::uint32_t>(size / hal::kWordBytes)});
        }
    };
    add(&config, sizeof config);
    add(config.srdos, config.srdo_count * sizeof(SrdoSetup));
    add(config.objects, config.object_count * sizeof(MappableObject));
    for (const runtime::StaticTable& table : model.StaticTables())
    {
        add(table.entries.data(), table.count * sizeof(std::uint32_t));
    }
}

void NodeSelfTest::AddPart(const void* const part)
{
    parts_.push_back(memory_.PlaceOf(part));
}

std::uint32_t NodeSelfTest::RoundSlices()
{
    selftest::MemorySignature program;
    selftest::MemorySignature constants;
    selftest::RamTest ram;
    program.Restart(setup_.program);
    constants.Restart(setup_.constants);
    ram.Restart(setup_.ram);
    const std::uint32_t once = program.SlicesAPass() + constants.SlicesAPass() + ram.SlicesAPass({memory_, lock_}) +
                               selftest::PermitTest::kSlicesAPass;
    return once + std::max(program.SlicesAPass(), constants.SlicesAPass());
}

bool NodeSelfTest::Fits(const std::uint8_t ram_words, const std::uint16_t signature_words,
                        const std::uint32_t interval_cycles)
{
    setup_.program.slice_words = signature_words;
    setup_.constants.slice_words = signature_words;
    setup_.ram.slice_words = ram_words;
    return RoundSlices() <= interval_cycles;
}

bool NodeSelfTest::Settle(const std::uint32_t interval_cycles)
{
    program_ = host::ReadOnlyImage();
    const hal::Address low = memory_.StackPosition() - hal::Address{kStackWords} * hal::kWordBytes;
    setup_.stack = {{low - low % hal::kWordBytes, kStackWords}, kGuardWords};
    setup_.parts = {parts_.data(), static_cast<std::uint8_t>(parts_.size())};
    setup_.program = {ListOf(program_), 0U, SignatureSource::kGiven, ValueOf(ListOf(program_), memory_)};
    setup_.constants = {ListOf(constants_), 0U, SignatureSource::kGiven, ValueOf(ListOf(constants_), memory_)};
    setup_.ram = {ListOf(live_), &workspace_, 0U};
    setup_.interval_cycles = interval_cycles;
    // The smallest slices of RAM that leave signatures room, then the smallest slices of those.
    std::uint8_t ram_words = selftest::kMinRamSliceWords;
    while (ram_words < selftest::kMaxRamSliceWords && !Fits(ram_words, kMostSignatureWords / 16U, interval_cycles))
    {
        ++ram_words;
    }
    std::uint32_t low_words = 1U;
    std::uint32_t high_words = kMostSignatureWords;
    while (low_words < high_words)
    {
        const std::uint32_t middle = (low_words + high_words) / 2U;
        const bool fits = Fits(ram_words, static_cast<std::uint16_t>(middle), interval_cycles);
        high_words = fits ? middle : high_words;
        low_words = fits ? low_words : middle + 1U;
    }
    return Fits(ram_words, static_cast<std::uint16_t>(high_words), interval_cycles);
}

void NodeSelfTest::Start()
{
    static_cast<void>(self_test_.Start(setup_));
}

std::string NodeSelfTest::Failure() const
{
    const TestId failed = self_test_.FirstFailed();
    const auto found = std::find_if(kTestNames.begin(), kTestNames.end(),
                                    [failed](const TestName& each) { return each.test == failed; });
    return (found == kTestNames.end()) ? "" : found->name;
}

std::string NodeSelfTest::Text() const
{
    return std::to_string(WordsOf(program_) * hal::kWordBytes / 1024U) + " KiB of program, " +
           std::to_string(WordsOf(live_) * hal::kWordBytes) + " bytes of channels and kernel, every " +
           std::to_string(setup_.interval_cycles) + " cycles";
}
} // namespace counterpoint::runtime
