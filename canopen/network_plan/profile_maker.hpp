// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_NETWORK_PLAN_PROFILE_MAKER_HPP
#define CANOPEN_NETWORK_PLAN_PROFILE_MAKER_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/network_plan/network_plan.hpp"
#include "canopen/start_up/el6751/setup.hpp"
#include "canopen/start_up/plc_designer/setup.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::network_plan
{
/// What a start-up profile needs of one slave beside its SlaveSetup. The setup points into it, so it must not be moved.
struct ProfileSlave
{
    cia302::El6751Slave el6751{};
    std::vector<cia302::El6751Pdo> rx_pdos;
    std::vector<cia302::El6751Pdo> tx_pdos;
    std::vector<std::array<std::uint8_t, 8U>> outputs; ///< What each of `rx_pdos` carries.
    std::vector<std::uint8_t> concise;                 ///< Further start-up SDOs of the EL6751 profile.
    cia302::PlcSlave plc{};
};

/// @brief PDOs that a DCF switches on and maps, ascending; `first` is 1400h or 1800h. Throws cia306::InputError.
/// [SRS_ELM_051, SRS_ELM_210, SRS_ELM_214]
[[nodiscard]] std::vector<cia302::El6751Pdo> MakePdos(const cia306::Device& device, std::uint8_t node_id,
                                                      std::uint16_t first);

/// @brief Completes a setup for the profile; those of the others stay as they are. `file` is the network file that
/// the plan is from. Throws cia306::InputError.
/// [SRS_ELM_051, SRS_ELM_215, SRS_PLC_021]
void FillProfile(const std::string& file, StartProfile profile, const SlavePlan& plan, const cia306::Device& device,
                 ProfileSlave& slave, cia302::SlaveSetup& setup);
/// @brief EL6751: of the concise DCF, what no row writes. After FillProfile, when the whole network is known: that says
/// whether SYNC is sent. [SRS_ELM_212, SRS_ELM_213]
void LeaveOutRows(const cia306::Device& device, std::uint8_t node_id, const cia302::NetworkSetup& network,
                  ProfileSlave& slave, cia302::SlaveSetup& setup);
/// @brief That a bus coupler has another 5500h in its DCF than in the network file, which counts; else empty.
/// [SRS_ELM_586]
[[nodiscard]] std::string WarningOfCoupler(const SlavePlan& plan, const cia306::Device& device);
} // namespace counterpoint::network_plan

#endif // CANOPEN_NETWORK_PLAN_PROFILE_MAKER_HPP
