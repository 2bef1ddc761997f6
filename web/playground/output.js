/** The tabs below the sketch: the shader code of each warp, its cost, and the sketch's console output. */
import { make } from '../bench/dom.js'
import { highlight } from '../highlighting.js'
import { removeOrigins, withOrigins } from './origins.js'

const targets = { glsl300: 'GLSL 3.00', glsl100: 'GLSL 1.00', wgsl: 'WGSL' }
const MAX_LINES = 200

const integer = new Intl.NumberFormat('en', { maximumFractionDigits: 0 })
const short = new Intl.NumberFormat('en', { maximumSignificantDigits: 3 })

/**
 * @param list the element for the tabs
 * @param panel the element for the selected tab's content
 * @param more additional tabs, { title, fill(place, sketch) } by name
 * @param onPoint called with the sketch's lines from which the statement under the pointer was generated
 * @param onPick called with the first of these lines when the statement is clicked
 */
export function makeOutput(list, panel, more = {}, { onPoint, onPick } = {}) {
  let sketch = { warps: [] }
  let printed = []
  const tabs = {
    ...Object.fromEntries(
      Object.entries(targets).map(([target, title]) => [
        target,
        { title, fill: () => panel.replaceChildren(makeCode(target, sketch.warps)) },
      ]),
    ),
    costs: { title: 'Costs', fill: () => panel.replaceChildren(makeCosts(sketch)) },
    ...Object.fromEntries(
      Object.entries(more).map(([name, { title, fill }]) => [
        name,
        {
          title,
          fill: () => {
            // A new element each time, because it may be filled after another tab was selected.
            const place = make('div')
            panel.replaceChildren(place)
            fill(place, sketch)
          },
        },
      ]),
    ),
    console: { title: 'Console', fill: () => panel.replaceChildren(makeConsole(printed)) },
  }
  let chosen = 'glsl300'

  const buttons = Object.entries(tabs).map(([name, { title }]) => {
    const button = make('button', {
      type: 'button',
      role: 'tab',
      id: `tab-${name}`,
      value: name,
      textContent: title,
    })
    button.setAttribute('aria-controls', panel.id)
    button.addEventListener('click', () => choose(name))
    return button
  })
  list.append(...buttons)
  // The ARIA pattern of tabs: one stop of the Tab key, arrow keys between tabs.
  list.addEventListener('keydown', ({ key }) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[key]
    if (!step) return
    const next = buttons.findIndex(({ value }) => value === chosen) + step + buttons.length
    const button = buttons[next % buttons.length]
    choose(button.value)
    button.focus()
  })

  function choose(name) {
    chosen = name
    for (const button of buttons) {
      const isChosen = button.value === name
      button.ariaSelected = String(isChosen)
      button.tabIndex = isChosen ? 0 : -1
    }
    panel.setAttribute('aria-labelledby', `tab-${name}`)
    panel.scrollTo(0, 0)
    tabs[name].fill()
  }
  choose(chosen)

  /** Fills the console once per frame at most: a sketch may print faster than the browser updates the page. */
  let isConsoleDue = false
  function fillConsoleSoon() {
    if (isConsoleDue) return
    isConsoleDue = true
    requestAnimationFrame(() => {
      isConsoleDue = false
      if (chosen === 'console') tabs.console.fill()
    })
  }

  // Links from shader code to the sketch, and from the sketch to shader code.
  /** Returns the lines of the sketch from which the statement at an element of the panel was generated. */
  const originsOf = (target) => {
    const { from } = target.closest('[data-from]')?.dataset ?? {}
    return from ? from.split(' ').map(Number) : []
  }
  panel.addEventListener('pointerover', ({ target }) => onPoint?.(originsOf(target)))
  panel.addEventListener('pointerleave', () => onPoint?.([]))
  panel.addEventListener('click', ({ target }) => {
    const [first] = originsOf(target)
    if (first && getSelection().isCollapsed) onPick?.(first)
  })
  let followedLine
  function highlightFollowed() {
    for (const line of panel.querySelectorAll('[data-from]'))
      line.classList.toggle('lit', originsOf(line).includes(followedLine))
  }
  new MutationObserver(highlightFollowed).observe(panel, { childList: true })

  return {
    /** Highlights the code that was generated from this line of the sketch, where the cursor is. */
    follow(line) {
      followedLine = line
      highlightFollowed()
      panel.querySelector('.lit')?.scrollIntoView({ block: 'nearest' })
    },
    /** Shows the warps of the visible sketch, and the time of its first picture. Without `first`, the same sketch has made more warps. */
    show({ warps, first }) {
      sketch = first === undefined ? { ...sketch, warps } : { warps, first }
      if (chosen !== 'console') tabs[chosen].fill()
    },
    showRate(rate) {
      sketch.rate = rate
      const place = panel.querySelector('.rate')
      if (place) place.textContent = rateText(rate)
    },
    /** Adds a line to the console; without an argument, clears it. */
    print(line) {
      printed = line ? [...printed, line].slice(-MAX_LINES) : []
      buttons.at(-1).textContent = printed.length ? `Console (${printed.length})` : 'Console'
      if (chosen === 'console') fillConsoleSoon()
    },
  }
}

