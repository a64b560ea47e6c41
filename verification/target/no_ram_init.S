@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ The emulator's RAM needs no initialisation by hardware.
    .syntax unified
    .arch armv7-r
    .arm
    .section .text.start_up, "ax", %progbits
    .global HardwareInitialiseRam
    .type HardwareInitialiseRam, %function
HardwareInitialiseRam:
    mov r0, #1
    bx lr
    .size HardwareInitialiseRam, . - HardwareInitialiseRam
    .section .note.GNU-stack, "", %progbits
    .end
