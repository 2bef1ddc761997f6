// Measures normals at pixels: their angles to exact ones on p5's sphere, and the light of coarse spheres against that of a fine one.
import { measureAngles } from './normals/angles.mjs'
import { measureLight } from './normals/light.mjs'

export const measure = async () => ({ angles: measureAngles(), ...(await measureLight()) })
