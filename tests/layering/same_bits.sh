#!/usr/bin/env bash
# same_bits.sh OBJDUMP NM LIBRARY...: to compute the same bits on every machine, the engine must not
# use fused multiply-add, which rounds once where a * b + c rounds twice, nor the C library's
# trigonometry and powers, whose last bit differs between processors. Knows the instructions of x86-64, aarch64,
# riscv64 and s390x; OBJDUMP and NM are those of the libraries' processor.
set -euo pipefail
objdump=$1 nm=$2
shift 2
code=$("$objdump" -d --no-show-raw-insn "$@")
processor=$(sed -n 's/.*file format elf64-//p' <<< "$code" | sort -u)
case $processor in
    x86-64) fused='v?fn?m(add|sub)' times='v?mul[sp]d' ;;
    littleaarch64) fused='fn?m(add|sub)|f(ml[as]|mlal|mlsl|cmla)' times='fmul' ;;
    littleriscv) fused='fn?m(add|sub)\.' times='fmul\.' ;;
    s390) fused='m[as][ed]b?r?\s|[vw]fn?m[as][sdx]b' times='m(d|ee)br?\s|[vw]fm[ds]?b' ;;
    *) echo "no gate for '$processor': x86-64, aarch64, riscv64 or s390x"; exit 1 ;;
esac
if found=$(grep -E -m 3 "\s($fused)" <<< "$code"); then
    echo "fused multiply-add in the engine:"
    echo "$found"
    exit 1
fi
grep -qE "\s($times)" <<< "$code" || { echo "no multiplication found: is this the engine?"; exit 1; }
unsafe='(sin|cos|tan|asin|acos|atan|atan2|sincos|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|tgamma|lgamma|erf)f?l?'
if called=$("$nm" -u "$@" | grep -E "^\s*U ${unsafe}(@|$)"); then
    echo "functions whose bits depend on the processor:"
    echo "$called"
    exit 1
fi
