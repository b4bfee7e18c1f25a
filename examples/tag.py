"""Tag: one disc is it, and whoever it hits is it from then on. Run it: python examples/tag.py"""

import numpy as np

import gasbox
from gasbox.scenario import parse
from gasbox.state import ContactKind, SetParticles


class Tag:
    interval = 0.1  # simulated time from one turn to the next
    reads_contacts = True

    def __init__(self):
        self.it, self.shown, self.pause = 0, 0, 0.5
        self.times = [0.0]  # when somebody became it

    def start(self, state, geometry):
        return [SetParticles(np.array([self.it]), species=np.array([1]))]

    def read(self, contacts):
        for row in np.flatnonzero(contacts.kind[: contacts.count] == ContactKind.PAIR):
            pair = int(contacts.first[row]), int(contacts.second[row])
            if self.it in pair and contacts.time[row] >= self.times[-1] + self.pause:
                self.it = pair[1] if self.it == pair[0] else pair[0]
                self.times.append(float(contacts.time[row]))

    def act(self, state, geometry):
        change = SetParticles(np.array([self.shown, self.it]), species=np.array([0, 1]))
        changed, self.shown = self.it != self.shown, self.it
        return [change] if changed else []

    def take(self, change):
        if change.name != "pause":
            raise gasbox.UsageError(f"there is no setting {change.name}; there is: pause")
        self.pause = change.value

    def memory(self):
        return {"it": self.it, "shown": self.shown, "pause": self.pause, "times": np.array(self.times)}

    def recall(self, memory):
        self.it, self.shown, self.pause = int(memory["it"]), int(memory["shown"]), float(memory["pause"])
        self.times = np.asarray(memory["times"], np.float64).tolist()

    def summary(self):
        return {"it": self.it, "tags": len(self.times) - 1}

    def series(self):
        return {"time": np.array(self.times), "tags": np.arange(len(self.times), dtype=np.float64)}

    def view(self):
        return self.summary()


if __name__ == "__main__":
    kinds = [{"name": "free", "radius": 0.5, "count": 100, "temperature": 1}, {"name": "it", "radius": 0.5}]
    yard = {"container": {"width": 40, "height": 30}, "species": kinds, "seed": 1}
    simulation = gasbox.Simulation(parse(yard), world=Tag())
    simulation.advance(until=100.0)
    print(simulation.summary()["world"])
