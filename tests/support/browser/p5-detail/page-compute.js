// Compares sketches of p5 that use compute passes with sketches that use only the CPU. What the functions check:
// - `approach`: buffers grow while the camera approaches a shape;
// - `divide`: passes divide shapes as the CPU does;
// - `redrawOften`: `redraw(3)` ends with the same picture as three calls of `redraw`;
// - `refine`: a shape is divided anew once its waves become shorter;
// - `resemble`: coarse shapes that passes divide look like dense ones;
// - `compareAround`: so does a box, seen from all sides;
// - `begin`: passes take over a kind of shape from the CPU;
// - `leave`: passes leave a shape to the CPU in those frames in which they cannot divide it;
// - `life`: buffers are freed and replaced together with their shape.
import { approach, divide, redrawOften, refine, resemble } from './against-cpu.js'
import { compareAround } from './all-sides.js'
import { begin, leave, life } from './takeover.js'

globalThis.compute = {
  ...{ approach, divide, redrawOften, refine, resemble },
  compareAround,
  ...{ begin, leave, life },
}
