// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_DICTIONARY_NUMBER_HOOK_HPP
#define CANOPEN_CIA301_DICTIONARY_NUMBER_HOOK_HPP

#include "canopen/cia301/dictionary/entry.hpp"

namespace counterpoint::cia301
{

/// Value of an object of 1, 2 or 4 bytes, or the abort code that says why there is none.
struct ObjectValue
{
    SdoAbort abort;
    std::uint32_t value;
    std::uint32_t size_bytes;
};

/// Base of the hooks of all services: turns the bytes of an object into a number of up to 4 bytes and back. Its entries
/// need no place. The dictionary has checked length and limits before OnWrite.
class NumberHook : public ReadHook, public WriteHook
{
  public:
    [[nodiscard]] Reading OnRead(const ObjectAddress& address, const Room& room) noexcept final;
    [[nodiscard]] SdoAbort OnWrite(const ObjectAddress& address, const Bytes& value) noexcept final;

  protected:
    NumberHook() noexcept = default;
    ~NumberHook() noexcept = default;
    NumberHook(const NumberHook&) = default;
    NumberHook& operator=(const NumberHook&) = default;

  private:
    /// @brief The present value of an object of this service.
    [[nodiscard]] virtual ObjectValue Fetch(const ObjectAddress& address) noexcept = 0;
    /// @brief Takes a value that is written; kNone where it was accepted.
    [[nodiscard]] virtual SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept = 0;
};

} // namespace counterpoint::cia301

#endif
