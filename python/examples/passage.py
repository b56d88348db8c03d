"""A wheel with a flat strikes a sleeper: the contact force in time."""

# %%
import groundwave as gw

track = gw.Track(
    kind="ballasted", rails=1, rail={"bending_stiffness": 6.38e6, "mass": 60.23}, pad={"stiffness": 3.5e8, "damping": 1.92e4},
    sleeper={"mass": 245.0}, ballast={"kind": "spring", "stiffness": 1.8e8, "damping": 2.34e5}, support={"spacing": 0.6},
)
train = gw.Train(axles=[{"position": 0.0, "load": 150e3}], unsprung_mass=1200.0, wheel_rail={"radius": 0.46})
flat = {"kind": "rounded-flat", "at": 3.0, "wheels": [1], "radius": 0.46, "length": 0.05, "depth": 0.34e-3}
passed = gw.passage(foundation=gw.Springs("rigid"), track=track, train=train, speed="80 km/h",
                    from_=0.0, to=5.0, at=[3.0], defect=[flat])
print(gw.answers(passed))
force = next(passed[name] for name in passed.data_vars if name.startswith("contact_force"))
print(f"largest contact force {float(force.max()) / 1e3:.0f} kN, {75:.0f} kN at rest")
assert float(force.max()) > 100e3
