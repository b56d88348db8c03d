"""Compare results.h5 with the CSV tables of the same run, through h5py and through xarray with h5netcdf.

    python check_hdf5.py results.h5 folder_of_csv

Every variable of every group must have the same values (bit for bit), units, description and dimensions in both, and
every dimension must be recognised as a coordinate. What trips other tools is looked for too: coordinates a bit beside
their decimal, gaps that are not `_FillValue`, units that UDUNITS reads as something else, attributes called as a
dataset, a file that netCDF4 cannot append to; and what the CF conventions want: units, names, axes, coordinates in order. Needs what requirements.txt lists. Exits with 1 on any difference.
"""

import csv
import re
import shutil
import sys
import tempfile
from pathlib import Path

import cf_units
import h5py
import netCDF4
import numpy as np
import xarray as xr


def read_csv(path):
    """Comment lines as (key, text) pairs, then the rows of cells."""
    lines = path.read_text(encoding="utf-8").splitlines()
    comments = [line[2:].partition(": ")[::2] for line in lines if line.startswith("# ")]
    return comments, list(csv.reader(line for line in lines if not line.startswith("# ")))


def numbers(cells):
    return np.array([float(cell) for cell in cells], dtype=float)


def read_tables(folder):
    """{group: {heading: (values flattened row by row, description)}} of all CSV files in the folder."""
    groups = {}
    for path in sorted(Path(folder).glob("*.csv")):
        comments, (header, *rows) = read_csv(path)
        described = dict(comments)
        if "group" not in described:
            continue  # a table of texts, not of arrays
        found = groups.setdefault(described["group"], {})
        if path.stem.endswith("_scalars"):
            for name, value, units, description in rows:
                found[f"{name} [{units}]"] = (numbers([value]), description)
        elif path.stem.endswith("_matrix"):
            slow, fast = header[0].split(" \\ ")
            found.setdefault(fast, (numbers(header[1:]), None))
            found.setdefault(slow, (numbers(row[0] for row in rows), None))
            field = next(h for h in described if path.stem == f"{described['group']}_{h.split(' [')[0]}_matrix")
            found[field] = (np.concatenate([numbers(row[1:]) for row in rows]), described[field])
        else:
            for column, heading in enumerate(header):
                values = numbers(row[column] for row in rows)
                found.setdefault(heading, (values, described.get(heading)))
    return groups


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def compare(stored, dataset, name, tables):
    """The differences of one variable, as a list of texts."""
    variable, units, description = stored[name], text(stored[name].attrs["units"]), text(stored[name].attrs["long_name"])
    values = variable[()]
    differences = []
    if f"{name} [{units}]" not in tables:
        return ["not in any CSV"]
    listed, listed_description = tables[f"{name} [{units}]"]
    if variable.ndim == 1 and variable.is_scale and len(listed) != values.size:
        # A coordinate beside a field is repeated in the long table.
        listed, values = np.unique(listed), np.unique(values)
    if not np.array_equal(np.ravel(values), listed, equal_nan=True):
        differences.append("values differ between HDF5 and CSV")
    if listed_description is not None and description != listed_description:
        differences.append("descriptions differ between HDF5 and CSV")
    seen = dataset.variables[name]
    if not np.array_equal(seen.values, variable[()], equal_nan=True):
        differences.append("values differ between xarray and h5py")
    if seen.attrs["units"] != units or seen.attrs["long_name"] != description:
        differences.append("units or description differ between xarray and h5py")
    for axis, dimension in enumerate(seen.dims):
        if dimension not in dataset.coords:
            differences.append(f"xarray does not take {dimension} for a coordinate")
        if not variable.is_scale and [key for key in variable.dims[axis].keys()] != [dimension]:
            differences.append(f"h5py finds no scale {dimension} on axis {axis}")
    return differences


def misread(units):
    """True for units that UDUNITS takes for others: it reads a broken power as a factor. None of those it refuses."""
    try:
        return cf_units.Unit(units).definition[:1].isdigit() and units != "1"
    except ValueError:
        return None


