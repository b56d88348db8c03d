"""Which waves travel along layered ground, and where does the track's wave meet them?"""

# %%
import groundwave as gw

soil = gw.Soil(
    layer=[{"name": "clay", "thickness": 3.0, "shear_speed": 90.0, "poisson": 0.49, "density": 1650.0, "damping_ratio": 0.03}],
    half_space={"name": "till", "shear_speed": 300.0, "poisson": 0.4, "density": 2000.0, "damping_ratio": 0.02},
)

# %% phase velocities of three modes; what has no mode is NaN
waves = soil.dispersion(f=slice(2, 40, 2), modes=3)
print(waves.phase_velocity.to_pandas().round(1))
assert waves.phase_velocity.isel(mode=0).min() > 80

# %% how the ground moves over depth, at 10 Hz
shapes = soil.dispersion(f=[10.0], modes=1, shapes={"frequencies": [10.0], "z": slice(0, 6, 1)})
print([name for name in shapes.data_vars if "shape" in name])

# %% with a track on it: where the two meet
met = gw.dispersion(soil=soil, track="lamprea2022_ballasted", frequencies=slice(1, 40, 1))
print(gw.answers(met))
