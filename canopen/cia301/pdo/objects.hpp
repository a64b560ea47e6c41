// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_PDO_OBJECTS_HPP
#define CANOPEN_CIA301_PDO_OBJECTS_HPP

#include "canopen/cia301/pdo/rpdo.hpp"
#include "canopen/cia301/pdo/tpdo.hpp"

namespace counterpoint::cia301
{

/// Hook of 1400h to 15FFh, 1600h to 17FFh, 1800h to 19FFh and 1A00h to 1BFFh; hands SYNC to both kinds of PDO. Both are
/// kept by reference. [SRS_PDO_001]
class PdoObjects final : public NumberHook, public SyncListener
{
  public:
    PdoObjects(Tpdos& tpdos, Rpdos& rpdos) noexcept;

    /// @brief Hands SYNC to the RPDOs first, so that received values take effect before TPDOs sample theirs.
    void OnSync(const SyncEvent& event) noexcept override;

  private:
    [[nodiscard]] ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;

    Tpdos& tpdos_;
    Rpdos& rpdos_;
};

} // namespace counterpoint::cia301

#endif
