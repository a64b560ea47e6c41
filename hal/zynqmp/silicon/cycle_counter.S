@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ Performance monitoring unit of a Cortex-R5F (ARM DDI 0460): one instruction each, and barriers.
    .syntax unified
    .arch armv7-r
    .thumb

    .section .text.cycle_counter, "ax", %progbits

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

    .macro unit_register name, third, operation
    begin ProcessorRead\name
    mrc p15, 0, r0, c9, \third, \operation
    finish ProcessorRead\name
    begin ProcessorWrite\name
    mcr p15, 0, r0, c9, \third, \operation
    isb
    finish ProcessorWrite\name
    .endm

    unit_register CycleControl, c12, 0
    unit_register CycleEnable, c12, 1
    unit_register CycleUserMode, c14, 0

    begin ProcessorReadCycleCounter
    mrc p15, 0, r0, c9, c13, 0
    finish ProcessorReadCycleCounter

    .section .note.GNU-stack, "", %progbits
    .end
