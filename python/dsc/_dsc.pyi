# The compiled part is internal. Its functions are called with arguments that the package has checked.
from typing import Any

class Complex2:
    def __getattr__(self, name: str) -> Any: ...
    from_bytes: Any
    from_polygons: Any
    from_triangles: Any
    from_image: Any
    from_function: Any

class Complex3:
    def __getattr__(self, name: str) -> Any: ...
    from_bytes: Any
    from_surfaces: Any
    from_tetrahedra: Any
    from_function: Any

class Fluid:
    def __init__(self, *arguments: Any) -> None: ...
    def __getattr__(self, name: str) -> Any: ...

def complex_from_image_3(*arguments: Any) -> Any: ...

class Film:
    def __init__(self, title: str, dimension: int, has_cells: bool) -> None: ...
    def __getattr__(self, name: str) -> Any: ...
