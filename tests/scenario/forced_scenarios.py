"""A scenario that says everything of forces that can be said."""

BOX = {"width": 20, "height": 20, "periodic": ["x", "y"]}
ATOM = {"name": "atom", "radius": 0.5, "count": 40, "temperature": 0.45}
FULL = {
    "container": BOX,
    "species": [
        {**ATOM, "epsilon": 1.0, "sigma": 1.1, "charge": 0.5},
        {"name": "ion", "radius": 0.4, "count": 5, "temperature": 0.3, "charge": -1.0},
    ],
    "dynamics": {"kind": "forced", "time_step": 0.004},
    "forces": {
        "law": "yukawa",
        "cutoff": 4.0,
        "truncation": "force-shifted",
        "screening_length": 1.5,
        "pairs": [{"between": ["atom", "ion"], "law": "square-well", "reach": 1.4, "cutoff": 1.9}],
        "charges": {"strength": 2.0, "screening_length": 1.0, "cutoff": 3.0},
    },
    "thermostat": {"kind": "langevin", "temperature": 0.45, "time": 2.0},
    "barostat": {"pressure": 0.02, "time": 20.0},
    "heating": {"power": 0.0005},
    "units": {"name": "argon", "length": 3.405e-10, "energy": 1.654e-21, "mass": 6.634e-26},
    "frame_interval": 0.04,
    "schedule": [
        {"at": 1, "thermostat": {"temperature": 0.3, "over": 500}},
        {"at": 9, "thermostat": "off"},
        {"at": 9, "barostat": {"pressure": 0.03}},
        {"at": 9, "barostat": "off"},
        {"at": 10, "heating": {"power": -0.001}},
    ],
}
