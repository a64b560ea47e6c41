// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_CONSUMER_SRDO_HPP
#define VERIFICATION_THIRD_VOICE_CONSUMER_SRDO_HPP

#include "verification/third_voice/configuration.hpp"
#include "verification/third_voice/consumer.hpp"
#include "verification/third_voice/variables.hpp"

#include <cstdint>
#include <set>

namespace counterpoint::third_voice
{
/// A consumer of a device by both observers: what both have of it is released, anything else leaves its objects safe.
/// Of an SRDO that is none it holds observers that are off. [semantics 3]
class ConsumerSrdo
{
  public:
    /// @brief `config`, `objects` and `variables` outlive it.
    ConsumerSrdo(const DeviceConfig& config, std::size_t slot, const SrdoObjects& objects, Flaw flaw,
                 Variables& variables);

    void EnterOperational(Time now);
    /// @brief `was_on`: it is safe in this very call, whatever follows, and the next cycle tells it. [semantics 4]
    void LeaveOperational(bool was_on);
    [[nodiscard]] bool IsActive() const;

    void OnFrame(std::uint32_t identifier, const Bytes& data, Time stamp);
    void LookAtAcknowledge(bool level_a, bool level_b, Time now);
    void LookAtLimits(Time now);
    /// @brief A GFC of somebody else.
    void Fail(SrdoCause cause);
    void LookAtWaiting(Time now);
    /// @brief What both have of it, at the end of a cycle: whether a pair was released that was not before. In level 2
    /// none is.
    [[nodiscard]] bool Decide(Time now, bool is_level_2);
    void WriteSafe();

    [[nodiscard]] SrdoState State() const;
    [[nodiscard]] bool IsReleased() const;
    /// @brief Whether what a cycle did is an open question. [Consumer::IsOpen]
    [[nodiscard]] bool IsOpen() const;
    /// @brief Causes that came up since the last call.
    [[nodiscard]] std::set<SrdoCause> TakeCauses();

  private:
    [[nodiscard]] ConsumerRules Rules() const;
    void Converge();
    [[nodiscard]] bool IsGiven() const;
    [[nodiscard]] bool Release(bool is_level_2);

    const DeviceConfig& config_;
    const SrdoSetup& setup_;
    const SrdoObjects& objects_;
    Flaw flaw_;
    Variables& variables_;
    Consumer a_{};
    Consumer b_{};
    std::uint32_t written_ordinal_{0U};
    bool is_released_{false};
    bool is_open_{false};
    bool has_left_{false}; ///< The next cycle tells it.
};
} // namespace counterpoint::third_voice

#endif
