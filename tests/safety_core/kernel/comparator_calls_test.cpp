// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/comparator_test_hooks.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{

ComparatorCalls comparator_calls = ComparatorCalls::kReal;

namespace
{

Verdict last_verdict{};

} // namespace

extern "C"
{
    Verdict __real__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE(Comparator* self,
                                                                            const Comparison& comparison);
    PreparedVerdict
    __real__ZN12counterpoint10Comparator15ComparePreparedERKNS_12PreparedPairES3_(const PreparedPair& a,
                                                                                  const PreparedPair& b);

    Verdict __wrap__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE(Comparator* self,
                                                                            const Comparison& comparison)
    {
        if (comparator_calls == ComparatorCalls::kNotCalled)
        {
            return Verdict{};
        }
        if (comparator_calls == ComparatorCalls::kFrozen)
        {
            return last_verdict;
        }
        last_verdict = __real__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE(self, comparison);
        if (comparator_calls == ComparatorCalls::kAlwaysGood)
        {
            last_verdict.fault = DeviceFault::kNone;
        }
        return last_verdict;
    }

    PreparedVerdict __wrap__ZN12counterpoint10Comparator15ComparePreparedERKNS_12PreparedPairES3_(const PreparedPair& a,
                                                                                                  const PreparedPair& b)
    {
        const PreparedVerdict verdict =
            __real__ZN12counterpoint10Comparator15ComparePreparedERKNS_12PreparedPairES3_(a, b);
        return (comparator_calls == ComparatorCalls::kDataUnseen) ? PreparedVerdict::kEqual : verdict;
    }
}

namespace
{

/// Released; test interval 20 ms; the comparator's calls go back to the real ones at the end.
class ComparatorLost : public Rig
{
  public:
    ~ComparatorLost() override
    {
        comparator_calls = ComparatorCalls::kReal;
    }

    /// Cycles until the output is closed, with a good pair every 10 ms so that nothing else closes it.
    std::uint32_t CyclesToSafe(const ComparatorCalls calls)
    {
        Operate();
        ReceivePair();
        Cycle();
        EXPECT_EQ(Open(), 1U);
        comparator_calls = calls;
        std::uint32_t cycles = 0U;
        while ((Open() != 0U) && (cycles < 100U))
        {
            if ((cycles % 10U) == 0U)
            {
                ReceivePair();
            }
            Cycle();
            ++cycles;
        }
        return cycles;
    }
};

TEST_F(ComparatorLost, NotCalledIsSafeInTheSameCycle)
{
    Verifies(req::SRS_CMP_001);
    EXPECT_EQ(CyclesToSafe(ComparatorCalls::kNotCalled), 1U);
    EXPECT_NE(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(ComparatorLost, FrozenAtItsLastVerdictIsSafeInTheSameCycle)
{
    Verifies(req::SRS_CMP_001);
    EXPECT_EQ(CyclesToSafe(ComparatorCalls::kFrozen), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
}

TEST_F(ComparatorLost, AlwaysGoodIsFoundByTheDeliberateDifferenceWithinTheTestInterval)
{
    Verifies(req::SRS_CMP_009);
    EXPECT_LE(CyclesToSafe(ComparatorCalls::kAlwaysGood), 20U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
}

TEST_F(ComparatorLost, BlindForDataIsFoundByTheDeliberateDifferenceWithinTheTestInterval)
{
    Verifies(req::SRS_CMP_009);
    EXPECT_LE(CyclesToSafe(ComparatorCalls::kDataUnseen), 20U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
}

} // namespace
} // namespace counterpoint
