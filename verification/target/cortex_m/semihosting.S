@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ What only assembly can ask of the emulator of a Cortex-M board.
    .syntax unified
    .thumb
    .section .text, "ax", %progbits

@ Word TargetTrap(operation, block): the semihosting trap of an M profile.
    .global TargetTrap
    .type TargetTrap, %function
    .thumb_func
TargetTrap:
    bkpt 0xAB
    bx lr
    .section .note.GNU-stack, "", %progbits
    .end
