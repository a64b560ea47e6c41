// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_RUNNER_HPP
#define VERIFICATION_CONFORMANCE_RUNNER_HPP

#include "verification/conformance/altered_device.hpp"
#include "verification/conformance/case.hpp"
#include "verification/conformance/case_judge.hpp"
#include "verification/conformance/dictionary.hpp"
#include "verification/conformance/hash.hpp"
#include "verification/conformance/producer_steps.hpp"

#include <cstdint>

namespace counterpoint::conformance
{

/// `hash` stands for every value the channel returned in every step and for the objects it wrote. [SRS_CNF_002]
struct RunResult
{
    std::uint32_t cases;
    std::uint32_t failures;
    std::uint32_t hash;
};

/// The moments that are 0 in the cases: with the second, the counter wraps 30 ms into a case, with the third it passes
/// half its range there. [SRS_CNF_004]
constexpr std::uint32_t kOrigins[] = {0U, 0U - 30000U, 0x80000000U - 30000U};
constexpr std::uint32_t kOriginCount = 3U;

/// Executes cases against one channel. Owns the objects of the device (some 10 KB): make it static where the stack is
/// small.
class Runner
{
  public:
    Runner(Channel& channel, Party party, Reporter& reporter) noexcept;
    /// @brief One case at one origin of time. True if all its expectations held.
    bool Run(const Case& test, std::uint32_t origin) noexcept;
    [[nodiscard]] std::uint32_t HashValue() const noexcept
    {
        return hash_.Value();
    }

  private:
    void Start(const Device& device) noexcept;
    void PowerOn() noexcept;
    void SetFields(SlotIndex slot, std::uint32_t normal, std::uint32_t inverse) noexcept;
    bool RunDeviceStep(const Step& step) noexcept;
    void RunStep(const Step& step) noexcept;
    void RunRepeated(const Step& repeat) noexcept;
    bool RunConfigurationStep(const Step& step) noexcept;
    bool RunCycleStep(const Step& step) noexcept;
    bool RunOutcomeStep(const Step& step) noexcept;
    bool RunSlotStep(const Step& step) noexcept;
    bool RunReleaseStep(const Step& step) noexcept;
    void StoreItem(SlotIndex slot, ConfigField field, std::uint8_t sub, std::uint32_t value) noexcept;
    void StoreValues(const Device& device) noexcept;
    void ValidateAll(const Device& device) noexcept;
    void Check(const CheckResult& result, const Step& step) noexcept;
    void DoCycle(const Step& step) noexcept;
    void CheckConsistency() noexcept;
    void CheckMasks(const Step& step) noexcept;
    void CheckView(const Step& step) noexcept;
    void CheckObject(const Step& step, Party writer) noexcept;
    void CheckHeld(SlotIndex slot, const SrdoView& view) noexcept;
    void LookAtSlots() noexcept;

    Channel& channel_;
    Dictionary dictionary_{};
    AlteredDevice device_{};
    Hash hash_{};
    CaseJudge judge_;
    ProducerSteps producer_;
    CycleOutcome outcome_{};
    const Case* case_{nullptr};
    Step repeated_{}; ///< The last frame or cycle.
    Party party_;
    std::uint32_t origin_{0U};
    std::uint32_t challenge_{0U};
    std::uint32_t token_flip_{0U};
    std::uint32_t cycles_{0U};
    SrdoMask acknowledge_{0U};
    SrdoMask request_{0U}; ///< For the next cycle only.
    SrdoMask stand_{0U};   ///< For the next cycle only.
    SrdoMask examine_{0U}; ///< For the next Commit only.
    SrdoMask found_{0U};   ///< What the next Commit must return.
    NmtState nmt_{NmtState::kOperational};
    QueueState queue_{QueueState::kIntact};
    std::uint8_t configuration_valid_{0U};
};

/// @brief Every case of every table at every origin of time. Cases count once for each origin.
[[nodiscard]] RunResult RunConformance(Runner& runner) noexcept;

} // namespace counterpoint::conformance

#endif
