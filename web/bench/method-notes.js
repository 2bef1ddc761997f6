/** A description of each method for visitors, and its colour on every plot. */

/**
 * In the order of the legend. Any two colours differ by at least 0.1 in OKLab, also for viewers without red, green or blue
 * receptors.
 */
export const notes = {
  'no warp': {
    color: '#80858f',
    text: 'The mesh without a warp: the cost of its vertices and pixels alone.',
  },
  'positions only': {
    color: '#f4f5fa',
    text: 'The vertices move, the normals stay. The cheapest warp, lit as if nothing had moved.',
  },
  warpjet: {
    color: '#ff8a5b',
    text: 'Normals from the exact derivative of the offset, which warpjet computes and writes into the shader.',
  },
  'central differences': {
    color: '#b9a8ff',
    text: 'Evaluates the offset five times: at the vertex and a step h to either side. Too large a step blurs the normals, too small a step drowns them in rounding errors.',
  },
  'forward differences': {
    color: '#4a7dff',
    text: 'Evaluates the offset three times: at the vertex and a step h along the surface. Cheaper than central differences, and less exact.',
  },
  dFdx: {
    color: '#43c6ac',
    text: 'Each pixel takes the change of the position towards its neighbours, so every triangle looks like a flat facet.',
  },
  'by hand': {
    color: '#ffdc7a',
    text: 'Derivatives worked out on paper and written in GLSL: exact, until the warp changes.',
  },
}

export const methodNames = Object.keys(notes)
