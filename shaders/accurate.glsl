#version 430 compatibility
// Functions whose built-in forms are too coarse for radiometry on some drivers (llvmpipe: acos is
// 1.6e-4 rad off). Float accuracy of about 2e-7 on any driver.

// x in -1..1. Hastings' form sqrt(1 - |x|) P7(|x|), Abramowitz and Stegun 4.4.46, error 2e-8.
float arcCosine(float x) {
    float a = abs(x);
    float p = -0.0012624911;
    p = p * a + 0.0066700901;
    p = p * a - 0.0170881256;
    p = p * a + 0.0308918810;
    p = p * a - 0.0501743046;
    p = p * a + 0.0889789874;
    p = p * a - 0.2145988016;
    p = p * a + 1.5707963050;
    float angle = sqrt(1.0 - a) * p;
    return x < 0.0 ? 3.14159265358979 - angle : angle;
}

// ln of a positive normal number: exponent by its bits, mantissa by the series of atanh.
float logarithm(float x) {
    int bits = floatBitsToInt(x);
    int exponent = ((bits >> 23) & 255) - 127;
    float mantissa = intBitsToFloat((bits & 0x007fffff) | 0x3f800000);
    if (mantissa > 1.41421356) {
        mantissa *= 0.5;
        exponent += 1;
    }
    float s = (mantissa - 1.0) / (mantissa + 1.0);
    float q = s * s;
    float series = 1.0 + q * (1.0 / 3.0 + q * (0.2 + q * (1.0 / 7.0 + q * (1.0 / 9.0 + q / 11.0))));
    return float(exponent) * 0.69314718056 + 2.0 * s * series;
}

// e^x for x <= 0, by 2^k times the Taylor series on |r| <= ln 2 / 2.
float exponential(float x) {
    float k = floor(x * 1.44269504089 + 0.5);
    if (k < -125.0)
        return 0.0;
    float r = (x - k * 0.693359375) + k * 2.12194440e-4;
    float series = 1.0 + r * (1.0 + r * (0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 +
                   r * (1.0 / 120.0 + r * (1.0 / 720.0 + r / 5040.0))))));
    return intBitsToFloat((int(k) + 127) << 23) * series;
}

// base^exponent for base in 0..1 and exponent >= 0. At exponent 0 the factor is 1 everywhere.
float power(float base, float exponent) {
    if (exponent == 0.0)
        return 1.0;
    if (exponent == 1.0)
        return base;
    return base > 1e-30 ? exponential(exponent * logarithm(base)) : 0.0;
}
