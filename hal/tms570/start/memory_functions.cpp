// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The four functions that a compiler may call by itself in freestanding code, with their names in the ARM run-time ABI
// (which swaps two arguments of memset). Compiled with -fno-builtin: a loop here must not become a call of itself.
#include <cstddef>
#include <cstdint>

extern "C"
{
    void* memcpy(void* to, const void* from, std::size_t count) noexcept;
    void* memmove(void* to, const void* from, std::size_t count) noexcept;
    void* memset(void* to, int value, std::size_t count) noexcept;
    int memcmp(const void* left, const void* right, std::size_t count) noexcept;

    // The names are those of the ABI.
    void __aeabi_memcpy(void* to, const void* from, std::size_t count) noexcept;   // MISRA D-008
    void __aeabi_memcpy4(void* to, const void* from, std::size_t count) noexcept;  // MISRA D-008
    void __aeabi_memcpy8(void* to, const void* from, std::size_t count) noexcept;  // MISRA D-008
    void __aeabi_memmove(void* to, const void* from, std::size_t count) noexcept;  // MISRA D-008
    void __aeabi_memmove4(void* to, const void* from, std::size_t count) noexcept; // MISRA D-008
    void __aeabi_memmove8(void* to, const void* from, std::size_t count) noexcept; // MISRA D-008
    void __aeabi_memset(void* to, std::size_t count, int value) noexcept;          // MISRA D-008
    void __aeabi_memset4(void* to, std::size_t count, int value) noexcept;         // MISRA D-008
    void __aeabi_memset8(void* to, std::size_t count, int value) noexcept;         // MISRA D-008
    void __aeabi_memclr(void* to, std::size_t count) noexcept;                     // MISRA D-008
    void __aeabi_memclr4(void* to, std::size_t count) noexcept;                    // MISRA D-008
    void __aeabi_memclr8(void* to, std::size_t count) noexcept;                    // MISRA D-008

    void* memcpy(void* to, const void* from, std::size_t count) noexcept
    {
        auto* target = static_cast<std::uint8_t*>(to);
        const auto* source = static_cast<const std::uint8_t*>(from);
        const bool words = (((reinterpret_cast<std::uintptr_t>(to) | reinterpret_cast<std::uintptr_t>(from)) & 3U) ==
                            0U); // MISRA D-008
        std::size_t i = 0U;
        if (words)
        {
            for (; (i + 16U) <= count; i += 16U)
            {
                const auto* read = reinterpret_cast<const std::uint32_t*>(source + i); // MISRA D-008
                auto* write = reinterpret_cast<std::uint32_t*>(target + i);            // MISRA D-008
                write[0] = read[0];                                                    // MISRA D-008
                write[1] = read[1];                                                    // MISRA D-008
                write[2] = read[2];                                                    // MISRA D-008
                write[3] = read[3];                                                    // MISRA D-008
            }
            for (; (i + 4U) <= count; i += 4U)
            {
                *reinterpret_cast<std::uint32_t*>(target + i) =
                    *reinterpret_cast<const std::uint32_t*>(source + i); // MISRA D-008
            }
        }
        for (; i < count; ++i)
        {
            target[i] = source[i]; // MISRA D-008
        }
        return to;
    }

    void* memmove(void* to, const void* from, std::size_t count) noexcept
    {
        auto* target = static_cast<std::uint8_t*>(to);
        const auto* source = static_cast<const std::uint8_t*>(from);
        if (reinterpret_cast<std::uintptr_t>(to) <= reinterpret_cast<std::uintptr_t>(from)) // MISRA D-008
        {
            return memcpy(to, from, count);
        }
        for (std::size_t i = count; i > 0U; --i)
        {
            target[i - 1U] = source[i - 1U]; // MISRA D-008
        }
        return to;
    }

    void* memset(void* to, int value, std::size_t count) noexcept
    {
        auto* target = static_cast<std::uint8_t*>(to);
        const std::uint32_t byte = static_cast<std::uint8_t>(value);
        const std::uint32_t word = byte * 0x01010101U;
        std::size_t i = 0U;
        if ((reinterpret_cast<std::uintptr_t>(to) & 3U) == 0U) // MISRA D-008
        {
            for (; (i + 16U) <= count; i += 16U)
            {
                auto* words = reinterpret_cast<std::uint32_t*>(target + i); // MISRA D-008
                words[0] = word;                                            // MISRA D-008
                words[1] = word;                                            // MISRA D-008
                words[2] = word;                                            // MISRA D-008
                words[3] = word;                                            // MISRA D-008
            }
            for (; (i + 4U) <= count; i += 4U)
            {
                *reinterpret_cast<std::uint32_t*>(target + i) = word; // MISRA D-008
            }
        }
        for (; i < count; ++i)
        {
            target[i] = static_cast<std::uint8_t>(byte); // MISRA D-008
        }
        return to;
    }

    int memcmp(const void* left, const void* right, std::size_t count) noexcept
    {
        const auto* a = static_cast<const std::uint8_t*>(left);
        const auto* b = static_cast<const std::uint8_t*>(right);
        for (std::size_t i = 0U; i < count; ++i)
        {
            if (a[i] != b[i]) // MISRA D-008
            {
                return (a[i] < b[i]) ? -1 : 1; // MISRA D-008
            }
        }
        return 0;
    }

    void __aeabi_memcpy(void* to, const void* from, std::size_t count) noexcept
    {
        static_cast<void>(memcpy(to, from, count));
    }
    void __aeabi_memcpy4(void* to, const void* from, std::size_t count) noexcept
    {
        static_cast<void>(memcpy(to, from, count));
    }
    void __aeabi_memcpy8(void* to, const void* from, std::size_t count) noexcept
    {
        static_cast<void>(memcpy(to, from, count));
    }
    void __aeabi_memmove(void* to, const void* from, std::size_t count) noexcept
    {
        static_cast<void>(memmove(to, from, count));
    }
    void __aeabi_memmove4(void* to, const void* from, std::size_t count) noexcept
    {
        static_cast<void>(memmove(to, from, count));
    }
    void __aeabi_memmove8(void* to, const void* from, std::size_t count) noexcept
    {
        static_cast<void>(memmove(to, from, count));
    }
    void __aeabi_memset(void* to, std::size_t count, int value) noexcept
    {
        static_cast<void>(memset(to, value, count));
    }
    void __aeabi_memset4(void* to, std::size_t count, int value) noexcept
    {
        static_cast<void>(memset(to, value, count));
    }
    void __aeabi_memset8(void* to, std::size_t count, int value) noexcept
    {
        static_cast<void>(memset(to, value, count));
    }
    void __aeabi_memclr(void* to, std::size_t count) noexcept
    {
        static_cast<void>(memset(to, 0, count));
    }
    void __aeabi_memclr4(void* to, std::size_t count) noexcept
    {
        static_cast<void>(memset(to, 0, count));
    }
    void __aeabi_memclr8(void* to, std::size_t count) noexcept
    {
        static_cast<void>(memset(to, 0, count));
    }
}
