// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_SPACE_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_SPACE_HPP

#include "verification/campaign/managed/watch.hpp"
#include "verification/campaign/variants.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::campaign::managed
{
/// One fault: where, when and how.
struct Trial
{
    Target target{Target::kNmt};
    Fault fault{Fault::kLost};
    std::size_t subject{0U}; ///< Frame, device, manager, or object.
    std::uint32_t variant{0U};
    Nanoseconds at{0};
    FrameHit hit{}; ///< Of a frame.
};

/// Faults of one part and kind, of which all are tried or a sample.
struct Stratum
{
    Target target{Target::kNmt};
    Fault fault{Fault::kLost};
    std::vector<std::size_t> subjects;
    std::vector<std::uint64_t> ends; ///< By subject: how many faults it and those before it have.
    std::uint64_t taken{0U};
    std::uint64_t first{0U}; ///< Number of the first experiment.

    [[nodiscard]] std::uint64_t Size() const
    {
        return ends.empty() ? 0U : ends.back();
    }
};

/// An object of a safety slave.
struct WrittenObject
{
    std::size_t slave{0U};
    ExpectedValue expected{};
};

/// The experiments of a plan by their number. A sample takes one fault of each of equal stretches of its stratum, drawn
/// by seed and number alone. [SRS_CMG_071]
class Space
{
  public:
    /// @brief All outlive it. Throws YamlError for what the plan names and nothing is hit of.
    Space(const Plan& plan, Stage& stage, const Reference& reference);

    [[nodiscard]] std::uint64_t Size() const noexcept
    {
        return size_;
    }
    [[nodiscard]] Trial At(std::uint64_t number) const;
    [[nodiscard]] const std::vector<Stratum>& Strata() const noexcept
    {
        return strata_;
    }
    [[nodiscard]] const std::vector<std::uint32_t>& Identifiers() const noexcept
    {
        return identifiers_;
    }
    [[nodiscard]] const std::vector<WrittenObject>& Objects() const noexcept
    {
        return objects_;
    }
    /// @brief Members of the memory of managers.
    [[nodiscard]] const std::vector<ManagerMember>& Members() const noexcept
    {
        return reference_.memory;
    }
    /// @brief The byte of the member that is hit.
    [[nodiscard]] static std::uint32_t ByteOf(const Trial& trial);
    /// @brief What happens to the clock.
    [[nodiscard]] static CounterFault ClockFaultOf(const Trial& trial);
    /// @brief How long a device or manager is away.
    [[nodiscard]] static Nanoseconds AwayOf(const Trial& trial);
    /// @brief What is hit, as "sdo 582#4318100300000100".
    [[nodiscard]] std::string SubjectText(const Trial& trial) const;
    /// @brief What is hit, and how: the place of a report.
    [[nodiscard]] std::string PlaceText(const Trial& trial) const;

  private:
    void TakeFrames();
    void TakeObjects();
    void Require() const;
    [[nodiscard]] std::size_t SubjectsOf(Target target) const;
    [[nodiscard]] Stratum StratumOf(Target target, Fault fault) const;
    [[nodiscard]] std::uint64_t FaultsOf(Target target, Fault fault, std::size_t subject) const;
    [[nodiscard]] std::vector<host::NodeIndex> ReceiversOf(std::size_t frame) const;

    const Plan& plan_;
    Stage& stage_;
    const Reference& reference_;
    Nanoseconds until_;
    std::vector<std::size_t> frames_[kTargetCount]{};
    std::vector<std::uint32_t> identifiers_{};
    std::vector<WrittenObject> objects_{};
    std::vector<Stratum> strata_{};
    std::uint64_t size_{0U};
};
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_SPACE_HPP
