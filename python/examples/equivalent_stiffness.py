"""How stiff is layered ground under a track, at which wavelength and frequency?"""

# %%
import groundwave as gw

table = gw.Soil("lamprea2022_layered").equivalent_stiffness(beta=[0.05, 0.2, 1.0], f=slice(0, 40, 10), half_width=1.25)
print((1e-6 * table.k_eq.real).to_pandas().round(1))

# %% energy goes into the ground, never out of it
assert (table.k_eq.isel(omega=slice(1, None)).imag > 0).all()
