// Finds wording in comments, messages, names and Markdown that a native-speaking engineer would not choose.
//
//   node .scripts/plain-english.mjs [--list] [FOLDER…]   counts such wording, in all files or in these folders
//   npm test -- language                                  rejects such wording in lines that a branch adds
//
// A hit is a place to reread, not proof of a fault. If a sentence is right as it is, add it to `exceptions`.
import { existsSync, readFileSync } from 'node:fs'
import { parseArgs } from 'node:util'
import { path } from './lib/files.mjs'
import { capture } from './lib/run.mjs'
import { NotRun, Stop, isMain, main, say } from './lib/terminal.mjs'

/** Correct sentences that the rules match, written as this tool prints them. */
const exceptions = new Set([])

const roots = 'src js-bindings .scripts .cmake web tests examples README.md CONTRIBUTING.md'.split(
  ' ',
)
const code = /\.(ts|mjs|js|cpp|hpp|cmake)$|CMakeLists\.txt$/
const prose = /\.md$/
const skipped = /types\/methods\.ts|corpus|golden|plain-english/
const isChecked = (file) => (code.test(file) || prose.test(file)) && !skipped.test(file)

// Also matches strings, without a group, so that // inside a string is not taken for a comment.
const comments =
  /\/\*\*?([\s\S]*?)\*\/|(?<![:\\'"`])\/\/([^\n]*(?:\n[ \t]*\/\/[^\n]*)*)|'(?:\\.|[^'\\\n])*'|"(?:\\.|[^"\\\n])*"|`(?:\\.|[^`\\])*`/g
const strings = /'(?:\\.|[^'\\\n])*'|"(?:\\.|[^"\\\n])*"|`(?:\\.|[^`\\])*`/g

