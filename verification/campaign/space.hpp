// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_SPACE_HPP
#define VERIFICATION_CAMPAIGN_SPACE_HPP

#include "verification/campaign/device.hpp"
#include "verification/campaign/plan.hpp"
#include "verification/campaign/recording.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::campaign
{
/// One fault: where, when and how.
struct Experiment
{
    Part part{Part::kKernel};
    FaultKind kind{FaultKind::kFlip};
    std::size_t place{0U};  ///< In Device::Places().
    std::size_t offset{0U}; ///< In the region.
    std::uint8_t bit{0U};
    std::size_t cycle{0U};
    Phase phase{Phase::kBeforeFrames};
};

/// Faults of one part and kind, of which all are tried or a sample.
struct Stratum
{
    Part part{Part::kKernel};
    FaultKind kind{FaultKind::kFlip};
    std::uint64_t size{0U};  ///< All faults of it.
    std::uint64_t taken{0U}; ///< Those that are tried.
    std::uint64_t first{0U}; ///< Number of the first experiment.
};

/// The experiments of a plan by their number. A sample takes one fault of each of equal stretches of its stratum, drawn
/// by seed and number alone. [SRS_CMG_003, SRS_CMG_004]
class Space
{
  public:
    /// @brief Words that hold an address of the program are left out. Throws YamlError for an instant outside of the
    /// recording, with `horizon` cycles behind it.
    Space(const Plan& plan, const Recording& recording, Device& device, std::size_t horizon);

    [[nodiscard]] std::uint64_t Size() const noexcept
    {
        return size_;
    }
    [[nodiscard]] Experiment At(std::uint64_t number) const;
    [[nodiscard]] const std::vector<Stratum>& Strata() const noexcept
    {
        return strata_;
    }
    /// @brief The cycles in which faults begin, ascending.
    [[nodiscard]] const std::vector<std::size_t>& Cycles() const noexcept
    {
        return cycles_;
    }
    /// @brief Bytes of addresses of the program, which are not hit.
    [[nodiscard]] std::size_t LeftOut() const noexcept
    {
        return left_out_;
    }
    /// @brief Bytes of each part that are hit.
    [[nodiscard]] std::size_t BytesOf(Part part) const
    {
        return bytes_[static_cast<std::size_t>(part)].size();
    }

  private:
    struct Byte
    {
        std::size_t place;
        std::size_t offset;
    };

    void RequireMembers(const Device& device) const;
    [[nodiscard]] bool IsChosen(const Place& place, std::size_t byte) const;
    void TakeBytes(Device& device);
    void TakeCycles(const Plan& plan, const Recording& recording, std::size_t horizon);

    const Plan& plan_;
    std::vector<std::size_t> cycles_{};
    std::vector<Byte> bytes_[kPartCount]{};
    std::vector<Stratum> strata_{};
    std::uint64_t size_{0U};
    std::size_t left_out_{0U};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_SPACE_HPP
