"""Records of a Gaussian process of a known spectrum."""

import numpy as np
import xarray

# A spectrum as broad as that of a sea, m0 = 1, about 0.8 rad/s.
PEAK, WIDTH = 0.8, 0.2


def density(omega: np.ndarray) -> np.ndarray:
    return np.exp(-0.5 * ((omega - PEAK) / WIDTH) ** 2) / (WIDTH * np.sqrt(2 * np.pi))


def gaussian_process(
    rng: np.random.Generator, duration_s: float = 10800.0, step_s: float = 0.25
) -> xarray.DataArray:
    """Draw a record of the spectrum above with normally distributed amplitudes at the lines of the whole
    record: it is Gaussian, with the exact variance on average."""
    count = int(duration_s / step_s)
    omega = 2 * np.pi * np.fft.rfftfreq(count, step_s)
    size = np.sqrt(density(omega) * (omega[1] - omega[0]))
    phasors = size * (rng.standard_normal(len(omega)) - 1j * rng.standard_normal(len(omega)))
    values = np.fft.irfft(phasors, count) * count / 2
    time = xarray.DataArray(step_s * np.arange(count), dims="time", attrs={"units": "s"})
    return xarray.DataArray(values, {"time": time}, ("time",), "heave", {"units": "m"})
