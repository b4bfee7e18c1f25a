// What is drawn of each kind of world, and what it hears of keys and pointers. A class for each kind:
//   constructor(lab, send): send(name, value) gives a setting another value, at once
//   hear(view): what the world shows now, as its `view` in Python
//   draw(context, scene): over discs and walls
//   key(event, down) and pointer(x, y, event): whether it was for the world; x, y in the box [length]
//   destroy()
//   static LEAST: CSS pixels, the least radius with which people or discs are drawn
// All but the constructor and `draw` may be left out.
import { DemonWorld } from "./demon.js";
import { EpidemicWorld } from "./epidemic.js";
import { PongWorld } from "./pong.js";

export const WORLDS = { pong: PongWorld, epidemic: EpidemicWorld, demon: DemonWorld };
