"""Compare the .vti and .vtr files of a run with results.h5, through VTK, which ParaView reads with.

    python check_vti.py folder_of_results

Every array must have the values of its part of results.h5, bit for bit, and every grid the places. Needs what
requirements.txt lists. Exits with 1 on any difference, or if there is no such file.
"""

import itertools
import sys
from pathlib import Path

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLRectilinearGridReader


def read(path):
    """The grid of a file, and its places along x, y, z."""
    reader = vtkXMLImageDataReader() if path.suffix == ".vti" else vtkXMLRectilinearGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    if path.suffix == ".vtr":
        return grid, [vtk_to_numpy(axis) for axis in (grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates())]
    along = zip(grid.GetOrigin(), grid.GetSpacing(), grid.GetDimensions())
    return grid, [origin + spacing * np.arange(count) for origin, spacing, count in along]


def main(folder):
    wrong = compared = 0
    with h5py.File(Path(folder) / "results.h5") as file:
        for path in sorted(p for p in Path(folder).iterdir() if p.suffix in (".vti", ".vtr")):
            group = next(g for g in file if path.stem.startswith(g + "_") and path.stem[len(g) + 1 :] in file[g])
            name = path.stem[len(group) + 1 :]
            stored = file[group][name]
            dims = [text for text in stored.attrs["dimensions"].split()]
            grid, places = read(path)
            for axis, place in zip("xyz", places):
                exact = file[group][axis][()] if axis in dims else np.zeros(1)
                # origin + i × spacing instead of the stored value: rounding
                if place.shape != exact.shape or not np.allclose(place, exact, rtol=0, atol=1e-9):
                    print(f"{path.name}: places along {axis} differ")
                    wrong += 1
            outer = [d for d in dims if d not in "xyz"]
            count = 0
            for index in itertools.product(*(range(file[group][d].size) for d in outer)):
                at = [f"_{d}_" + repr(round(float(file[group][d][i]), 4)).removesuffix(".0") for d, i in zip(outer, index)]
                called = name + "".join(at)
                array = grid.GetPointData().GetArray(called)
                if array is None or not np.array_equal(vtk_to_numpy(array), stored[index].ravel(), equal_nan=True):
                    print(f"{path.name}: {called} differs")
                    wrong += 1
                count += 1
            if count != grid.GetPointData().GetNumberOfArrays():
                print(f"{path.name}: {grid.GetPointData().GetNumberOfArrays()} arrays for {count} fields")
                wrong += 1
            compared += count
    print(f"{compared} fields compared, {wrong} differences")
    return 1 if wrong or not compared else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
