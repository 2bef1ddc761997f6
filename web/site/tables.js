/**
 * Marks the tables of the docs as tables of figures or of words. In a narrow window a row of words becomes a card, for which each cell
 * carries its heading. Roles are explicit, since tables lose theirs if they are not displayed as tables.
 */

const roles = {
  table_open: 'table',
  thead_open: 'rowgroup',
  tbody_open: 'rowgroup',
  tr_open: 'row',
  th_open: 'columnheader',
  td_open: 'cell',
}

const textOf = ({ children }) => children.map(({ content }) => content).join('')

/** @param tokens the tokens of a table */
function markTable(tokens) {
  const cellsOf = (type) =>
    tokens.flatMap((token, i) => (token.type === type ? [[token, tokens[i + 1]]] : []))
  const heads = cellsOf('th_open').map(([, content]) => textOf(content))
  const cells = cellsOf('td_open')
  // The first cell of a row is its subject, so only the other cells decide.
  const others = cells.filter((_, i) => i % heads.length)
  const figures = others.filter(([, { content }]) => /^[-≤]?\d/.test(content))
  tokens[0].meta = { isFigures: figures.length > others.length / 2 }
  if (tokens[0].meta.isFigures) return
  for (const token of tokens) if (roles[token.type]) token.attrSet('role', roles[token.type])
  // In a table of two columns the second cell needs no heading.
  if (heads.length > 2)
    cells.forEach(([token], i) => {
      if (i % heads.length) token.attrSet('data-head', heads[i % heads.length])
    })
}

export function markTables(markdown) {
  markdown.core.ruler.push('tables', ({ tokens }) => {
    tokens.forEach((token, start) => {
      if (token.type !== 'table_open') return
      const end = tokens.findIndex(({ type }, i) => i > start && type === 'table_close')
      markTable(tokens.slice(start, end))
    })
  })

  const { rules } = markdown.renderer
  rules.table_open = (tokens, index, options, env, self) => {
    const kind = tokens[index].meta.isFigures ? 'figures' : 'words'
    return `<div class="table ${kind}" role="group" aria-label="Table" tabindex="0">${self.renderToken(tokens, index, options)}`
  }
  rules.table_close = () => '</table></div>\n'

  // Figures with their unit or exponent do not wrap, nor does code, unless it is long.
  rules.td_open = (tokens, index, options, env, self) => {
    const { content } = tokens[index + 1]
    if (/^-?\d.{0,14}$/.test(content)) tokens[index].attrJoin('class', 'number')
    if (/^`[^`]{30,}`$/.test(content)) tokens[index].attrJoin('class', 'long')
    return self.renderToken(tokens, index, options)
  }
}
