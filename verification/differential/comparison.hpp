// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_COMPARISON_HPP
#define VERIFICATION_DIFFERENTIAL_COMPARISON_HPP

#include "verification/conformance/hash.hpp"
#include "verification/differential/scene.hpp"

#include <cstdint>

namespace counterpoint::differential
{

/// A value in which the channels differ. `step` counts from 1 within its sequence.
struct Difference
{
    const char* field;
    std::uint64_t a;
    std::uint64_t b;
    std::uint32_t seed;
    std::uint32_t sequence;
    std::uint32_t step;
    SlotIndex slot;
};

/// One step, told only when asked for: what it was, and its arguments (which ones, the name says).
struct StepRecord
{
    const char* name;
    std::uint32_t step;
    std::uint32_t slot;
    std::uint64_t x;
    std::uint64_t y;
    std::uint64_t z;
};

class Observer
{
  public:
    virtual void OnStep(const StepRecord& record) noexcept = 0;
    virtual void OnDifference(const Difference& difference) noexcept = 0;

    Observer(const Observer&) = delete;
    Observer& operator=(const Observer&) = delete;

  protected:
    Observer() noexcept = default;
    ~Observer() noexcept = default;
};

/// Compares what both channels say in each step, and tells the first difference of a sequence.
class Comparison
{
  public:
    Comparison(Scene& scene, Observer& observer) noexcept : scene_{scene}, observer_{observer}
    {
    }
    /// @brief Whether the observer hears of every step.
    void Tell(bool is_told) noexcept
    {
        is_told_ = is_told;
    }
    /// @brief One channel is driven alone, in both places: no difference ends a sequence or is told.
    void Ignore() noexcept
    {
        is_ignored_ = true;
    }
    void Begin(std::uint32_t seed, std::uint32_t sequence) noexcept;
    void Step(const char* name, SlotIndex slot, std::uint64_t x, std::uint64_t y, std::uint64_t z) noexcept;
    void Same(const char* field, SlotIndex slot, std::uint64_t a, std::uint64_t b) noexcept;
    void Frames(SlotIndex slot, const CanFrame& a, const CanFrame& b) noexcept;
    void Slot(SlotIndex slot) noexcept;
    void AllSlots() noexcept;
    void Objects(SlotIndex slot) noexcept;
    void Outcomes(const CycleOutcome& a, const CycleOutcome& b) noexcept;
    /// @brief In this sequence.
    [[nodiscard]] bool Differs() const noexcept
    {
        return differs_;
    }
    [[nodiscard]] std::uint32_t Steps() const noexcept
    {
        return step_;
    }
    /// @brief Of all values compared so far.
    [[nodiscard]] std::uint32_t HashValue() const noexcept
    {
        return hash_.Value();
    }

  private:
    void View(SlotIndex slot) noexcept;
    void Held(SlotIndex slot) noexcept;
    void Pair(SlotIndex slot, std::uint32_t at, std::uint32_t bits) noexcept;

    Scene& scene_;
    Observer& observer_;
    conformance::Hash hash_{};
    std::uint32_t seed_{0U};
    std::uint32_t sequence_{0U};
    std::uint32_t step_{0U};
    bool is_told_{false};
    bool is_ignored_{false};
    bool differs_{false};
};

} // namespace counterpoint::differential

#endif
