"""What shape has the rail under a train, below and at the critical speed? And over sleepers that stand apart?"""

# %%
import groundwave as gw

line = {"soil": "lamprea2022_layered", "track": "lamprea2022_ballasted", "train": "lamprea2022_axle"}
shapes = gw.track_response(**line, speeds=[68.5, 137.0], x=slice(-30, 10), spacing=0.2)
print((1e3 * shapes.rail.max("x")).to_series().rename("largest downward deflection [mm]"))
assert shapes.rail.sel(speed=137.0).max() > 1.5 * shapes.rail.sel(speed=68.5).max()

# %% histories over a support and in the middle of a bay, on springs
springs = gw.Springs("winkler", stiffness=1.0e8, loss_factor=0.1)
track = gw.Track(kind="beam", beam={"bending_stiffness": 6.38e6, "mass": 60.23}, support={"spacing": 0.6})
over = gw.track_response(foundation=springs, track=track, train="lamprea2022_axle", speeds=[50.0], at=[0.0, 0.3])
print((1e3 * over.rail.max("distance")).to_series())
