#include "irsg/scattering/FftLibrary.h"

#include <fftw3.h>

namespace irsg {

namespace {

fftwf_complex* raw(std::complex<float>* values) {
    return reinterpret_cast<fftwf_complex*>(values);
}
FftLibrary::Plan* opaque(fftwf_plan plan) {
    return reinterpret_cast<FftLibrary::Plan*>(plan);
}
fftwf_plan planOf(const FftLibrary::Plan* plan) {
    return reinterpret_cast<fftwf_plan>(const_cast<FftLibrary::Plan*>(plan));
}

bool divideBy(FftLibrary::RunPieces run) {
    if (fftwf_init_threads() == 0)
        return false;
    fftwf_threads_set_callback(run, nullptr);
    return true;
}

FftLibrary::Plan* planForward(int width, int height, int pieces, float* reals,
                              std::complex<float>* spectrum) {
    fftwf_plan_with_nthreads(pieces);
    return opaque(fftwf_plan_dft_r2c_2d(height, width, reals, raw(spectrum), FFTW_ESTIMATE));
}

FftLibrary::Plan* planBackward(int width, int height, int pieces, std::complex<float>* spectrum,
                               float* reals) {
    fftwf_plan_with_nthreads(pieces);
    return opaque(fftwf_plan_dft_c2r_2d(height, width, raw(spectrum), reals, FFTW_ESTIMATE));
}

void forward(const FftLibrary::Plan* plan, float* reals, std::complex<float>* spectrum) {
    fftwf_execute_dft_r2c(planOf(plan), reals, raw(spectrum));
}

void backward(const FftLibrary::Plan* plan, std::complex<float>* spectrum, float* reals) {
    fftwf_execute_dft_c2r(planOf(plan), raw(spectrum), reals);
}

void destroy(FftLibrary::Plan* plan) {
    fftwf_destroy_plan(planOf(plan));
}

} // namespace

extern "C" const FftLibrary* irsgFftLibrary() {
    static const FftLibrary library{fftwf_malloc, fftwf_free, divideBy, planForward,
                                    planBackward, forward,    backward, destroy};
    return &library;
}

} // namespace irsg
