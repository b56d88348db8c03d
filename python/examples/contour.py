"""What does the ground's surface do around a fast axle? A map in the moving frame."""

# %%
import groundwave as gw

maps = gw.contour(
    soil="lamprea2022_layered", track="lamprea2022_ballasted", train="lamprea2022_axle",
    speeds=[137.0], x=slice(-20, 10), y=slice(-10, 10), spacing=1.0,
)
field = next(iter(maps.data_vars.values())).squeeze()
deepest = field.where(field == field.max(), drop=True)
print(f"deepest {1e3 * float(field.max()):.2f} mm at x = {float(deepest.x[0])} m, y = {float(deepest.y[0])} m")
assert abs(float(deepest.y[0])) < 2
