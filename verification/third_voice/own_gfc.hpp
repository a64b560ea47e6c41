// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_OWN_GFC_HPP
#define VERIFICATION_THIRD_VOICE_OWN_GFC_HPP

#include "verification/third_voice/configuration.hpp"
#include "verification/third_voice/consumer.hpp"

#include <optional>

namespace counterpoint::third_voice
{
/// A GFC that the device sends: a normal frame of its producers must follow. [semantics 6]
class OwnGfc
{
  public:
    /// @brief `config` outlives it.
    OwnGfc(const DeviceConfig& config, Flaw flaw);

    void Start();
    /// @brief A frame may follow for `follow_us`.
    void OnSent(Time follow_us);
    /// @brief A normal frame came to the controller, which may not take it.
    void OnNormal(bool is_taken);
    /// @brief Behind the normal frames of a cycle: whether none followed in time.
    [[nodiscard]] bool Look(Time now);

  private:
    const DeviceConfig& config_;
    Flaw flaw_;
    std::optional<Time> called_; ///< The last cycle since the start.
    bool is_sent_{false};        ///< And no normal frame since.
    Time follow_us_{0};          ///< For how long one may follow, and
    std::optional<Time> at_;     ///< from when on: not known yet before the first cycle.
};
} // namespace counterpoint::third_voice

#endif
