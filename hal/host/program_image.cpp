// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/program_image.hpp"

#include <link.h>

namespace counterpoint::host
{

namespace
{

/// The first object that the loader tells of is the program.
int TakeProgram(dl_phdr_info* const info, std::size_t /*size*/, void* const result)
{
    auto& spans = *static_cast<std::vector<hal::MemorySpan>*>(result);
    for (unsigned number = 0U; number < info->dlpi_phnum; ++number)
    {
        const ElfW(Phdr)& header = info->dlpi_phdr[number];
        // Where the loader has relocated, it has taken the right to write away again (vtables are there).
        const bool is_constant =
            ((header.p_type == PT_LOAD) && ((header.p_flags & PF_W) == 0U)) || (header.p_type == PT_GNU_RELRO);
        const auto words = static_cast<std::uint32_t>(header.p_memsz / hal::kWordBytes);
        if (is_constant && (words != 0U))
        {
            spans.push_back({static_cast<hal::Address>(info->dlpi_addr + header.p_vaddr), words});
        }
    }
    return 1;
}

} // namespace

std::vector<hal::MemorySpan> ReadOnlyImage()
{
    std::vector<hal::MemorySpan> spans;
    dl_iterate_phdr(&TakeProgram, &spans);
    return spans;
}

} // namespace counterpoint::host
