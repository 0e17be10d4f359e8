"""B-spline surfaces and curves with the fewest control points that meet a tolerance.

    import knotfit
    fit = knotfit.fit(xyz, uv, tol="0.1%")
    if fit.reached:
        z = fit.surface(u, v)

Every call takes arrays (NumPy, and what turns into it: lists, pandas, xarray) and gives arrays. A caller's mistake is a
ValueError or TypeError; a tolerance that is not met is a status of the fit and a KnotfitWarning. Results do not depend
on the number of threads. The whole is told in docs/python.md.
"""

from ._core import FileError, WriteError, __version__
from ._errors import Interrupted, KnotfitWarning, ToleranceMissed
from ._run import Progress
from .comparison import Comparison, compare
from .curve import Curve, CurveFit, fit_curve
from .files import MeshData, PointData, RasterData, load
from .fit import Fit, fit
from .mesh import Parameterization, fit_mesh, parameterize
from .placement import Knots, methods, place_knots
from .raster import fit_raster
from .surface import ClosestPoints, Curvature, Distances, Surface, SurfaceDerivative

__all__ = [
    "ClosestPoints", "Comparison", "Curvature", "Curve", "CurveFit", "Distances", "FileError", "Fit", "Interrupted",
    "KnotfitWarning", "Knots", "MeshData", "Parameterization", "PointData", "Progress", "RasterData", "Surface",
    "SurfaceDerivative", "ToleranceMissed", "WriteError", "__version__", "compare", "fit", "fit_curve", "fit_mesh",
    "fit_raster", "load", "methods", "parameterize", "place_knots",
]
