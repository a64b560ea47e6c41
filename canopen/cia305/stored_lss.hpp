// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA305_STORED_LSS_HPP
#define CANOPEN_CIA305_STORED_LSS_HPP

#include "canopen/cia305/lss_slave.hpp"

#include "canopen/cia301/store/parameter_store.hpp"

namespace counterpoint::cia305
{

/// Node-ID and bit timing in the parameter store, in the group that only LSS saves. At power-on: Mount, Load of
/// kLssGroup, Settings; later LssDevice::Store hands its settings to Keep. Not reentrant. [SRS_LSS_012, SRS_LSS_013]
class StoredLss final : public cia301::StoredPart
{
  public:
    /// @brief `settings` hold until others are loaded or kept.
    explicit StoredLss(const LssSettings& settings) noexcept;

    /// @brief The settings that hold now.
    [[nodiscard]] const LssSettings& Settings() const noexcept;
    /// @brief Saves these settings. kPending until the saving has ended, as LssDevice::Store wants it; where others are
    /// being saved, until these are saved behind them. [SRS_LSS_013]
    [[nodiscard]] LssStored Keep(const LssSettings& settings, cia301::ParameterStore& store) noexcept;

    [[nodiscard]] std::uint32_t ItemCount() noexcept override;
    [[nodiscard]] cia301::StoredItem Item(std::uint32_t number, const cia301::Room& room) noexcept override;
    void BeginLoad(std::uint8_t groups) noexcept override;
    bool LoadItem(const cia301::Bytes& item) noexcept override;
    bool EndLoad(std::uint8_t groups) noexcept override;
    void Lose(std::uint8_t groups) noexcept override;

  private:
    LssSettings settings_;
    bool is_saving_;
};

} // namespace counterpoint::cia305

#endif
