"""How fast may a train go before ground and track resonate? The paper's ballasted track over 2 m of soft soil."""

# %% ground, track and train by their names in the library
import groundwave as gw

soil = gw.Soil("lamprea2022_layered")
track = gw.Track("lamprea2022_ballasted")
train = gw.Train("lamprea2022_axle")
print(soil.layers.to_dataframe()[["thickness", "shear_speed", "rayleigh_speed"]])

# %% largest rail deflections against speed
curve = gw.critical_speed(soil=soil, track=track, train=train, speeds=slice(20, 200, 5), line_speed="300 km/h")
print(curve.max_down.to_series().head())
told = gw.answers(curve)
print(f"critical speed {3.6 * told['critical_speed']:.0f} km/h, amplification {told['amplification']:.2f}")
assert abs(told["critical_speed"] - 137.3) < 0.2

# %% what a softer pad does
softer = gw.critical_speed(soil=soil, track=gw.Track("lamprea2022_ballasted", pad={"stiffness": 1e8}), train=train,
                           speeds=slice(20, 200, 5))
print(f"with soft pads {3.6 * gw.answers(softer)['critical_speed']:.0f} km/h")
