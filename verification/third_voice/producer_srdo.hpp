// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_PRODUCER_SRDO_HPP
#define VERIFICATION_THIRD_VOICE_PRODUCER_SRDO_HPP

#include "verification/third_voice/configuration.hpp"
#include "verification/third_voice/drift.hpp"
#include "verification/third_voice/producer.hpp"
#include "verification/third_voice/variables.hpp"

#include <cstdint>
#include <optional>
#include <set>

namespace counterpoint::third_voice
{
/// A producer of a device by both channels, each with its own counter. Of an SRDO that is none it holds producers that
/// are off. [semantics 6]
class ProducerSrdo
{
  public:
    /// @brief `config` and `objects` outlive it. `drift` is counter B's.
    ProducerSrdo(const DeviceConfig& config, std::size_t slot, const SrdoObjects& objects, Flaw flaw,
                 const Drift& drift);

    void EnterOperational(Time now, bool is_level_2);
    void LeaveOperational();
    [[nodiscard]] bool IsActive() const;
    /// @brief Comes with the next call.
    void Request();
    /// @brief Limits and refresh at the instant of a call: whether a pair is to be sent. In level 2 none is.
    [[nodiscard]] bool Look(Time now, bool is_level_2);
    /// @brief The normal frame, if both channels let it leave.
    [[nodiscard]] std::optional<Sent> Prepare(const Variables& variables, Time now);
    /// @brief What follows from it for both.
    [[nodiscard]] Confirmed Confirm(const Sent& frame, Time stamp);
    [[nodiscard]] Sent Inverse() const;
    /// @brief The pair on its way is over by both channels.
    void Fail(SrdoCause cause);

    /// @brief Whether the kernel calls before each refresh; else the application sends.
    [[nodiscard]] bool IsCalled() const;
    /// @brief When the next refresh falls due in channel A.
    [[nodiscard]] Time NextRefresh() const;
    /// @brief The last instant at which a pair of an application that sends is not late; of others none.
    [[nodiscard]] std::optional<Time> SilentUntil() const;
    /// @brief Causes that came up since the last call.
    [[nodiscard]] std::set<SrdoCause> TakeCauses();

  private:
    [[nodiscard]] ProducerRules Rules(bool is_level_2) const;

    const DeviceConfig& config_;
    const SrdoSetup& setup_;
    const SrdoObjects& objects_;
    Flaw flaw_;
    Drift drift_;
    Producer a_{};
    Producer b_{};
    bool stands_a_{false}; ///< Its refresh waits alone: it moves on until the next cycle.
    bool stands_b_{false};
};
} // namespace counterpoint::third_voice

#endif