const commentRules = {
  'comment without a subject':
    /^(What|Of|By|As|Those|Whose|Who|How|Whether|Which|In which|For what|Under which|Around what|With what|From what|Where(?! possible)|The same|Likewise)\b(?![^.]*\?)/,
}
const textRules = {
  '"unless given": write "Default: …"': /\bunless given\b/i,
  '"so many", "so large": write the number': /\b(?<!not )so (many|much|large|far)\b(?! that)/i,
  '"is told", "tells": write reports, passes, knows, throws':
    /\b(is|are|was|be|been|gets?|has it) told\b|\btells\b/i,
  '"but X came": write "expected X, got Y"': /\bbut \S+( \S+)? came\b|\bcame\b/i,
  'stands, lies, laid: write is, is in, is stored, copied':
    /\b(stands? (here|there|in|above|below|for itself|beside)|lies? in|laid)\b/i,
  '"nothing if": write "empty if", "undefined if"': /\b(nothing|none) (if|where|unless)\b/i,
  '"of what is": name the thing':
    /\b(in|of|by|from|to|with|and|is|are) what (is|are|has|have|was|it|they|the)\b/i,
  'most, least, usual: write max, min, default': /\b(at most (?!\d)|usual(ly)?)\b/,
}
const nameRules = {
  'function named by a participle or adverb':
    /\b(?:function|const)\s+((?!(?:apply|reply|multiply|supply|speed|feed|seed|need|embed|string|ring|thing|king|spring|padding|encoding|warning|setting|heading|timing|rendering|drawing|shading|family|assembly)\b)[a-z]+(?:ed|ing|ly)|told|kept|laid|made|done|given|asked|woven|written|sealed|solved)\b\s*(?:=\s*(?:async\s*)?(?:\(|[a-z]+\s*=>|<)|\(|<)/g,
  'name begins with most, least or usual':
    /\b(?:const|constexpr|static|int|double|auto)\s+(?:most|least|usual)[A-Z]\w*/g,
}

const stripCommentMarks = (text) => text.replace(/\s*\n\s*(\*|\/\/)?\s*/g, ' ').trim()

/** Finds the places to reread in one file: [{ rule, line, text }]. */
export function findWording(file, source) {
  const hits = []
  const report = (rule, at, text) =>
    hits.push({ rule, line: source.slice(0, at).split('\n').length, text: text.slice(0, 110) })
  const apply = (rules, text, at) => {
    for (const [rule, pattern] of Object.entries(rules))
      if (pattern.test(text)) report(rule, at, text)
  }
  if (prose.test(file)) {
    for (const line of source.matchAll(/[^\n]+/g)) apply(textRules, line[0], line.index)
    return hits
  }
  for (const { 1: block, 2: line, index } of source.matchAll(comments)) {
    const text = stripCommentMarks(block ?? line ?? '')
    if (!text || /^clang-format|^@|^prettier/.test(text)) continue
    apply({ ...commentRules, ...textRules }, text, index)
  }
  for (const { 0: text, index } of source.matchAll(strings))
    if (text.length > 30) apply(textRules, text, index)
  for (const [rule, pattern] of Object.entries(nameRules))
    for (const { 0: text, index } of source.matchAll(pattern)) report(rule, index, text)
  return hits.filter(({ text }) => !exceptions.has(text))
}

/** Returns the hits of `after` that are not in `before`. A hit that only moved to another line or file is not new. */
export function addedWording(before, after) {
  const keyOf = ({ rule, text }) => `${rule}\n${text}`
  const oldKeys = before.map(keyOf)
  return after.filter((hit) => {
    const i = oldKeys.indexOf(keyOf(hit))
    if (i >= 0) oldKeys.splice(i, 1)
    return i < 0
  })
}

/** Returns the trimmed output of git; null if it is empty or if git fails. */
const runGit = async (...args) => (await capture('git', args))?.trim() || null
const splitLines = (text) => (text ? text.split('\n') : [])

/** Returns the commit with which the current one is compared: the one at which the branch left main, or on main itself the previous one. */
async function findBase() {
  const head = await runGit('rev-parse', 'HEAD')
  if (!head) throw new NotRun('this folder is not a git repository')
  for (const branch of ['origin/main', 'main']) {
    const fork = await runGit('merge-base', branch, 'HEAD')
    if (fork && fork !== head) return fork
  }
  const before = await runGit('rev-parse', '--verify', '--quiet', 'HEAD~1')
  if (!before) throw new NotRun('the history has no commit to compare with')
  return before
}

const readNow = (file) => (existsSync(path(file)) ? readFileSync(path(file), 'utf8') : '')

/** Throws if a file has wording to reread that the base does not have. */
export async function checkWording() {
  const since = await findBase()
  const changed = await runGit('diff', '--name-only', '--no-renames', since, '--', ...roots)
  const untracked = await runGit('ls-files', '--others', '--exclude-standard', '--', ...roots)
  const files = [...splitLines(changed), ...splitLines(untracked)].filter(isChecked)
  const before = []
  const after = []
  for (const file of files) {
    before.push(...findWording(file, (await runGit('show', `${since}:${file}`)) ?? ''))
    after.push(...findWording(file, readNow(file)).map((hit) => ({ ...hit, file })))
  }
  const added = addedWording(before, after)
  if (added.length)
    throw new Stop(
      `${added.map(describe).join('\n')}\n${added.length} to reread, in lines added since ${since.slice(0, 9)}. CONTRIBUTING.md has the style; .scripts/plain-english.mjs has exceptions.`,
    )
}

const describe = ({ file, line, rule, text }) => `${file}:${line}  ${text}\n    ${rule}`

/** Prints the number of hits of each rule and of all rules; with `listsPlaces`, also every place. */
async function printCounts(folders, listsPlaces) {
  const tracked = splitLines(await runGit('ls-files', '--', ...(folders.length ? folders : roots)))
  const files = tracked.filter((file) => isChecked(file) && existsSync(path(file)))
  const hits = files.flatMap((file) =>
    findWording(file, readNow(file)).map((hit) => ({ ...hit, file })),
  )
  const rules = {}
  for (const hit of hits) (rules[hit.rule] ??= []).push(hit)
  for (const [rule, places] of Object.entries(rules).sort(([, a], [, b]) => b.length - a.length)) {
    say(`${String(places.length).padStart(5)}  ${rule}`)
    if (listsPlaces)
      for (const { file, line, text } of places) say(`       ${file}:${line}  ${text}`)
  }
  say(`${String(hits.length).padStart(5)}  in ${files.length} files`)
}

if (isMain(import.meta))
  await main(async () => {
    const { values, positionals } = parseArgs({
      options: { list: { type: 'boolean' } },
      allowPositionals: true,
    })
    await printCounts(positionals, values.list)
  })
