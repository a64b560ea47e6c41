// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_PRODUCER_PART_HPP
#define VERIFICATION_DIFFERENTIAL_PRODUCER_PART_HPP

#include "verification/differential/comparison.hpp"
#include "verification/differential/scene.hpp"

#include <cstdint>

namespace counterpoint::differential
{

/// Producers: requests, Prepare, frames and their confirmations, in order and out of it.
class ProducerPart
{
  public:
    ProducerPart(Scene& scene, Comparison& comparison) noexcept : scene_{scene}, compare_{comparison}
    {
    }
    void Step() noexcept;
    /// @brief What the kernel does for the producers that are due.
    void Serve(SrdoMask due, SrdoMask refresh) noexcept;
    /// @brief Nothing of this slot is on its way any more.
    void GiveUp(SlotIndex slot) noexcept
    {
        transmissions_[slot] = Transmission{};
    }

  private:
    /// How far the transmission of one slot has come, as the generator knows it.
    struct Transmission
    {
        CanFrame frame;  ///< Next on the bus; kind kInvalid if none.
        CanFrame normal; ///< Of the last ready Prepare.
    };

    void Prepare(SlotIndex slot) noexcept;
    void ComparePrepared(SlotIndex slot, const PreparedPair& a, const PreparedPair& b) noexcept;
    [[nodiscard]] CanFrame NormalOf(SlotIndex slot, const Payload& data) const noexcept;
    void TakeInverse(SlotIndex slot) noexcept;
    [[nodiscard]] CanFrame InverseOf(SlotIndex slot) const noexcept;
    void Confirm(SlotIndex slot) noexcept;
    void ConfirmBoth(const CanFrame& frame, SlotIndex slot) noexcept;
    void Fail(SlotIndex slot, SrdoCause cause) noexcept;
    void WriteObjects(SlotIndex slot) noexcept;
    void NoteSent(SlotIndex slot) noexcept;
    [[nodiscard]] bool IsHeld(SlotIndex slot, SrdoMask refresh) noexcept;

    Scene& scene_;
    Comparison& compare_;
    Transmission transmissions_[kMaxSrdoCount]{};
};

} // namespace counterpoint::differential

#endif
