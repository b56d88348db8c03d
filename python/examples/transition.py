"""What does a change of track do to waves along the rail?"""

# %% the second section stands on pads five times as stiff
import groundwave as gw

track = gw.Track(
    kind="ballasted", rails=1, rail={"bending_stiffness": 6.38e6, "mass": 60.23}, pad={"stiffness": 3.5e8, "damping": 1.92e4},
    sleeper={"mass": 245.0}, ballast={"kind": "spring", "stiffness": 1.8e8, "damping": 2.34e5}, support={"spacing": 0.6},
    section=[{}, {"pad": {"stiffness": 1.75e9, "damping": 1.92e4}}],
)
power = gw.transition(foundation=gw.Springs("rigid"), track=track, frequencies=slice(400, 1000, 100), along=[600.0])
print(power[["reflected", "transmitted"]].to_dataframe().round(4))
assert float(power.reflected.max()) < 1
