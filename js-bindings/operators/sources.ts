// Finds the source code of a function in the scripts of its page, since only a script shows which variables surround a function.
import { parse } from 'acorn'
import { fileOf, stackLines } from '../errors/source-lines.js'
import { type Place } from './resolve.js'
import type { Tree } from './tree.js'

interface Script {
  text: string
  isModule: boolean
}

const programs = new Map<string, Tree | undefined>()

/** Returns the syntax tree of a script; `undefined` if acorn cannot parse it. */
function programOf({ text, isModule }: Script): Tree | undefined {
  const key = `${isModule}${text}`
  if (!programs.has(key)) {
    let program: Tree | undefined
    try {
      program = parse(text, {
        ecmaVersion: 'latest',
        sourceType: isModule ? 'module' : 'script',
        allowHashBang: true,
      }) as Tree
    } catch {
      // Another language, or syntax that acorn does not support.
    }
    programs.set(key, program)
  }
  return programs.get(key)
}

const isModuleTag = (script: HTMLScriptElement) => script.type === 'module'
const isJavaScript = ({ type }: HTMLScriptElement) =>
  /^(module|(text|application)\/(x-)?javascript|)$/i.test(type)

const tags = () => [...document.scripts].filter(isJavaScript)

const inlineScripts = (): Script[] =>
  tags()
    .filter((script) => !script.src)
    .map((script) => ({ text: script.textContent ?? '', isModule: isModuleTag(script) }))

/** Returns global functions that contain `text`; their source code is available without their script. */
function globalFunctions(text: string): Script[] {
  const found: Script[] = []
  for (const name of Object.getOwnPropertyNames(globalThis)) {
    const value: unknown = Object.getOwnPropertyDescriptor(globalThis, name)?.value
    if (typeof value !== 'function') continue
    const script = Function.prototype.toString.call(value)
    if (script.includes(text)) found.push({ text: script, isModule: false })
  }
  return found
}

const isLibrary = (url: string) =>
  /(^|\/)p5(@[^/]*)?(\.[\w-]+)*\.js\b|\/p5@?[^/]*\/lib\/|(^|\/)warpjet(\.[\w-]+)*\.js\b/.test(
    url.replace(/[?#].*$/, ''),
  )

/** Returns whether a script can be read without a request to another site. On a page opened from a file, no script can be read. */
const isReadable = (url: string) =>
  /^(blob|data):/.test(url) || (/^https?:/.test(url) && new URL(url).origin === location.origin)

const fetched = new Map<string, string | undefined>()

/** Returns the source code of a script. The page has already loaded the script, so its code comes from the browser's cache. */
function textAt(url: string): string | undefined {
  if (!fetched.has(url)) {
    let text: string | undefined
    try {
      const request = new XMLHttpRequest()
      request.open('GET', url, false)
      request.send()
      if (request.status >= 200 && request.status < 300) text = request.responseText
    } catch {
      // The script is gone, or the page forbids the request.
    }
    fetched.set(url, text)
  }
  return fetched.get(url)
}

/** Yields scripts in files, starting with those on the call stack. */
function* files(): Generator<Script> {
  const onCallStack = stackLines().map(fileOf)
  const withUrl = tags().filter((script) => script.src)
  const classic = new Set(withUrl.filter((script) => !isModuleTag(script)).map(({ src }) => src))
  const loaded = performance
    .getEntriesByType('resource')
    .filter((entry) => /\.m?jsx?([?#]|$)/.test(entry.name))
    .map(({ name }) => name)
  for (const url of new Set([...onCallStack, ...withUrl.map(({ src }) => src), ...loaded])) {
    if (url === location.href || isLibrary(url) || !isReadable(url)) continue
    const text = textAt(url)
    if (text !== undefined) yield { text, isModule: !classic.has(url) }
  }
}

function placesIn(script: Script, text: string): Place[] {
  if (!script.text.includes(text)) return []
  const program = programOf(script)
  const places: Place[] = []
  if (program)
    for (
      let start = script.text.indexOf(text);
      start >= 0;
      start = script.text.indexOf(text, start + 1)
    )
      places.push({
        text: script.text,
        program,
        isModule: script.isModule,
        start,
        end: start + text.length,
      })
  return places
}

/** Finds the source code of a function in the page's scripts. Returns several places if several functions have the same code. */
export function placesOf(text: string): Place[] {
  if (typeof document === 'undefined') return []
  const inline = inlineScripts().flatMap((script) => placesIn(script, text))
  if (inline.length) return inline
  const inFunctions = globalFunctions(text).flatMap((script) => placesIn(script, text))
  if (inFunctions.length) return inFunctions
  for (const script of files()) {
    const places = placesIn(script, text)
    if (places.length) return places
  }
  return []
}

/** Returns the syntax trees of the scripts that contain a name, among those that can be read without a further request. */
export function programsWith(name: string, place: Place | undefined): Tree[] {
  if (typeof document === 'undefined') return []
  const fetchedScripts = [...fetched.values()].flatMap((text) =>
    text ? [{ text, isModule: false }] : [],
  )
  const scriptOfPlace = place && { text: place.text, isModule: place.isModule }
  const scripts = [
    ...inlineScripts(),
    ...fetchedScripts,
    ...globalFunctions(name),
    ...(scriptOfPlace ? [scriptOfPlace] : []),
  ]
  const texts = new Map(scripts.map((script) => [script.text, script]))
  return [...texts.values()]
    .filter(({ text }) => text.includes(name))
    .flatMap((script) => programOf(script) ?? [])
}
