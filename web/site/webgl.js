/** Whether the browser has what the sketches draw with. */
export const hasWebGL = Boolean(document.createElement('canvas').getContext('webgl2'))
