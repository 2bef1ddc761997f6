/** What stands in the picture's place where the browser has no WebGL: the example's own picture, and why. */
import { make } from '../bench/dom.js'

export const hasWebGL = Boolean(document.createElement('canvas').getContext('webgl2'))

/** `example` is the name of the one that is chosen, if one is. */
export const showStill = (place, example) =>
  place.replaceChildren(
    make('img', {
      className: 'still',
      src: example ? `../posters/${example}.webp` : '../site/hero.webp',
      alt: '',
    }),
    make('p', {
      className: 'empty',
      textContent: example
        ? 'This browser has no WebGL: here is a picture of the example.'
        : 'This browser has no WebGL, and cannot draw what you write: open this page in another one.',
    }),
  )
