#!/bin/bash
# What one would guess: a plan of KISS FFT's C++ class (kissfft.hh) may be used by several threads at once, because
# transform() is a const function and its input and output belong to the caller.
# What it is: for lengths with a prime factor other than 2, 3 and 5 it works in a buffer of the plan, a mutable
# member, so that two threads on one plan give wrong numbers now and then; lengths of 2, 3 and 5 alone are right.
# Version: 131.1.0 (Debian 12, libkissfft-dev 131.1.0-4.1~deb12u1). Source: kissfft.hh, kf_bfly_generic and _scratchbuf.
# Why it matters here: the blur of a sensor transforms many rows at once; each thread takes a copy of the plan.
set -euo pipefail

version='131.1.0-4.1~deb12u1'
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download "libkissfft-dev=$version" >/dev/null 2>&1
dpkg -x libkissfft-dev_*.deb root
echo "libkissfft-dev $version"

cat >shared.cpp <<'CPP'
#include <complex>
#include <cstddef>
#include <cstdio>
#include <thread>
#include <vector>

#include <kissfft/kissfft.hh>

/// Transforms that differ from those of one thread, of two threads that share the plan.
static std::size_t wrong(std::size_t length) {
    const kissfft<double> plan(length, false);
    std::vector<std::vector<std::complex<double>>> in(2), right(2);
    for (std::size_t t = 0; t < 2; ++t) {
        for (std::size_t i = 0; i < length; ++i)
            in[t].emplace_back(1.0 / (1.0 + i + t), t);
        right[t].resize(length);
        plan.transform(in[t].data(), right[t].data()); // the buffer has its size from here on
    }
    std::vector<std::size_t> count(2);
    const auto work = [&](std::size_t t) {
        std::vector<std::complex<double>> out(length);
        for (int i = 0; i < 20000; ++i) {
            plan.transform(in[t].data(), out.data());
            count[t] += out != right[t];
        }
    };
    std::thread other(work, 1);
    work(0);
    other.join();
    return count[0] + count[1];
}

int main() {
    const std::size_t smooth = wrong(360), other = wrong(361); // 2^3 3^2 5; 19^2
    std::printf("length 360: %s\nlength 361: %s\n", smooth ? "some are wrong" : "all right",
                other ? "some are wrong" : "all right");
    return smooth == 0 && other > 0 ? 0 : 1;
}
CPP
g++ -std=c++17 -O2 -pthread -I root/usr/include shared.cpp -o shared
./shared
