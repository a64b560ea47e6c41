// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/actuator/actuator.hpp"

#include "safety_core/kernel/variable.hpp"

namespace counterpoint::examples
{
namespace
{

constexpr Setting kSettings[]{
    {{0x1300U, 0U}, 1U, 1U},
    {{0x1381U, 1U}, 4U, 0x22000108U},
    {{0x1381U, 2U}, 4U, 0x23000108U},
    {{0x1381U, 3U}, 4U, 0x22000208U},
    {{0x1381U, 4U}, 4U, 0x23000208U},
    {{0x1381U, 0U}, 1U, 4U},
    {{0x1301U, 2U}, 2U, 50U},
    {{0x1301U, 3U}, 1U, 20U},
    {{0x1301U, 5U}, 4U, 0x103U},
    {{0x1301U, 6U}, 4U, 0x104U},
    {{0x1301U, 1U}, 1U, kDirectionConsumer},
    {{0x13FFU, 1U}, 2U, 0x9FCBU},
    {{0x13FEU, 0U}, 1U, kConfigurationValidValue},
};

// Safe value 0: stop. Interlock: after a fault the drive waits for a pair and for a person.
constexpr SrdoSetup kSrdos[]{
    {1U, ReleasePolicy::kInterlock, ProducerForm::kApplicationSends, Payload{}, SrvtDetection::kEarly, StaticMap{}}};

} // namespace

const DeviceConfig& Actuator::Describe() noexcept
{
    for (std::uint8_t command = 0U; command < kCommands; ++command)
    {
        const std::uint8_t sub = static_cast<std::uint8_t>(command + 1U);
        objects_[command] = MappableObject{0x2200U, sub, 8U, MapAccess::kConsumer, &normal_[command]};
        objects_[kCommands + command] = MappableObject{0x2300U, sub, 8U, MapAccess::kConsumer, &inverse_[command]};
    }
    SetCommonConfig(config_);
    config_.srdos = kSrdos;
    config_.srdo_count = 1U;
    config_.objects = objects_;
    config_.object_count = 2U * kCommands;
    config_.node_id = 33U;
    config_.digest = 0xBEE7CE1CU;
    return config_;
}

AbortCode Actuator::Configure(Kernel& kernel) noexcept
{
    return WriteSettings(kernel, SettingList{kSettings, sizeof(kSettings) / sizeof(kSettings[0])});
}

// The gate says whether the data may be used at all; a bit that flipped in these variables since is found here.
bool Actuator::MayMove(const SrdoMask open) const noexcept
{
    bool may_move = (open & 1U) != 0U;
    for (std::uint8_t command = 0U; command < kCommands; ++command)
    {
        const PairView view = IsInversePair(VariablePlace{objects_[command].place, 8U},
                                            VariablePlace{objects_[kCommands + command].place, 8U});
        may_move = may_move && (view == PairView::kInverse) && (normal_[command] == 1U);
    }
    return may_move;
}

} // namespace counterpoint::examples
