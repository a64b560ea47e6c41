// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_FEED_HPP
#define VERIFICATION_CAMPAIGN_FEED_HPP

#include "safety_core/kernel/kernel.hpp"
#include "verification/campaign/commands.hpp"
#include "verification/campaign/course.hpp"
#include "verification/campaign/surroundings.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace counterpoint::campaign
{
class CallFaults;

/// A mapped pair of variables of the device under test.
struct FlatPair
{
    VariablePlace normal{};
    VariablePlace inverse{};
    ObjectAddress address{0U, 0U};
    SlotIndex slot{kNoSlot};
    std::uint32_t first_bit{0U}; ///< In the data of the SRDO.
    bool is_consumer{false};
    std::uint16_t asked_as{0U}; ///< By which its provider is called for it; 0: the application writes in each cycle.
};

class Feed;

/// Where values go that the application senses. Of two CPUs each has a side.
struct InputTarget
{
    const Feed* source{nullptr};
    const std::vector<FlatPair>* pairs{nullptr};
    std::size_t cycle{0U};
    bool has_normal{true};
    bool has_inverse{true};
};

/// What the application senses and the device under test reads, bit by bit. [SRS_CMG_025]
struct InputBit
{
    bool is_acknowledge{false};
    bool is_second{false}; ///< Of the second path: channel B, the inverse object.
    std::size_t index{0U}; ///< The slot of an acknowledge, or the pair in Device::Pairs().
    std::uint8_t bit{0U};
};

/// Hands to a kernel what its device receives, with a fault of that. Nothing of it lies in the region.
/// [SRS_CMG_020, SRS_CMG_022]
class Feed
{
  public:
    /// @brief The recording outlives it.
    explicit Feed(const Recording& recording);
    ~Feed();
    Feed(const Feed&) = delete;
    Feed& operator=(const Feed&) = delete;

    /// @brief Of these pairs a bit can be stuck.
    void TakeInputs(const std::vector<FlatPair>& pairs);
    /// @brief All is as before this cycle; from there on it has this fault, unless that is of memory. Null: none. `end`
    /// is the cycle behind the last one of the run.
    void Rewind(std::size_t cycle, const Experiment* fault, std::size_t end, std::uint64_t seed);
    /// @brief Whether behind this cycle all comes as recorded.
    [[nodiscard]] bool IsUndisturbed(std::size_t cycle) const;

    void BeginCycle() noexcept
    {
        handed_.clear();
    }
    [[nodiscard]] Calls CallsIn(const std::size_t cycle) const
    {
        return course_.CallsIn(cycle);
    }
    /// @brief What comes before all frames: calls that were late, and commands.
    void BeginCall(std::size_t cycle, Kernel& kernel);
    /// @brief Of these, calls that were late; from here on calls are those of this cycle.
    void BeginPeriod(std::size_t cycle, Kernel& kernel);
    /// @brief Of these, the commands.
    void TellCommands(std::size_t cycle, Kernel& kernel);
    [[nodiscard]] std::optional<RecordedFrame> FrameUntil(const Nanoseconds at) const
    {
        return course_.FrameUntil(next_frame_, at);
    }
    /// @brief The next frame.
    void Hand(const RecordedFrame& frame, Kernel& kernel);
    void Confirm(const StampedFrame& own, Kernel& kernel);
    [[nodiscard]] InstantPair Stamp(const Nanoseconds at) const
    {
        return course_.Stamp(at);
    }
    /// @brief What the kernel's cycle is called with.
    [[nodiscard]] CycleCall CallOf(std::size_t cycle, Nanoseconds at) const;
    /// @brief The application writes what it senses into the pairs that are produced: those of this index, or those
    /// for which it is not asked (0).
    void WriteInputs(const InputTarget& target, std::uint16_t index) const;
    /// @brief The kernel asks for the values of a producer: as often and when the fault has it. [SRS_CMG_811]
    [[nodiscard]] RefreshAnswer Refresh(const InputTarget& target, CommunicationIndex index);

    /// @brief The frames that the kernel got in the last cycle.
    [[nodiscard]] const std::vector<RecordedFrame>& Handed() const noexcept
    {
        return handed_;
    }
    /// @brief Inputs of which a bit can be stuck.
    [[nodiscard]] const std::vector<InputBit>& Inputs() const noexcept
    {
        return inputs_;
    }
    [[nodiscard]] CallFaults& OfCalls() noexcept
    {
        return *calls_;
    }

  private:
    /// What is written into this side of a pair.
    [[nodiscard]] std::uint64_t Written(std::size_t cycle, std::size_t pair, bool is_inverse,
                                        std::uint64_t value) const;
    void CatchUp(Kernel& kernel);
    void CatchUpRefresh();
    [[nodiscard]] const InputBit* StuckInput(std::size_t cycle) const;

    const Recording& recording_;
    Course course_;
    Commands commands_;
    std::unique_ptr<CallFaults> calls_;
    std::vector<InputBit> inputs_{};
    std::vector<RecordedFrame> handed_{};
    std::vector<RecordedFrame> held_back_{};    ///< Calls of the kernel that come later,
    std::vector<StampedFrame> held_confirms_{}; ///< of either kind,
    std::uint16_t held_refresh_{0U};            ///< and of the provider: its index, where there is one,
    InputTarget held_target_{};                 ///< and where its values go.
    const Experiment* fault_{nullptr};
    std::size_t next_frame_{0U};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_FEED_HPP
