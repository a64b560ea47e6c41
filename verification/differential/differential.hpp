// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_DIFFERENTIAL_HPP
#define VERIFICATION_DIFFERENTIAL_DIFFERENTIAL_HPP

#include "safety_core/contract/channel.hpp"
#include "verification/conformance/hash.hpp"
#include "verification/differential/device.hpp"
#include "verification/differential/random.hpp"
#include "verification/differential/reached.hpp"

#include <cstdint>

/// Random devices and sequences, fed to both channels and compared after every step. Freestanding. [SRS_CNF_010]
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

/// Result of a run; `failures` are sequences with a difference.
struct DifferentialResult
{
    std::uint32_t sequences;
    std::uint32_t failures;
    std::uint64_t steps;
    std::uint32_t hash;
};

/// Owns the random devices (some 100 KB): make it static where the stack is small.
class Differential
{
  public:
    Differential(Channel& a, Channel& b, Observer& observer) noexcept;
    /// @brief Sequence `number` of `seed`, which depends on nothing else. True if the channels agreed in every step.
    bool RunSequence(std::uint32_t seed, std::uint32_t number) noexcept;
    /// @brief Whether the observer hears of every step.
    void Tell(bool is_told) noexcept
    {
        is_told_ = is_told;
    }
    [[nodiscard]] const Reached& Seen() const noexcept
    {
        return reached_;
    }
    [[nodiscard]] DifferentialResult Result() const noexcept
    {
        return DifferentialResult{sequences_, failures_, steps_, hash_.Value()};
    }

  private:
    /// How far the transmission of one slot has come, as the generator knows it.
    struct Transmission
    {
        CanFrame frame;  ///< Next on the bus; kind kInvalid if none.
        CanFrame normal; ///< Of the last ready Prepare.
    };

    // differential.cpp
    void StartSequence() noexcept;
    void Step(const char* name, SlotIndex slot, std::uint64_t x, std::uint64_t y, std::uint64_t z) noexcept;
    void Same(const char* field, SlotIndex slot, std::uint64_t a, std::uint64_t b) noexcept;
    void CompareView(SlotIndex slot) noexcept;
    void CompareHeld(SlotIndex slot) noexcept;
    void CompareSlot(SlotIndex slot) noexcept;
    void CompareAllSlots() noexcept;
    void SameFrame(SlotIndex slot, const CanFrame& a, const CanFrame& b) noexcept;
    void CompareObjects(SlotIndex slot) noexcept;
    void ComparePair(SlotIndex slot, std::uint32_t at, std::uint32_t bits) noexcept;
    void CompareOutcomes(const CycleOutcome& a, const CycleOutcome& b) noexcept;
    void NoteRecovery(SlotIndex slot, const SrdoView& view) noexcept;
    [[nodiscard]] SlotIndex AnySlot() noexcept;

    // configure.cpp
    void Configure() noexcept;
    void Reconfigure() noexcept;
    void StoreSlot(SlotIndex slot) noexcept;
    void StoreBoth(SlotIndex slot, ConfigField field, std::uint8_t sub, std::uint32_t value) noexcept;
    void LoadBoth() noexcept;
    void ValidateSlot(SlotIndex slot) noexcept;
    [[nodiscard]] CheckResult ValidateBoth(SlotIndex slot) noexcept;
    void RecheckBoth(SlotIndex slot) noexcept;
    void RegisterFields(SlotIndex slot) noexcept;
    void RegisterBoth(SlotIndex slot, std::uint32_t normal_at, std::uint32_t inverse_at) noexcept;
    void DigestBoth() noexcept;

    // consume.cpp
    void ConsumerStep() noexcept;
    void GoodPair(SlotIndex slot) noexcept;
    void NormalFrame(SlotIndex slot, const Payload& data) noexcept;
    void InverseFrame(SlotIndex slot, const Payload& data) noexcept;
    void WrongFrame(SlotIndex slot) noexcept;
    void SpoiledPair(SlotIndex slot) noexcept;
    void ScatterBehind(CanFrame& frame) noexcept;
    void NoteAccepted(SlotIndex slot) noexcept;
    void Feed(const CanFrame& frame, SlotIndex slot) noexcept;
    [[nodiscard]] CanFrame FrameOf(SlotIndex slot, bool is_inverse, const Payload& data) const noexcept;
    [[nodiscard]] Payload AnyData() noexcept;
    void LetTimePass(std::uint32_t most_us) noexcept;
    void GoNear(SlotIndex slot) noexcept;

    // cycle.cpp
    void CycleStep() noexcept;
    void CommitStep(const CycleOutcome& outcome) noexcept;
    void AnswerStep() noexcept;
    void ChooseInputs() noexcept;

    // produce.cpp
    void ProducerStep() noexcept;
    void Serve(SrdoMask due) noexcept;
    void PrepareBoth(SlotIndex slot) noexcept;
    void ComparePrepared(SlotIndex slot, const PreparedPair& a, const PreparedPair& b) noexcept;
    [[nodiscard]] CanFrame NormalOf(SlotIndex slot, const Payload& data) const noexcept;
    void TakeInverse(SlotIndex slot) noexcept;
    [[nodiscard]] CanFrame InverseOf(SlotIndex slot) const noexcept;
    void Confirm(SlotIndex slot) noexcept;
    void ConfirmBoth(const CanFrame& frame, SlotIndex slot) noexcept;
    void FailBoth(SlotIndex slot, SrdoCause cause) noexcept;
    void WriteObjects(SlotIndex slot) noexcept;
    void NoteSent(SlotIndex slot) noexcept;

    Channel& a_;
    Channel& b_;
    Observer& observer_;
    Random random_{};
    Device device_{};
    Reached reached_{};
    conformance::Hash hash_{};
    Transmission transmissions_[kMaxSrdoCount]{};
    SrdoState states_[kMaxSrdoCount]{};      ///< As of the OnCycle before.
    SrdoCause causes_[kMaxSrdoCount]{};      ///< First causes as of the OnCycle before.
    std::uint32_t last_us_[kMaxSrdoCount]{}; ///< Stamp of the latest normal frame.
    SrdoMask acknowledge_{0U};
    SrdoMask request_{0U};    ///< For the next OnCycle.
    SrdoMask stand_{0U};      ///< For the next OnCycle.
    SrdoMask configured_{0U}; ///< Slots whose last Validate found no fault.
    NmtState nmt_{NmtState::kPreOperational};
    QueueState queue_{QueueState::kIntact};
    std::uint32_t token_flip_{0U};
    std::uint32_t challenge_{1U};
    std::uint32_t clock_us_{0U}; ///< Time on the bus: never behind `now_us_`.
    std::uint32_t now_us_{0U};   ///< Of the last OnCycle.
    std::uint32_t seed_{0U};
    std::uint32_t sequence_{0U};
    std::uint32_t step_{0U};
    std::uint32_t sequences_{0U};
    std::uint32_t failures_{0U};
    std::uint64_t steps_{0U};
    std::uint8_t configuration_valid_{0U};
    bool is_told_{false};
    bool differs_{false};
    bool has_odd_mapping_{false};
};

/// @brief `count` sequences from `first` on; stops after `most_failures` sequences with a difference.
[[nodiscard]] DifferentialResult RunDifferential(Differential& run, std::uint32_t seed, std::uint32_t first,
                                                 std::uint32_t count, std::uint32_t most_failures) noexcept;

} // namespace counterpoint::differential

#endif
