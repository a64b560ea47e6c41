// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_CONSUMER_PART_HPP
#define VERIFICATION_DIFFERENTIAL_CONSUMER_PART_HPP

#include "verification/differential/comparison.hpp"
#include "verification/differential/cycle_part.hpp"
#include "verification/differential/scene.hpp"

namespace counterpoint::differential
{

/// Frames from the bus: good, wrong, late, out of order, near every limit.
class ConsumerPart
{
  public:
    ConsumerPart(Scene& scene, Comparison& comparison, CyclePart& cycle) noexcept
        : scene_{scene}, compare_{comparison}, cycle_{cycle}
    {
    }
    void Step() noexcept;

  private:
    void GoodPair(SlotIndex slot) noexcept;
    void NormalFrame(SlotIndex slot, const Payload& data) noexcept;
    void InverseFrame(SlotIndex slot, const Payload& data) noexcept;
    void WrongFrame(SlotIndex slot) noexcept;
    void SpoiledPair(SlotIndex slot) noexcept;
    void ScatterBehind(CanFrame& frame) noexcept;
    void Feed(const CanFrame& frame, SlotIndex slot) noexcept;

    Scene& scene_;
    Comparison& compare_;
    CyclePart& cycle_;
};

} // namespace counterpoint::differential

#endif
