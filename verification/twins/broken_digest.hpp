// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWINS_BROKEN_DIGEST_HPP
#define VERIFICATION_TWINS_BROKEN_DIGEST_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>
#include <string>

namespace counterpoint::twins
{

constexpr std::uint32_t kDigestParts = 24U;
constexpr std::uint32_t kDigestBreaks = 6U;

/// One part of the digest, and how it is broken.
struct DigestRule
{
    std::uint32_t part;
    std::uint32_t broken;
};

/// What the digest of a slot is made of.
struct DigestSource
{
    const DeviceConfig* config;
    std::uint32_t gfc_parameter;
    std::uint32_t transmission_type;
    SlotIndex slot;
};

[[nodiscard]] std::string DigestRuleText(const DigestRule& rule);
[[nodiscard]] DeviceDigest BrokenDigest(const DigestRule& rule, const DigestSource& source, DeviceDigest before);

} // namespace counterpoint::twins

#endif
