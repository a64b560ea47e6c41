// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_DIFFERENTIAL_HPP
#define VERIFICATION_DIFFERENTIAL_DIFFERENTIAL_HPP

#include "verification/differential/comparison.hpp"
#include "verification/differential/configuration_part.hpp"
#include "verification/differential/consumer_part.hpp"
#include "verification/differential/cycle_part.hpp"
#include "verification/differential/producer_part.hpp"
#include "verification/differential/reached.hpp"
#include "verification/differential/scene.hpp"

#include <cstdint>

/// Random devices and sequences, fed to both channels and compared after every step. Freestanding. [SRS_CNF_010,
/// SRS_CNF_340]
namespace counterpoint::differential
{

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
        comparison_.Tell(is_told);
    }
    /// @brief One channel is driven alone, in both places: no difference ends a sequence or is told.
    void DriveOneAlone() noexcept
    {
        comparison_.Ignore();
    }
    /// @brief The random device of the sequence.
    [[nodiscard]] Device& Driven() noexcept
    {
        return scene_.device;
    }
    [[nodiscard]] const Reached& Seen() const noexcept
    {
        return scene_.reached;
    }
    [[nodiscard]] DifferentialResult Result() const noexcept
    {
        return DifferentialResult{sequences_, failures_, steps_, comparison_.HashValue()};
    }

  private:
    void StartSequence() noexcept;

    Scene scene_;
    Comparison comparison_;
    ProducerPart producer_;
    CyclePart cycle_;
    ConsumerPart consumer_;
    ConfigurationPart configuration_;
    std::uint32_t sequences_{0U};
    std::uint32_t failures_{0U};
    std::uint64_t steps_{0U};
};

/// @brief `count` sequences from `first` on; stops after `most_failures` sequences with a difference.
[[nodiscard]] DifferentialResult RunDifferential(Differential& run, std::uint32_t seed, std::uint32_t first,
                                                 std::uint32_t count, std::uint32_t most_failures) noexcept;

} // namespace counterpoint::differential

#endif
