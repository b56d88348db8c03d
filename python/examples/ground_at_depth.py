"""How much is the ground strained below the track, at rest and at speed?"""

# %% a light axle, below the strain from which soil softens
import groundwave as gw

states = gw.ground_at_depth(
    soil="lamprea2022_layered", track="lamprea2022_ballasted", train=gw.Train(axles=[{"position": 0.0, "load": 20e3}]),
    speeds=[60.0], z=[0.5, 1.0, 2.0, 4.0], x=slice(-6, 4), spacing=0.5,
)
print(states)
assert states.sizes["z"] == 4
