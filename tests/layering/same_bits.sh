#!/usr/bin/env bash
# same_bits.sh OBJDUMP NM LIBRARY...: to compute the same bits on every machine, the engine must not
# use fused multiply-add, which rounds once where a * b + c rounds twice, nor the C library's
# trigonometry and powers, whose last bit differs between processors.
set -euo pipefail
objdump=$1 nm=$2
shift 2
code=$("$objdump" -d --no-show-raw-insn "$@")
if fused=$(grep -E -m 3 '\sv?fn?m(add|sub)' <<< "$code"); then
    echo "fused multiply-add in the engine:"
    echo "$fused"
    exit 1
fi
grep -q 'mulsd\|mulpd\|vmulsd' <<< "$code" || { echo "no multiplication found: is this the engine?"; exit 1; }
unsafe='(sin|cos|tan|asin|acos|atan|atan2|sincos|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|tgamma|lgamma|erf)f?l?'
if called=$("$nm" -u "$@" | grep -E "^\s*U ${unsafe}(@|$)"); then
    echo "functions whose bits depend on the processor:"
    echo "$called"
    exit 1
fi
