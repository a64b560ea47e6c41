// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_PRODUCER_STEPS_HPP
#define VERIFICATION_CONFORMANCE_PRODUCER_STEPS_HPP

#include "verification/conformance/case_judge.hpp"
#include "verification/conformance/hash.hpp"
#include "verification/conformance/step.hpp"

#include <cstdint>

namespace counterpoint::conformance
{

/// The steps of a case in which a channel sends.
class ProducerSteps
{
  public:
    ProducerSteps(Channel& channel, Party party, CaseJudge& judge, Hash& hash) noexcept
        : channel_{channel}, judge_{judge}, hash_{hash}, party_{party}
    {
    }
    /// @brief False if this is no such step.
    bool Run(const Step& step, std::uint32_t origin) noexcept;

  private:
    void CheckFrame(const Step& step, const CanFrame& frame) noexcept;
    void CheckEmpty(const CanFrame& frame) noexcept;
    void CheckPrepare(const Step& step) noexcept;
    void CheckInverseFrame(const Step& step) noexcept;
    void CheckConfirmation(const Step& step, const CanFrame& frame, std::uint32_t origin) noexcept;
    [[nodiscard]] Step OwnData(const Step& step) const noexcept;

    Channel& channel_;
    CaseJudge& judge_;
    Hash& hash_;
    CanFrame prepared_{}; ///< The last one.
    Party party_;
};

} // namespace counterpoint::conformance

#endif
