"""How much vibration does a train on a rough rail send to a house?"""

# %%
import groundwave as gw

shaken = gw.free_field(
    soil="lamprea2022_half_space", track="lamprea2022_ballasted",
    train=gw.Train("lamprea2022_axle", unsprung_mass=2003.0, wheel_rail={"stiffness": 1.94e9}),
    irregularity={"kind": "fra-break-wavenumber", "class": 5, "wavelengths": slice(1.0, 20.0), "profiles": 1},
    speed="150 km/h", receivers=[12.0], frequencies=slice(4, 31.5),
)
print((1e6 * shaken.v_rms_total).to_pandas().round(2))
print({key: f"{value:.3g}" for key, value in gw.answers(shaken).items()})
assert shaken.v_rms_total.max() > 0
