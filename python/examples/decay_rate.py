"""How fast does vibration die away along the rail, and how much does the pad matter?"""

# %%
import groundwave as gw


def rates(pad):
    track = gw.Track(
        kind="ballasted", rails=1, rail={"section": "60E1", "loss_factor": 0.02}, pad={"stiffness": pad, "loss_factor": 0.25},
        sleeper={"mass": 245.0}, ballast={"kind": "spring", "stiffness": 1.8e8, "loss_factor": 1.0}, support={"spacing": 0.6},
    )
    third_octaves = {"from": 100.0, "to": 5000.0, "bands": "third-octave"}
    return gw.decay_rate(foundation=gw.Springs("rigid"), track=track, frequencies=third_octaves).decay


soft, stiff = rates(1.5e8), rates(1.2e9)
print(soft.to_series().round(2).head(8))

# %% stiff pads keep more of the rail quiet around 500 Hz
assert stiff.sel(frequency=500, method="nearest") > soft.sel(frequency=500, method="nearest")
