// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_VARIANTS_HPP
#define VERIFICATION_CAMPAIGN_VARIANTS_HPP

#include "verification/campaign/course.hpp"
#include "verification/campaign/experiment.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

/// How faults that are no bits of memory differ from one another: by the number `variant` of an experiment.
namespace counterpoint::campaign
{
/// Of a lost frame: 1 to 4 in a row, then all of its identifier, then all of the bus. [SRS_CMG_020]
constexpr std::uint32_t kLosesIdentifier = 4U;
constexpr std::uint32_t kLossVariants = 6U;
/// A frame changes places with one of so many that follow.
constexpr std::uint32_t kOrderVariants = 4U;
constexpr std::uint32_t kLengthVariants = kMaxPayloadBytes;
/// Of a message: 1 to 4 in a row, then all. It comes behind one of so many that follow. [SRS_CMG_062]
constexpr std::uint32_t kLosesLink = 4U;
constexpr std::uint32_t kLinkLossVariants = 5U;
/// It does nothing any more; its clock stands and it goes on with its cycles. [SRS_CMG_063]
constexpr std::uint32_t kStopVariants = 2U;

/// Calls of a channel that are disturbed. [SRS_CMG_022]
enum class ChannelCall : std::uint8_t
{
    kOnFrame = 0U,
    kOnCycle = 1U,
    kHeld = 2U,
    kDemote = 3U,
    kCommit = 4U,
    kAnswer = 5U,
    kPrepare = 6U,
    kOnConfirm = 7U,
    kInverseFrame = 8U,
    kLoad = 9U,
    kRecheck = 10U,
};
constexpr std::uint32_t kChannelCalls = 11U;
/// Calls of the kernel, and one by it, that are disturbed; its cycle is Part::kCycle.
enum class KernelCall : std::uint8_t
{
    kOnFrame = 0U,
    kOnConfirm = 1U,
    kOnRefresh = 2U, ///< Of the application by the kernel. [SRS_CMG_811]
};
constexpr std::uint32_t kKernelCalls = 3U;
/// Of each of them the first so many of a cycle.
constexpr std::uint32_t kTurns = 4U;

/// Of calls and steps: bit 0, from then on in each cycle; bit 1, what kSkipped answers: what it answered last, or 0;
/// of a step, whether its mark goes with it.
constexpr std::uint32_t kAlways = 1U;
constexpr std::uint32_t kNothingLeft = 2U;
/// In a row.
constexpr std::uint32_t kSkippedCycles = 5U;
/// Steps that have one before them; the last one has none behind it.
constexpr std::size_t kStepSubjects = kFlowStepCount - 1U;
/// A command that is told again or late is so by up to so many cycles. [SRS_CMG_029]
constexpr std::uint32_t kCommandCycles = 50U;
/// Each NMT state, and the GFC.
constexpr std::uint32_t kCommandCount = 5U;
/// Each other command instead, and each bit of the state wrong.
constexpr std::uint32_t kWrongCommands = kCommandCount + 8U;
/// A, B, both.
constexpr std::size_t kCounterSubjects = 3U;
/// Ways of the link, CPUs.
constexpr std::size_t kCpuSubjects = 2U;

/// What becomes of a counter, or of both. [SRS_CMG_023]
struct CounterFault
{
    std::size_t which{0U};    ///< 2: both.
    std::int64_t rate_ppm{0}; ///< Of its own rate.
    std::int32_t jump_us{0};
};

/// @brief Whether a fault is of a complete pair.
[[nodiscard]] constexpr bool IsOfPair(const FaultKind kind) noexcept
{
    return kind == FaultKind::kPairRepeated || kind == FaultKind::kPairDelayed || kind == FaultKind::kPairForged;
}
/// @brief Of one subject of a part: how many variants it has. `reach` is in steps of the grid, `identifiers` the number
/// of those of the recording.
[[nodiscard]] std::uint64_t VariantsOf(Part part, FaultKind kind, std::uint64_t reach, std::size_t identifiers);
/// @brief One of kCommandCount.
[[nodiscard]] Command CommandNumber(std::uint32_t number);
/// @brief What is told instead of a command; one of kWrongCommands, of which one may be the same.
[[nodiscard]] Command WrongCommand(const Command& command, std::uint32_t variant);
[[nodiscard]] CounterFault CounterFaultOf(const Experiment& fault);
/// @brief Data by seed and experiment.
[[nodiscard]] std::uint64_t DrawnData(std::uint64_t seed, const Experiment& fault);
/// @brief Gives the frame another identifier, or another kind.
void Masquerade(const Recording& recording, std::uint32_t variant, CanFrame& frame);
/// @brief What is hit, of a part that is no memory: channel_a.Held, "frame 101h", "step guard".
[[nodiscard]] std::string SubjectName(const Experiment& fault, const Recording& recording);
/// @brief What is hit and how, of a part that is no memory, as reports tell it.
[[nodiscard]] std::string SubjectText(const Experiment& fault, const Recording& recording);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_VARIANTS_HPP
