// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Who a safety slave has to be, as its profile compares it.
#include "canopen/cia302/safety_gate/safety_check.hpp"
#include "canopen/start_up/el6751/setup.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kWhole = 0xFFFFFFFFU;
constexpr std::uint32_t kProfileNumber = 0x0000FFFFU; ///< Of 1000h.
constexpr std::uint8_t kTypeRow = 0U;
constexpr std::uint8_t kRevisionRow = 3U;

std::uint32_t MaskUnderEl6751(const SlaveSetup& slave, const std::uint8_t row) noexcept
{
    const El6751Slave usual{};
    const El6751Slave& box = (slave.el6751 == nullptr) ? usual : *slave.el6751;
    const bool is_coupler = (box.kind == El6751Kind::kBusCoupler);
    const bool is_asked = (row == kTypeRow) ? box.is_device_type_checked : (!is_coupler || (row < kRevisionRow));
    return is_asked ? kWhole : 0U;
}

std::uint32_t MaskOf(const SlaveSetup& slave, const IdentityRule rule, const std::uint8_t row) noexcept
{
    std::uint32_t mask = kWhole;
    if (rule == IdentityRule::kPlcDesigner)
    {
        mask = (row == kTypeRow) ? kProfileNumber : 0U;
    }
    else if (rule == IdentityRule::kEl6751)
    {
        mask = MaskUnderEl6751(slave, row);
    }
    else
    {
        // All that are expected.
    }
    return mask;
}

} // namespace

IdentityRow IdentityRowOf(const SlaveSetup& slave, const IdentityRule rule, const std::uint8_t row) noexcept
{
    const std::uint32_t expected[kIdentityRows] = {slave.device_type, slave.vendor_id, slave.product_code,
                                                   slave.revision_number, slave.serial_number};
    constexpr std::uint16_t kDeviceType = 0x1000U;
    constexpr std::uint16_t kIdentity = 0x1018U;
    const std::uint16_t index = (row == kTypeRow) ? kDeviceType : kIdentity;
    IdentityRow found{{index, row}, 0U, 0U};
    if (row < kIdentityRows)
    {
        found.expected = expected[row];
        const bool is_zero_meant = (rule == IdentityRule::kEl6751) && (row == kTypeRow); // Its text compares 0, too.
        found.mask = ((found.expected == 0U) && !is_zero_meant) ? 0U : MaskOf(slave, rule, row);
    }
    return found;
}

} // namespace counterpoint::cia302
