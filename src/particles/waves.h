/* Sines and exponentials by plain arithmetic: libraries differ in the last bits, and a start state
 * must be the same everywhere. Absolute errors near 1e-15 (sines), relative near 1e-13. */
#ifndef PARTICLES_WAVES_H
#define PARTICLES_WAVES_H

#define WAVE_PI 3.14159265358979323846

/* Of an angle in turns: wave_sine(0.25) is 1. */
double wave_sine(double turns);
double wave_cosine(double turns);

double wave_exp(double x);

#endif
