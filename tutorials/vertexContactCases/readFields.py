"""Read the point fields of a case, as ParaView does: through VTK's reader of
OpenFOAM cases, opened on case.foam."""

from math import isclose
from pathlib import Path

import numpy as np
import pyvista


class Reader:
    """The regions of a case, serial (or reconstructed) or decomposed."""

    def __init__(self, case, decomposed=False):
        file = Path(case)/"case.foam"
        file.touch()
        self.case = file.parent
        self.vtk = pyvista.POpenFOAMReader(str(file))
        self.vtk.case_type = "decomposed" if decomposed else "reconstructed"

    @property
    def times(self):
        return list(self.vtk.time_values)

    @property
    def regions(self):
        """Names of the regions; the name of a single region without a name is
        ''."""
        return [name.rpartition("/")[0].strip("/")
                for name in self.vtk.patch_array_names
                if name.endswith("internalMesh")]

    @property
    def plane(self):
        """Whether the case is two- or one-dimensional."""
        return any(name.endswith("group/empty")
                   for name in self.vtk.patch_array_names)

    def near(self, times):
        """Those of the times that are written, with their written names."""
        return [written for written in self.times
                if any(isclose(written, t, rel_tol=1e-6) for t in times)]

    def read(self, time, part="internalMesh", fields=None):
        """{region: data set} at a written time, for the internalMesh, or for a
        patch in all regions that have it, with all or some point fields."""
        vtk = self.vtk
        vtk.disable_all_patch_arrays()
        for name in vtk.patch_array_names:
            if name.rpartition("/")[2] == part and "/group/" not in name:
                vtk.enable_patch_array(name)
        vtk.set_active_time_value(time)
        vtk.disable_all_point_arrays()
        for name in vtk.point_array_names if fields is None else fields:
            vtk.enable_point_array(name)

        data = vtk.read()
        found = {}
        for region in self.regions:
            body = data[region] if region else data
            if part != "internalMesh":
                body = body["boundary"] if "boundary" in body.keys() else {}
            if part in body.keys() and body[part] is not None:
                found[region] = body[part]
        return found


def deformed(body):
    """A data set at its current position; pointD is 0 if no pointD is
    written."""
    if "pointD" not in body.point_data:
        return body.copy()
    moved = body.copy()
    moved.points = (np.asarray(body.points, dtype=float)
                    + np.asarray(body.point_data["pointD"], dtype=float))
    return moved
