// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_SPACE_HPP
#define VERIFICATION_CAMPAIGN_SPACE_HPP

#include "verification/campaign/device.hpp"
#include "verification/campaign/experiment.hpp"
#include "verification/campaign/plan.hpp"
#include "verification/campaign/recording.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::campaign
{
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
    /// recording, with `horizon` cycles behind it, and for what the plan names and nothing is hit of.
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
    /// @brief The last cycle in which a fault begins.
    [[nodiscard]] std::size_t LastCycle() const noexcept
    {
        return last_cycle_;
    }
    [[nodiscard]] std::uint64_t Seed() const noexcept
    {
        return plan_.seed;
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
    struct ToldCommand
    {
        std::size_t command; ///< In Recording::commands.
        std::size_t cpu;     ///< kNoCpu: there is one.
        std::size_t cycle;   ///< In which it is told.
    };

    void RequireMembers(const Device& device) const;
    void RequireBytes(const Device& device) const;
    void RequireFaults() const;
    [[nodiscard]] bool IsHit(Part part) const;
    [[nodiscard]] bool IsChosen(const Place& place, std::size_t byte) const;
    void TakeBytes(Device& device);
    void TakeReach(const Device& device);
    void TakeCycles(const Plan& plan, const Recording& recording, std::size_t horizon);
    void TakeFrames();
    void TakeCommands(const Device& device);
    [[nodiscard]] bool Has(Part part) const;
    [[nodiscard]] std::uint64_t SizeOf(Part part, FaultKind kind) const;
    [[nodiscard]] std::uint64_t SubjectsOf(Part part, FaultKind kind) const;
    [[nodiscard]] std::uint64_t SubjectsOfCpu(Part part, FaultKind kind) const;
    [[nodiscard]] std::uint64_t TakeCpu(Experiment& experiment, std::uint64_t subject) const;
    [[nodiscard]] std::uint64_t VariantsOf(Part part, FaultKind kind) const;
    void TakeMemory(Experiment& experiment, std::uint64_t index) const;
    void TakeSubject(Experiment& experiment, std::uint64_t index) const;
    void TakeBusSubject(Experiment& experiment, std::uint64_t subject) const;
    [[nodiscard]] Bit BitAt(Part part, std::uint64_t index) const;

    const Plan& plan_;
    const Recording& recording_;
    std::size_t input_count_;
    bool has_two_cpus_;
    std::uint64_t reach_{0U}; ///< In steps of the grid.
    std::uint64_t early_{0U}; ///< A cycle in these, less one.
    std::size_t last_cycle_{0U};
    std::vector<std::size_t> frames_{};       ///< That come in these cycles.
    std::vector<std::uint64_t> frame_bits_{}; ///< Of their data, each with those before it.
    std::vector<std::size_t> frame_pairs_{};  ///< In Recording::pairs.
    std::vector<ToldCommand> commands_{};     ///< Of these cycles, CPU by CPU.
    std::vector<std::size_t> cycles_{};
    std::vector<Byte> bytes_[kPartCount]{};
    std::vector<Stratum> strata_{};
    std::uint64_t size_{0U};
    std::size_t left_out_{0U};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_SPACE_HPP
