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

/// A rule between the objects of several services. [SRS_PDO_009]
class WriteRule
{
  public:
    /// @brief Whether this object may get this value beside what the others have.
    [[nodiscard]] virtual bool Allows(const ObjectAddress& object, std::uint32_t value) const noexcept = 0;

  protected:
    WriteRule() noexcept = default;
    ~WriteRule() noexcept = default;
    WriteRule(const WriteRule&) = default;
    WriteRule& operator=(const WriteRule&) = default;
};

/// Base of the hooks of all services: turns the bytes of an object into a number of up to 4 bytes and back. Its entries
/// need no place. The dictionary has checked length and limits before OnWrite.
class NumberHook : public ReadHook, public WriteHook
{
  public:
    [[nodiscard]] Reading OnRead(const ObjectAddress& address, const Room& room) noexcept final;
    [[nodiscard]] SdoAbort OnWrite(const ObjectAddress& address, const Bytes& value) noexcept final;
    [[nodiscard]] SdoAbort OnWriteAgain(const ObjectAddress& address, const Bytes& value) noexcept final;
    /// @brief Until EndConfiguration the values that come are those of a file or a store, in any order: each is taken
    /// if it can be had at all, whatever the others are at present. [SRS_OBD_016]
    void BeginConfiguration() noexcept
    {
        is_configuring_ = true;
    }
    /// @brief From now on values come from clients, whose rules also look at the present values, and what `rule`, which
    /// is kept by reference, does not allow is refused with 0609 0030h. Null: no such rule.
    void EndConfiguration(const WriteRule* const rule) noexcept
    {
        is_configuring_ = false;
        rule_ = rule;
    }

  protected:
    NumberHook() noexcept = default;
    [[nodiscard]] bool IsConfiguring() const noexcept
    {
        return is_configuring_;
    }
    ~NumberHook() noexcept = default;
    NumberHook(const NumberHook&) = default;
    NumberHook& operator=(const NumberHook&) = default;

  private:
    /// @brief The present value of an object of this service.
    [[nodiscard]] virtual ObjectValue Fetch(const ObjectAddress& address) noexcept = 0;
    /// @brief Takes a value that is written; kNone where it was accepted.
    [[nodiscard]] virtual SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept = 0;
    /// @brief As WriteHook::OnWriteAgain.
    [[nodiscard]] virtual SdoAbort StoreAgain(const ObjectAddress& address, const std::uint32_t value) noexcept
    {
        return Store(address, value);
    }
    [[nodiscard]] SdoAbort Take(const ObjectAddress& address, const Bytes& value, Attempt attempt) noexcept;

    bool is_configuring_{false};
    const WriteRule* rule_{nullptr};
};

} // namespace counterpoint::cia301

#endif
