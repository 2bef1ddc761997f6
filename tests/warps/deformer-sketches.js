// The sketches of deformers as plain functions of numbers; see gallery.js.
import { add } from '../support/browser/matrix.js'
import { deformers } from './deformers.js'

const { cos, max, sin } = Math

const {
  bend,
  bulge,
  genie,
  inflate,
  melt,
  noiseDisplace,
  ripple,
  shear,
  spherify,
  stretch,
  taper,
  twist,
  wave,
} = deformers

const times = (v, factor) => v.map((x) => x * factor)
const smoothstep = (low, high, x) => {
  const t = max(0, Math.min(1, (x - low) / (high - low)))
  return t * t * (3 - 2 * t)
}

/** Makes an offset of a deformer whose options depend on the inputs. */
const withInputs = (deformer, options) => (p, inputs) =>
  deformer(options(inputs.millis, p))(p, inputs)

const swing = (millis) => cos(millis / 1500)
const twisted = withInputs(twist, (millis) => ({ length: 150, angle: 2.6 * swing(millis) }))
const bent = withInputs(bend, (millis) => ({ from: -75, to: 75, angle: 2.1 * swing(millis) }))
const compose = (a, b) => (p, inputs) => {
  const first = a(p, inputs)
  return add(first, b(add(p, first), inputs))
}

// Points within the bar: the errors of a GPU's sine grow with the distance from the middle of the bar.
const bar = { size: 21 }

export const deformerSketches = {
  'deformer-twist': {
    size: 100,
    offset: withInputs(twist, (millis) => ({ angle: 2.8 * cos(millis / 1200) })),
  },
  'deformer-bend': {
    size: 190,
    offset: withInputs(bend, (millis) => ({ from: -90, to: 90, angle: 2.6 * sin(millis / 1300) })),
  },
  'deformer-taper': {
    size: 100,
    offset: withInputs(taper, (millis) => ({
      center: [0, 60, 0],
      length: 160,
      amount: -0.9 * sin(millis / 1000),
    })),
  },
  'deformer-bulge': {
    size: 250,
    offset: withInputs(bulge, (millis) => ({
      axis: 'x',
      center: [800 * ((millis / 3000) % 1) - 400, 0, 0],
      radius: 110,
      amount: 1.4,
    })),
  },
  'deformer-stretch': {
    size: 100,
    offset: withInputs(stretch, (millis) => ({
      center: [0, 100, 0],
      keepVolume: true,
      amount: 0.45 * sin(millis / 350),
    })),
  },
  'deformer-wave': {
    size: 200,
    offset: wave({ axis: [1, 0, 0.4], amount: 28, wavelength: 240, speed: 130 }),
  },
  'deformer-ripple': {
    size: 250,
    offset: ripple({ axis: 'y', amount: 16, wavelength: 75, speed: 60, radius: 300 }),
  },
  'deformer-melt': {
    size: 100,
    offset: withInputs(melt, (millis) => ({
      height: 60,
      amount: 0.42 + 0.42 * sin(millis / 1400),
    })),
  },
  'deformer-inflate': {
    size: 100,
    offset: withInputs(inflate, (millis, [, y]) => ({
      amount: 2 + 4 * sin(y / 16 - millis / 300),
    })),
  },
  'deformer-noise': {
    // With this size, vertices are not at the borders of cells, where noise has no third derivative and finite differences are inaccurate.
    size: 130,
    offset: noiseDisplace({ amount: 55, scale: 75, speed: 0.4 }),
  },
  'deformer-genie': {
    size: 150,
    offset: withInputs(genie, (millis) => ({
      center: [90, 215, 0],
      length: 400,
      neck: 0.06,
      amount: 0.6 - 1.2 * Math.abs(((millis / 5000) % 1) - 0.5),
    })),
  },
  'deformer-spherify': {
    size: 100,
    offset: withInputs(spherify, (millis) => ({
      radius: 75,
      amount: max(0, 0.4 + 0.45 * sin(millis / 1200)),
    })),
  },
  'deformer-shear': {
    size: 150,
    offset: withInputs(shear, (millis) => ({
      center: [0, 60, 0],
      amount: 0.7 * sin(millis / 700),
    })),
  },

  'composition-twist': { ...bar, offset: twisted },
  'composition-bend': { ...bar, offset: bent },
  'composition-twistthenbend': { ...bar, offset: compose(twisted, bent) },
  'composition-bendthentwist': { ...bar, offset: compose(bent, twisted) },
  'composition-sum': { ...bar, offset: (p, i) => add(twisted(p, i), bent(p, i)) },
  'composition-halfway': { ...bar, offset: (p, i) => times(add(twisted(p, i), bent(p, i)), 0.5) },
  'composition-above': {
    ...bar,
    offset: (p, i) => times(twisted(p, i), smoothstep(20, -20, p[1])),
  },
  'composition-aside': { ...bar, offset: (p, i) => twisted(add(p, [25, 0, 0]), i) },
}
