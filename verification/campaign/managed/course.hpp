// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_COURSE_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_COURSE_HPP

#include "verification/campaign/managed/space.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::campaign::managed
{
/// Something that somebody told of a fault.
struct Telling
{
    Teller teller{Teller::kNobody};
    std::string key; ///< What is the same telling.
    Nanoseconds at{0};
    std::string text;
};

/// A stage with its judge, as time goes on. [SRS_CMG_070]
class Course
{
  public:
    /// @brief Throws YamlError and cia306::InputError.
    explicit Course(const Plan& plan);

    /// @brief Everything up to and including then; the judge looks each ms.
    void AdvanceTo(Nanoseconds until);
    /// @brief To the end without a fault.
    [[nodiscard]] Reference RunWithout();
    /// @brief The fault happens now, and time passes until it is over. `reference` outlives the call.
    [[nodiscard]] Outcome Try(const Trial& trial, const Space& space, const Reference& reference);
    /// @brief What was told until now, in the order of time of who tells.
    [[nodiscard]] std::vector<Telling> Tellings();
    /// @brief What was told more often than without the fault, the first one first.
    [[nodiscard]] std::vector<Telling> News(const Reference& reference, Nanoseconds from);
    [[nodiscard]] Stage& World() noexcept
    {
        return stage_;
    }
    [[nodiscard]] Watch& Judge() noexcept
    {
        return watch_;
    }

  private:
    void Inject(const Trial& trial, const Space& space);
    void InjectIntoSlave(const Trial& trial, const Slave& slave);
    void InjectIntoManager(const Trial& trial, simulator::SimulatedManager& manager);
    void InjectIntoMemory(const Trial& trial, const Space& space);
    void InjectIntoClock(const Trial& trial);
    void Write(const Trial& trial, const WrittenObject& object);
    [[nodiscard]] Outcome Judged(const Trial& trial, const Reference& reference, bool is_changed, bool is_back);

    const Plan& plan_;
    Stage stage_;
    Watch watch_;
    std::optional<MemoryWatch> memory_{}; ///< Of the run without fault of a plan that hits memory.
    Nanoseconds looked_{-1};              ///< The last ms.
    Nanoseconds later_at_{runtime::kNever};
    std::function<void()> later_{};
};
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_COURSE_HPP
