// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_CYCLE_PART_HPP
#define VERIFICATION_DIFFERENTIAL_CYCLE_PART_HPP

#include "verification/differential/comparison.hpp"
#include "verification/differential/producer_part.hpp"
#include "verification/differential/scene.hpp"

#include <cstdint>

namespace counterpoint::differential
{

/// The cycle with what the kernel hands in, then Commit and the permits.
class CyclePart
{
  public:
    CyclePart(Scene& scene, Comparison& comparison, ProducerPart& producer) noexcept
        : scene_{scene}, compare_{comparison}, producer_{producer}
    {
    }
    void Begin() noexcept;
    void Step() noexcept;

  private:
    void Commit(const CycleOutcome& outcome) noexcept;
    void Answer() noexcept;
    void ChooseInputs() noexcept;
    void NoteAccepted(SlotIndex slot) noexcept;
    void NoteRecovery(SlotIndex slot, const SrdoView& view) noexcept;

    Scene& scene_;
    Comparison& compare_;
    ProducerPart& producer_;
    SrdoState states_[kMaxSrdoCount]{}; ///< As of the OnCycle before.
    SrdoCause causes_[kMaxSrdoCount]{}; ///< First causes as of the OnCycle before.
    SrdoMask acknowledge_{0U};
    QueueState queue_{QueueState::kIntact};
    std::uint32_t token_flip_{0U};
    std::uint32_t challenge_{1U};
};

} // namespace counterpoint::differential

#endif
