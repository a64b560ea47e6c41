// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_TOLD_HPP
#define SIMULATOR_FAULTS_TOLD_HPP

#include "simulator/faults/part_faults.hpp"

namespace counterpoint::simulator
{
/// @brief What a call of a part that runs or does not run answers now. One that is always good has an effect by it.
[[nodiscard]] inline PartAnswer EffectiveAnswerOf(PartFaults& faults, const Part part) noexcept
{
    const PartAnswer answer = faults.AnswerOf(part);
    if (answer == PartAnswer::kGood)
    {
        faults.HasEffect(faults.Condition(part));
    }
    return answer;
}

/// @brief What the part says: by itself (`real`), or by its fault. `last` keeps what it said by itself.
template <typename Said, typename Real, typename Good>
[[nodiscard]] Said Told(const PartAnswer answer, Said& last, const Real& real, const Good& good) noexcept
{
    switch (answer)
    {
    case PartAnswer::kOwn:
        last = real();
        return last;
    case PartAnswer::kLast:
        return last;
    case PartAnswer::kZero:
        return Said{};
    case PartAnswer::kGood:
        break;
    }
    return good();
}
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_TOLD_HPP
