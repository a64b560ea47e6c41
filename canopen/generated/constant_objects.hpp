// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATED_CONSTANT_OBJECTS_HPP
#define CANOPEN_GENERATED_CONSTANT_OBJECTS_HPP

#include "canopen/cia301/dictionary/entry.hpp"

#include <cstdint>

namespace counterpoint::generated
{

/// A value that is a part of the program, in little-endian order.
struct ConstantValue
{
    ObjectAddress address;
    std::uint32_t size_bytes;
    const std::uint8_t* bytes;
};

/// A table of constant values, ordered by index and sub-index.
struct ConstantTable
{
    const ConstantValue* values;
    std::uint32_t count;
};

/// Hook of the entries whose values lie in program memory. [SRS_GEN_006]
class ConstantObjects final : public cia301::ReadHook, public cia301::WriteHook
{
  public:
    /// @brief `table` and what it points to outlive the hook.
    explicit constexpr ConstantObjects(const ConstantTable& table) noexcept : table_(table)
    {
    }

    [[nodiscard]] cia301::Reading OnRead(const ObjectAddress& address, const cia301::Room& room) noexcept override;
    /// @brief Accepts what changes nothing: kValueRange otherwise.
    [[nodiscard]] cia301::SdoAbort OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept override;

  private:
    [[nodiscard]] const ConstantValue* Find(const ObjectAddress& address) const noexcept;

    ConstantTable table_;
};

} // namespace counterpoint::generated

#endif
