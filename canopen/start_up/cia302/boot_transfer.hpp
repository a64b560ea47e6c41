// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_TRANSFER_HPP
#define CANOPEN_START_UP_CIA302_BOOT_TRANSFER_HPP

#include "canopen/start_up/cia302/boot_record.hpp"

namespace counterpoint::cia302
{

/// How far the SDO of a state is.
enum class Got : std::uint8_t
{
    kNothingYet = 0U,
    kDone = 1U,
    kRefused = 2U, ///< Abort or silence: see the status.
};

/// The SDOs of boots, one a slave: each call hands over the one that the state is about, or looks what became of it.
/// The status tells object, abort code and, of up to 4 bytes, the value that was read.
class BootTransfer
{
  public:
    explicit BootTransfer(SdoPool& sdo) noexcept : sdo_(sdo)
    {
    }

    [[nodiscard]] Got Fetch(const BootJob& job, const ObjectAddress& object) noexcept;
    /// @brief `value` has to last until the end.
    [[nodiscard]] Got Put(const BootJob& job, const ObjectAddress& object, const Bytes& value, SdoMode mode) noexcept;
    [[nodiscard]] Got PutByte(const BootJob& job, const ObjectAddress& object, std::uint8_t value) noexcept;
    /// @brief The end of the running transfer, if it has one.
    [[nodiscard]] Got Take(const BootJob& job) noexcept;

  private:
    SdoPool& sdo_;
};

} // namespace counterpoint::cia302

#endif
