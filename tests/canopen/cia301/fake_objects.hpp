// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA301_FAKE_OBJECTS_HPP
#define TESTS_CANOPEN_CIA301_FAKE_OBJECTS_HPP

#include "canopen/cia301/dictionary/foreign_objects.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

/// In the kernel's place: 1300h:00 (1 byte, written at will), 2000h:01 (4 bytes), everything else unknown.
class FakeObjects final : public ForeignObjects
{
  public:
    ObjectReading Read(const ObjectAddress& address) noexcept override
    {
        ++reads;
        ObjectReading answer{};
        answer.abort = Where(address);
        if (answer.abort == AbortCode::kNone)
        {
            answer.data = (address.index == 0x1300U) ? gate : variable;
        }
        return answer;
    }

    AbortCode Write(const ObjectAddress& address, const ObjectData& data) noexcept override
    {
        ++writes;
        AbortCode abort = Where(address);
        if ((abort == AbortCode::kNone) && (address.index == 0x2000U))
        {
            abort = AbortCode::kReadOnly;
        }
        if (abort == AbortCode::kNone)
        {
            abort = refusal;
        }
        if (abort == AbortCode::kNone)
        {
            gate = data;
        }
        return abort;
    }

    ObjectData gate{{0x01U}, 1U};
    ObjectData variable{{0x78U, 0x56U, 0x34U, 0x12U}, 4U};
    AbortCode refusal{AbortCode::kNone};
    int reads{0};
    int writes{0};

  private:
    static AbortCode Where(const ObjectAddress& address) noexcept
    {
        AbortCode abort = AbortCode::kObjectUnknown;
        if (address.index == 0x1300U)
        {
            abort = (address.sub == 0U) ? AbortCode::kNone : AbortCode::kSubUnknown;
        }
        else if ((address.index == 0x2000U) && (address.sub == 1U))
        {
            abort = AbortCode::kNone;
        }
        return abort;
    }
};

} // namespace counterpoint::cia301

#endif
