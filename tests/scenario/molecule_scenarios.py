"""A gas in which every key of molecules is used."""

FULL_OF_MOLECULES = {
    "container": {"width": 80, "height": 60, "periodic": ["y"]},
    "species": [{"name": "argon", "radius": 0.5, "count": 5, "temperature": 1}],
    "molecules": [
        {"name": "nitrogen", "model": "nitrogen", "scale": 0.5, "count": 4, "temperature": 1},
        {
            "name": "bent",
            "atoms": [
                {"position": [0, 0], "mass": 3, "radius": 0.6, "color": "#112233", "charge": -0.4},
                {"position": [0.7, 0.5], "radius": 0.3, "epsilon": 0.5, "sigma": 0.6, "charge": 0.2},
                {"position": [-0.7, 0.5], "species": "argon"},
            ],
            "bonds": [{"atoms": [0, 1], "length": 0.9}, {"atoms": [0, 2]}],
            "inertia": 2.5,
            "color": "#445566",
            "count": 4,
            "temperature": 1,
            "rotational_temperature": 0.5,
            "region": {"x": [10, 60], "y": [5, 50]},
        },
        {"name": "stick", "atoms": [{"position": [k, 0]} for k in range(3)], "speed": 2, "angular_speed": 1},
    ],
    "particles": [
        {"species": "stick", "position": [70, 30], "velocity": [1, 0], "angle": 0.3, "angular_velocity": 2}
    ],
    "obstacles": [{"shape": "segment", "start": [40, 0], "end": [40, 60], "passes": ["nitrogen"]}],
    "dynamics": {"kind": "event-driven"},
}

FLEXIBLE = {
    "container": {"width": 80, "height": 60, "periodic": ["x", "y"]},
    "molecules": [
        {
            "name": "water",
            "model": "water",
            "bonds": [{"atoms": [0, 1], "stiffness": 100}, {"atoms": [0, 2], "stiffness": 100, "length": 1}],
            "angles": [{"atoms": [1, 0, 2], "stiffness": 5, "angle": 110}],
            "count": 5,
            "temperature": 1,
        }
    ],
    "forces": {"charges": {"strength": 1}},
    "dynamics": {"kind": "forced", "time_step": 0.001},
}
