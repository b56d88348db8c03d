"""How much do rail and ground move under a standing harmonic load?"""

# %%
import numpy as np
import groundwave as gw

answer = gw.receptance(soil="lamprea2022_layered", track="lamprea2022_ballasted",
                       frequencies=slice(5, 80, 5), receivers=[10.0, 20.0])
print((1e9 * np.abs(answer.rail)).to_series().rename("rail [nm/N]").head())

# %% the ground beside it, in decibels from 10 to 20 m
loss = 20 * np.log10(np.abs(answer.ground.sel(receiver=10.0) / answer.ground.sel(receiver=20.0)))
print(loss.to_series().round(1).head())
assert (np.abs(answer.ground.sel(receiver=10.0)) > np.abs(answer.ground.sel(receiver=20.0))).mean() > 0.5
