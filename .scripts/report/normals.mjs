// Measures normals at pixels: their angles to the exact normals on p5's sphere, and how the light of coarse spheres differs from that of a
// fine one.
import { measureAngles } from './normals/angles.mjs'
import { measureLight } from './normals/light.mjs'

export const measure = async () => ({ angles: measureAngles(), ...(await measureLight()) })
