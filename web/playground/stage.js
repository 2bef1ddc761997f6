/**
 * Runs sketches: a new one begins unseen behind the one that is shown, and takes its place once it has drawn. One that fails
 * before goes, and the last good picture stays.
 */
import { pageOf, tag } from './document.js'
import { guarded } from './guard.js'
import { hosts, isThree } from './hosts.js'

/** Where models and other files lie that a sketch asks for by name. */
const files = new URL('files/', location.href)
/** Whole, whatever the window leaves for it. */
const fit =
  '<style>canvas.p5Canvas { height: auto !important; max-height: 100vh; max-width: 100vw; width: auto !important }</style>'

const frameScript = (name) => tag(`../dist/${name}.js`)

/** What the sketch imports of warpjet goes through a module of the frame, which keeps what is made. */
const watched = (modules) => ({
  ...modules,
  'warpjet/itself': modules.warpjet,
  'warpjet/three/itself': modules['warpjet/three'],
  warpjet: '../dist/warpjet.js',
  'warpjet/three': '../dist/three.js',
})

/**
 * `listen` gets what the frames say, each with `isShown`: of the one that is seen, otherwise of the one that is coming.
 * `settings` are what the frame reads: { clock, files, view, valueOf }.
 */
export function makeStage(place, listen) {
  let shown, coming

  function run({ text, ...setting }, settings) {
    drop(coming)
    const source = URL.createObjectURL(
      new Blob([guarded({ text, ...setting })], { type: 'text/javascript' }),
    )
    const frame = document.createElement('iframe')
    frame.title = 'The running sketch'
    frame.className = 'coming'
    frame.playground = { ...settings, source, report: (message) => receive(frame, message) }
    const later = isThree(setting.host) ? ['clock', 'kept'] : ['clock', 'kept', 'warps']
    const kind = isThree(setting.host) ? 'type="module" ' : ''
    frame.srcdoc = pageOf(setting, {
      title: 'Sketch',
      base: `<base href="${files}" />`,
      before: ['start', 'files'].map(frameScript).join('\n    '),
      after: [...later.map(frameScript), fit].join('\n    '),
      modules: hosts[setting.host].modules && watched(hosts[setting.host].modules),
      sketch: `<script ${kind}src="${source}"></script>`,
    })
    coming = frame
    place.append(frame)
  }

  function receive(frame, message) {
    if (frame !== shown && frame !== coming) return
    const isShown = frame === shown
    if (message.kind === 'drawn' && !isShown) {
      drop(shown)
      ;[shown, coming] = [frame, undefined]
      frame.className = 'shown'
    }
    // It goes on only after the listener has looked at it.
    listen(message, isShown)
    if (message.kind === 'error' && !isShown) {
      coming = undefined
      drop(frame)
    }
  }

  /** Of the sketch that is seen; undefined before the first. */
  const inside = () => shown?.contentWindow?.playground
  return { run, inside, isWaiting: () => Boolean(coming) }
}

function drop(frame) {
  if (!frame) return
  URL.revokeObjectURL(frame.playground.source)
  // At once, so that its context is not one too many.
  frame.remove()
}
