@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ System registers of a Cortex-R5F (ARM DDI 0460, "System Control"): one instruction each, and barriers.
    .syntax unified
    .arch armv7-r
    .thumb

    .section .text.processor, "ax", %progbits

    .macro begin name
    .global \name
    .type \name, %function
    .thumb_func
\name:
    .endm
    .macro finish name
    bx lr
    .size \name, . - \name
    .endm

@ r0: value. A write takes effect before the next instruction.
    .macro system_register name, first, second, operation
    begin ProcessorRead\name
    mrc p15, 0, r0, \first, \second, \operation
    finish ProcessorRead\name
    begin ProcessorWrite\name
    dsb
    mcr p15, 0, r0, \first, \second, \operation
    dsb
    isb
    finish ProcessorWrite\name
    .endm

    system_register SystemControl, c1, c0, 0
    system_register RegionNumber, c6, c2, 0
    system_register RegionBase, c6, c1, 0
    system_register RegionSize, c6, c1, 2
    system_register RegionAccess, c6, c1, 4
    system_register CycleControl, c9, c12, 0
    system_register CycleEnable, c9, c12, 1
    system_register CycleUserMode, c9, c14, 0
    system_register CycleCounter, c9, c13, 0

    begin ProcessorReadMpuType
    mrc p15, 0, r0, c0, c0, 4
    finish ProcessorReadMpuType

@ r0: region, r1: access. Without a barrier: the caller has several.
    begin ProcessorSelectAccess
    mcr p15, 0, r0, c6, c2, 0
    mcr p15, 0, r1, c6, c1, 4
    finish ProcessorSelectAccess

    begin ProcessorSynchronise
    dsb
    isb
    finish ProcessorSynchronise

    begin ProcessorSleep
    dsb
    wfi
    finish ProcessorSleep

@ r0: the program status before.
    begin ProcessorLock
    mrs r0, cpsr
    cpsid if
    finish ProcessorLock

    begin ProcessorUnlock
    msr cpsr_c, r0
    finish ProcessorUnlock

    .section .note.GNU-stack, "", %progbits
    .end