const makeNote = (text) => make('p', { className: 'none', textContent: text })

function makeCode(target, warps) {
  const texts = warps.map(({ maker, texts }) => `// ${maker}\n${joinCode(texts[target])}`)
  if (!texts.length) return makeNote('The sketch has made no shader code.')
  const code = make('code')
  code.innerHTML = withOrigins(texts.join('\n\n'))
    .map(
      ({ text, from }) =>
        `<span${from.length ? ` data-from="${from.join(' ')}"` : ''}>${highlight(text, 'glsl')}\n</span>`,
    )
    .join('')
  return make('pre', { tabIndex: 0 }, code)
}

const joinCode = ({ code, declarations }) =>
  declarations ? `${code}\n\n// Above main:\n${declarations}` : code

const rateText = (rate) =>
  rate ? `${short.format(1000 / rate)} ms (${integer.format(rate)} a second)` : '–'

function makeCosts({ warps, first, rate }) {
  const rows = warps
    .filter(({ stats }) => stats)
    .map(({ maker, stats, own: { code, declarations = '' } }) => [
      maker,
      stats.nodes,
      stats.operations,
      stats.temporaries,
      removeOrigins(code).length + declarations.length,
    ])
  const list = make('dl', { className: 'read-outs' })
  list.append(
    make('div', {}, make('dt', { textContent: 'First picture' }), makeFigure(first, 'ms')),
    make(
      'div',
      {},
      make('dt', { textContent: 'A frame' }),
      make('dd', { className: 'rate', textContent: rateText(rate) }),
    ),
  )
  if (!rows.length) return make('div', {}, list, makeNote('The sketch has made no warp.'))
  const head = ['Warp', 'Nodes', 'Operations', 'Temporaries', 'Characters']
  const table = make(
    'table',
    {},
    make('thead', {}, makeRow('th', head)),
    make('tbody', {}, ...rows.map((row) => makeRow('td', row))),
  )
  return make('div', {}, list, table)
}

const makeFigure = (value, unit) =>
  make('dd', { textContent: value === undefined ? '–' : `${integer.format(value)} ${unit}` })

const makeRow = (kind, cells) =>
  make(
    'tr',
    {},
    ...cells.map((cell) =>
      make(kind, { textContent: typeof cell === 'number' ? integer.format(cell) : cell }),
    ),
  )

function makeConsole(printed) {
  if (!printed.length) return makeNote('Nothing was printed.')
  const list = make('ol', { className: 'printed', tabIndex: 0 })
  list.append(
    ...printed.map(({ level, text }) => make('li', { className: level, textContent: text })),
  )
  return list
}
