"""The compliance of the ground's surface: the kernel of everything else."""

# %% near the wavenumber of the Rayleigh wave it is largest
import numpy as np
import groundwave as gw

soil = gw.Soil("lamprea2022_half_space")
table = soil.compliance(k=np.linspace(0.1, 2.0, 40), f=[20.0])
largest = np.abs(table.u_zz).idxmax("k").item()
rayleigh = 2 * np.pi * 20.0 / soil.layers.rayleigh_speed.item()
print(f"largest at k = {largest:.2f} rad/m, Rayleigh wave {rayleigh:.2f} rad/m")
assert abs(largest - rayleigh) < 0.06
