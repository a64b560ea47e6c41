// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_PLC_DESIGNER_SDOS_HPP
#define CANOPEN_START_UP_PLC_DESIGNER_SDOS_HPP

#include "canopen/start_up/plc_designer/slaves.hpp"

namespace counterpoint::cia302
{

/// What came of the SDOs of a slave.
enum class PlcSdoEnd : std::uint8_t
{
    kNone = 0U,     ///< More SDOs follow, or the slave is absent now.
    kRestored = 1U, ///< 1011h:01 was answered: the slave must be reset.
    kAll = 2U,      ///< All of them were answered.
};

/// Carries out the SDOs of state 3: 1000h, 1011h:01 and the list of the configurator, one SDO a cycle. [SRS_PLC_005,
/// SRS_PLC_006, SRS_PLC_007, SRS_PLC_008, SRS_PLC_011]
class PlcSdos
{
  public:
    /// @brief The parts are kept by reference.
    explicit PlcSdos(const PlcParts& parts) noexcept;

    /// @brief Starts the next SDO, if it can be started now.
    void Ask(NodeId node, Instant now) noexcept;
    /// @brief One step of the slave: an answer is taken in one cycle, the next request is sent in the following one.
    [[nodiscard]] PlcSdoEnd Drive(NodeId node, Instant now) noexcept;

  private:
    [[nodiscard]] PlcSdoEnd OnAnswer(NodeId node, Instant now) noexcept;
    void OnSilence(NodeId node, Instant now) noexcept;

    StartUpParts parts_;
    PlcSlaves slaves_;
    SafetyReader reader_;
};

} // namespace counterpoint::cia302

#endif