def traps(group):
    """What would mislead a reader of the group, as a list of texts."""
    found = [f"the attribute {name} is called as a dataset" for name in group.attrs if name in group]
    for name, stored in group.items():
        values, units = np.atleast_1d(stored[()]), text(stored.attrs["units"])
        if misread(units):
            found.append(f"{name}: UDUNITS takes {units} for {cf_units.Unit(units).definition}")
        if np.isnan(values).any() and not np.isnan(stored.attrs.get("_FillValue", 0.0)):
            found.append(f"{name}: NaN is not its _FillValue")
        if stored.ndim == 1 and stored.is_scale and values.size:
            decimals = np.round(values, 9)
            beside = (values != decimals) & (np.abs(values - decimals) < 1e-14 * np.abs(values).max())
            found += [f"{name}: {value!r} lies beside its decimal" for value in values[beside]]
    return found


def conventions(results):
    """What the CF conventions and the data model of NetCDF-4 miss, as a list of texts."""
    found = []
    with netCDF4.Dataset(results) as file:
        if file.data_model != "NETCDF4" or "CF-1.8" not in file.Conventions:
            found.append(f"{file.data_model}, {file.Conventions}")
        for group in file.groups.values():
            for name, variable in group.variables.items():
                called = f"{group.name}/{name}"
                # of a study they are the paths of keys, dots and brackets among them, which NetCDF-4 bears and CF advises against
                plain = re.sub(r"[.\[\]]", "_", name) if group.name == "study" else name
                if not plain.isidentifier() or not plain.isascii() or not variable.long_name:
                    found.append(f"{called}: its name or its long_name")
                # UDUNITS knows no decibels and no broken powers
                unknown = variable.units.startswith("dB") or "^(" in variable.units
                if not unknown and misread(variable.units) is None:
                    found.append(f"{called}: UDUNITS does not know {variable.units}")
                values = np.ma.atleast_1d(variable[:])
                if np.isnan(values.compressed()).any():
                    found.append(f"{called}: what is absent is not masked")
                if variable.dimensions == (name,) and values.size > 1:
                    steps = np.diff(values)
                    if np.ma.count_masked(values) or not (np.all(steps > 0) or np.all(steps < 0)):
                        found.append(f"{called}: a coordinate with gaps or turns")
                axis = {"x": "X", "y": "Y", "z": "Z"}.get(name)
                if variable.dimensions == (name,) and axis and variable.axis != axis:
                    found.append(f"{called}: its axis is not {axis}")
    return found


def appended(results):
    """Adds a variable with netCDF4, in a copy, and reads it back beside those that were there: what went wrong, or None."""
    with tempfile.TemporaryDirectory() as folder:
        copy = shutil.copy(results, folder)
        try:
            with netCDF4.Dataset(copy, "a") as file:
                for group in file.groups.values():
                    before = len(group.variables)
                    dimensions = list(group.dimensions)[:1]
                    group.createVariable("appended", "f8", dimensions)[:] = 7.0
                    if len(group.variables) != before + 1:
                        return f"{group.name} has {len(group.variables)} variables"
            with netCDF4.Dataset(copy) as file:
                for group in file.groups.values():
                    if not np.all(group["appended"][:] == 7.0):
                        return f"{group.name}: what was appended is not there"
        except OSError as error:
            return str(error)
    return None


def main(results, folder):
    tables = read_tables(folder)
    wrong = 0
    with h5py.File(results) as file:
        for group in file:
            with xr.open_dataset(results, group=group, engine="h5netcdf") as dataset:
                count = 0
                for name in file[group]:
                    for difference in compare(file[group], dataset, name, tables.get(group, {})):
                        print(f"{group}/{name}: {difference}")
                        wrong += 1
                    count += file[group][name].size
                held = {f"{name} [{text(stored.attrs['units'])}]" for name, stored in file[group].items()}
                for heading in sorted(set(tables.get(group, {})) - held):
                    print(f"{group}: the column {heading} is in a CSV file but not in {results}")
                    wrong += 1
                for trap in traps(file[group]):
                    print(f"{group}: {trap}")
                    wrong += 1
                print(f"{group}: {', '.join(file[group])}: {count} values compared")
        missing = sorted(set(tables) - set(file))
        if missing:
            print(f"in the CSV files but not in {results}: {', '.join(missing)}")
            wrong += len(missing)
        if not len(file):
            print(f"{results} has no group")
            wrong += 1
    for fault in conventions(results):
        print(f"CF and NetCDF-4: {fault}")
        wrong += 1
    if fault := appended(results):
        print(f"netCDF4 cannot append: {fault}")
        wrong += 1
    print(f"{wrong} differences")
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
