// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_WITNESS_HPP
#define VERIFICATION_PROOF_WITNESS_HPP

#include "safety_core/contract/srdo.hpp"
#include "verification/proof/domain.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::proof
{

/// What an input is, as the witness sees it.
struct CallSeen
{
    std::int64_t now_us;
    bool is_acknowledged;
    bool is_operational;
    bool is_intact;
    bool is_late;
    bool is_gfc;
    bool is_demoted;
};

/// What a consumer shows behind an input.
struct Shows
{
    SrdoState state;
    SrdoCause first_cause;
    std::uint8_t data; ///< Of the held pair.
};

/// Follows what came, and knows from docs/semantics.md alone which releases that permits and when a fault has to stand.
/// It looks at the inputs and at what is shown, never into a channel or a model. It is no third model: it does not say
/// what has to be released.
class Witness
{
  public:
    void OnNormal(std::uint8_t value, bool is_length_right, std::int64_t stamp_us, const ConsumerSetup& setup);
    void OnInverse(std::uint8_t value, bool is_length_right, std::int64_t stamp_us, const ConsumerSetup& setup);
    void OnCall(const CallSeen& call, const ConsumerSetup& setup);
    /// @brief What does not hold between the inputs and what is shown, by name; empty: all holds.
    [[nodiscard]] std::string Judge(const Shows& before, const Shows& now, bool is_call,
                                    const ConsumerSetup& setup) const;
    /// @brief Behind each judged call.
    void EndCall(bool is_released);
    /// @brief Everything that decides what it will say, times relative to `now_us` and cut at `oldest_us`.
    void AddTo(std::vector<std::uint32_t>& key, std::int64_t now_us, std::uint32_t oldest_us) const;

  private:
    struct Half
    {
        std::uint8_t value;
        std::int64_t stamp_us;
    };

    void Fail(SrdoCause cause);
    void LookAtLimits(std::int64_t stamp_us, bool is_inverse, const ConsumerSetup& setup);
    void LookAtAcknowledge(const CallSeen& call);
    [[nodiscard]] std::string JudgeRelease(const Shows& before, const Shows& now, const ConsumerSetup& setup) const;
    [[nodiscard]] std::string JudgeFault(const Shows& before, const Shows& now) const;

    std::optional<Half> pending_;
    std::optional<Half> pair_;            ///< The last right one, since the last error.
    std::optional<SrdoCause> error_;      ///< The first one since the last call, that one left out.
    std::optional<std::int64_t> edge_us_; ///< Of the acknowledge: not older than its window, none since the last error.
    std::int64_t now_us_{0};
    bool is_active_{false};
    bool was_high_{true}; ///< The reading before.
    bool is_high_{true};  ///< The level: what two readings in a row last agreed on.
};

} // namespace counterpoint::proof

#endif
