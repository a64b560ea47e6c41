// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/comparator/comparator_self_test.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kCounts = 4U;
// What the test of the comparator alters one by one, besides the guard's view and the number of the cycle. MISRA D-001
constexpr std::uint8_t CycleOutcome::* kCount[kCounts] = {&CycleOutcome::sct_checked, &CycleOutcome::is_tx,
                                                          &CycleOutcome::is_invalid, &CycleOutcome::not_operational};

// One bit of one member; doing it again undoes it.
void Alter(CycleOutcome& outcome, const std::uint32_t number) noexcept
{
    if (number < kCounts)
    {
        outcome.*kCount[number] ^= 1U; // MISRA D-002
    }
    else if (number == kCounts)
    {
        outcome.guard = static_cast<GuardView>(static_cast<std::uint32_t>(outcome.guard) ^ 1U);
    }
    else
    {
        outcome.cycle ^= 1U;
    }
}

} // namespace

void ComparatorSelfTest::Restart(const DeviceConfig& config) noexcept
{
    test_cycles_ = config.test_interval_us / config.cycle_us;
    cycles_to_test_ = test_cycles_;
    number_ = 0U;
}

DeviceFault ComparatorSelfTest::Run(Comparator& comparator, const Comparison& comparison,
                                    CycleOutcome& outcome_b) noexcept
{
    const std::uint32_t number = (number_ > kCounts) ? 0U : (number_ + 1U);
    number_ = static_cast<std::uint8_t>(number);
    Alter(outcome_b, number);
    const DeviceFault fault = comparator.Compare(comparison).fault;
    Alter(outcome_b, number);
    PreparedPair pairs[2]{};           // MISRA D-001
    pairs[1].normal.data[number] = 1U; // MISRA D-002
    const PreparedVerdict data = Comparator::ComparePrepared(pairs[0], pairs[1]);
    const bool is_blind = (fault == DeviceFault::kNone) || (data != PreparedVerdict::kNotInverse);
    return is_blind ? DeviceFault::kComparator : DeviceFault::kNone;
}

} // namespace counterpoint
