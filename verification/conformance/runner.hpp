// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_RUNNER_HPP
#define VERIFICATION_CONFORMANCE_RUNNER_HPP

#include "verification/conformance/case.hpp"
#include "verification/conformance/dictionary.hpp"
#include "verification/conformance/hash.hpp"

#include <cstdint>

namespace counterpoint::conformance
{

/// An expectation that did not hold. `step` counts from 1; `origin` is what was added to every time of the case.
struct Failure
{
    const char* case_name;
    const char* field;
    std::uint64_t expected;
    std::uint64_t got;
    std::uint32_t step;
    std::uint32_t origin;
};

/// Hears of each expectation that did not hold. [SRS_CNF_003]
class Reporter
{
  public:
    virtual void OnFailure(const Failure& failure) noexcept = 0;

    Reporter(const Reporter&) = delete;
    Reporter& operator=(const Reporter&) = delete;

  protected:
    Reporter() noexcept = default;
    ~Reporter() noexcept = default;
};

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
    static constexpr std::uint8_t kAlterable = 2U;

    void Start(const Device& device) noexcept;
    void PowerOn() noexcept;
    void Alter(const Step& step) noexcept;
    void AlterDevice(Parameter parameter, std::uint32_t value) noexcept;
    void AlterTimes(Parameter parameter, std::uint32_t value) noexcept;
    void AlterSetup(Parameter parameter, SrdoSetup& setup, std::uint32_t value) noexcept;
    void SetFields(SlotIndex slot, std::uint32_t normal, std::uint32_t inverse) noexcept;
    bool RunDeviceStep(const Step& step) noexcept;
    void RunStep(const Step& step) noexcept;
    void RunRepeated(const Step& repeat) noexcept;
    bool RunConfigurationStep(const Step& step) noexcept;
    bool RunCycleStep(const Step& step) noexcept;
    bool RunOutcomeStep(const Step& step) noexcept;
    bool RunSlotStep(const Step& step) noexcept;
    bool RunReleaseStep(const Step& step) noexcept;
    void RunProducerStep(const Step& step) noexcept;
    void StoreItem(SlotIndex slot, ConfigField field, std::uint8_t sub, std::uint32_t value) noexcept;
    void StoreValues(const Device& device) noexcept;
    void ValidateAll(const Device& device) noexcept;
    void Check(const CheckResult& result, const Step& step) noexcept;
    void DoCycle(const Step& step) noexcept;
    void CheckConsistency() noexcept;
    void CheckMasks(const Step& step) noexcept;
    void CheckView(const Step& step) noexcept;
    void CheckObject(const Step& step, Party writer) noexcept;
    void CheckFrame(const Step& step, const CanFrame& frame) noexcept;
    void CheckEmpty(const CanFrame& frame) noexcept;
    void CheckPrepare(const Step& step) noexcept;
    void CheckInverseFrame(const Step& step) noexcept;
    void CheckConfirmation(const Step& step) noexcept;
    void CheckHeld(SlotIndex slot, const SrdoView& view) noexcept;
    void Expect(const char* field, std::uint64_t expected, std::uint64_t got) noexcept;
    void LookAtSlots() noexcept;

    Channel& channel_;
    Reporter& reporter_;
    Dictionary dictionary_{};
    DeviceConfig config_{};
    SrdoSetup setups_[kAlterable]{}; ///< Of a device that has no more SRDOs: copies that Alter may change.
    Hash hash_{};
    CycleOutcome outcome_{};
    const Case* case_{nullptr};
    Step repeated_{}; ///< The last frame or cycle.
    Party party_;
    bool failed_{false};
    std::uint32_t step_{0U};
    std::uint32_t origin_{0U};
    std::uint32_t challenge_{0U};
    std::uint32_t token_flip_{0U};
    std::uint32_t cycles_{0U};
    SrdoMask acknowledge_{0U};
    SrdoMask request_{0U}; ///< For the next cycle only.
    SrdoMask stand_{0U};   ///< For the next cycle only.
    NmtState nmt_{NmtState::kOperational};
    QueueState queue_{QueueState::kIntact};
    std::uint8_t configuration_valid_{0U};
};

/// @brief Every case of every table at every origin of time. Cases count once for each origin.
[[nodiscard]] RunResult RunConformance(Runner& runner) noexcept;
/// @brief The frame that a step of kind kFrame or kConfirm describes.
[[nodiscard]] CanFrame FrameOf(const Step& step) noexcept;

} // namespace counterpoint::conformance

#endif
