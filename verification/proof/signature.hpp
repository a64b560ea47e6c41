// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_SIGNATURE_HPP
#define VERIFICATION_PROOF_SIGNATURE_HPP

#include "safety_core/contract/channel.hpp"
#include "verification/proof/checksum.hpp"

#include <cstdint>

// The checksums again, as the objects that ship compute them: through the contract alone.
namespace counterpoint::proof
{

/// A device for which `channel` computes 13FFh and its digest; two SRDOs of one byte each.
class SignatureRig
{
  public:
    explicit SignatureRig(Channel& channel);
    /// @brief The signature for every SCT, 0 to 65535, beside `srvts` values of SRVT from 0 on. Behind the two bytes of
    /// SCT the checksum stands in each state once, and SRVT is the next byte: with 256 of them each state meets each
    /// byte.
    [[nodiscard]] Shown ProveSignature(std::uint32_t srvts);
    /// @brief The digest of one SRDO, continued from each byte at each place and from `draws` values from a fixed seed.
    [[nodiscard]] Shown ProveDigest(std::uint32_t draws);

  private:
    void Store(ConfigField field, std::uint32_t value, std::uint8_t sub);
    void CompareDigest(Shown& shown, std::uint32_t before);

    Channel& channel_;
    std::uint8_t bytes_[2]{};
    SrdoSetup srdos_[2]{};
    MappableObject objects_[2]{};
    DeviceConfig config_{};
};

} // namespace counterpoint::proof

#endif
