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

/// The SDOs of boots, one for each slave. Each call starts the SDO that the state is about, or looks how far it is. The
/// status of the slave tells object, abort code and, for up to 4 bytes, the value that was read.
class BootTransfer
{
  public:
    /// @brief `sdo` is kept by reference.
    explicit BootTransfer(SdoPool& sdo) noexcept : sdo_(sdo)
    {
    }

    /// @brief Reads an object of the slave.
    [[nodiscard]] Got Fetch(const BootJob& job, const ObjectAddress& object) noexcept;
    /// @brief Writes an object of the slave; `value` must stay until the end.
    [[nodiscard]] Got Put(const BootJob& job, const ObjectAddress& object, const Bytes& value, SdoMode mode) noexcept;
    /// @brief Writes an object of one byte.
    [[nodiscard]] Got PutByte(const BootJob& job, const ObjectAddress& object, std::uint8_t value) noexcept;
    /// @brief How the running transfer ended, if it has.
    [[nodiscard]] Got Take(const BootJob& job) noexcept;

  private:
    SdoPool& sdo_;
};

} // namespace counterpoint::cia302

#endif
