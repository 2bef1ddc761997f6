/** What a visitor needs to know of each method: a sentence, and a colour that is its own on every plot. */

/**
 * In the order of the legend. The colours keep apart for eyes without red, green or blue receptors too: at least 0.1 in OKLab
 * between any two.
 */
export const notes = {
  'no warp': {
    color: '#80858f',
    text: 'The mesh as it is: what the vertices and pixels cost before any warp.',
  },
  'positions only': {
    color: '#f4f5fa',
    text: 'The vertices move and the normals stay. The cheapest warp, and lit as if nothing had moved.',
  },
  warpjet: {
    color: '#ff8a5b',
    text: 'Normals by the exact derivative of the offset, which warpjet works out and writes into the shader.',
  },
  'central differences': {
    color: '#b9a8ff',
    text: 'The offset five times, at the vertex and a step h to either side. Too large a step blurs, too small a one drowns in rounding.',
  },
  'forward differences': {
    color: '#4a7dff',
    text: 'The offset three times, at the vertex and a step h along the surface: cheaper than central differences, and less exact.',
  },
  dFdx: {
    color: '#43c6ac',
    text: 'Each pixel asks how the position changes towards its neighbours: every triangle shows as a flat facet.',
  },
  'by hand': {
    color: '#ffdc7a',
    text: 'Derivatives that somebody worked out on paper and wrote in GLSL: exact, until the warp changes.',
  },
}

export const methodNames = Object.keys(notes)
