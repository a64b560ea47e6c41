// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_VARIABLES_HPP
#define VERIFICATION_THIRD_VOICE_VARIABLES_HPP

#include "verification/third_voice/configuration.hpp"

#include <cstdint>
#include <map>

namespace counterpoint::third_voice
{
/// What the objects that may be mapped hold.
class Variables
{
  public:
    explicit Variables(const DeviceConfig& config);

    [[nodiscard]] bool Has(Address address) const;
    [[nodiscard]] std::uint64_t At(Address address) const;
    void Put(Address address, std::uint64_t value);
    /// @brief One side of an SRDO, as the application left it.
    [[nodiscard]] std::uint64_t ReadNormal(const SrdoObjects& srdo) const;
    [[nodiscard]] std::uint64_t ReadInverse(const SrdoObjects& srdo) const;
    /// @brief Both sides.
    void Write(const SrdoObjects& srdo, std::uint64_t normal);

  private:
    [[nodiscard]] std::uint64_t ReadSide(const SrdoObjects& srdo, std::size_t side) const;

    std::map<Address, std::uint64_t> values_;
};
} // namespace counterpoint::third_voice

#endif
