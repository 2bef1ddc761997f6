// Translates the source code of a function: its operators become calls that also accept expressions. Line numbers stay the same, so
// that errors refer to the sketch's own lines.
import MagicString from 'magic-string'
import { Edits } from './edits.js'
import {
  changesVector,
  containsJump,
  containsSuspension,
  endsFunction,
  endsInReturn,
} from './flow.js'
import { assignedIn, declaredIn, isProperty, propertySetIn, varsIn, walk } from './scopes.js'
import { unusedName } from './symbols.js'
import { ExpressionTranslator, type Translation } from './translate-expressions.js'
import { childrenOf, type Tree } from './tree.js'

/** Code to append after statements, and the statements that this code runs, grouped by block. */
interface Tail {
  then: string
  following: Tree[][]
}

/** The tail at the end of a function, with nothing to run. */
const emptyTail: Tail = { then: '', following: [] }

/** Translates `tree`, part of `source`, in place. */
export function translateIn(
  text: MagicString,
  source: string,
  tree: Tree,
  translation: Translation,
) {
  new Translator(new Edits(text, source), tree, translation).visit(tree)
}

/** Returns the translated code of `tree`, part of `source`. */
export function translate(source: string, tree: Tree, translation: Translation): string {
  const text = new MagicString(source)
  translateIn(text, source, tree, translation)
  return text.snip(tree.start, tree.end).toString()
}

class Translator extends ExpressionTranslator {
  private readonly restName = unusedName('warpjetRest', this.edits.source)
  /** The names that the current function declares. */
  private declaredHere = new Set<string>()
  private restCount = 0

  visit(node: Tree) {
    if (!this.rewriteExpression(node) && !this.rewriteStatement(node)) this.visitChildren(node)
  }

  private rewriteStatement(node: Tree): boolean {
    switch (node.type) {
      case 'ExpressionStatement':
        return this.statement(node)
      case 'BlockStatement':
        this.statements(node.body, node.end - 1, endsFunction(node) ? emptyTail : undefined)
        return true
      case 'IfStatement':
        this.translateIf(node)
        return true
      case 'WhileStatement':
      case 'DoWhileStatement':
      case 'ForStatement':
        return this.loop(node)
      case 'SwitchStatement':
        this.decide(node.discriminant, "'A switch'")
        for (const each of node.cases) this.visit(each)
        return true
      case 'FunctionDeclaration':
      case 'FunctionExpression':
      case 'ArrowFunctionExpression':
        return this.function(node)
      default:
        return false
    }
  }

  /** Translates a function with early returns that are decided per vertex. */
  private function(node: Tree): boolean {
    const { body } = node
    if (body.type !== 'BlockStatement') return false
    const declaredOutside = this.declaredHere
    this.declaredHere = declaredIn(node)
    for (const each of childrenOf(node)) if (each !== body) this.visit(each)
    this.statements(body.body, body.end - 1, emptyTail)
    this.declaredHere = declaredOutside
    return true
  }

  private loop(node: Tree): boolean {
    if (!node.test) return false
    for (const each of childrenOf(node))
      if (each === node.test) this.decide(each, "'A loop'")
      else this.visit(each)
    return true
  }

  /** Translates an expression whose value is unused. Adds no parentheses: they could call the expression on the previous line. */
  private statement(node: Tree): boolean {
    const { expression } = node
    const { type } = expression
    if (type === 'UpdateExpression') {
      if (!this.update(expression, true)) return false
    } else if (type === 'CallExpression' && changesVector(expression)) {
      this.visit(expression)
      const name = JSON.stringify(this.nameOf(expression))
      this.edits.wrap(expression, this.op('unused'), `, ${name})`)
    } else if (type === 'SequenceExpression') {
      this.visit(expression)
      this.edits.wrap(expression, '0, ', '')
    } else if (type !== 'AssignmentExpression' || !this.assign(expression)) return false
    this.edits.open(node, expression.start, '')
    this.edits.close(node, expression.end, ';')
    return true
  }

  /**
   * Translates statements in order, up to position `end`. `tail` is present if these statements and the tail are the last that the
   * function runs; then, after an `if` that returns, the remaining statements become the other branch.
   */
  private statements(list: Tree[], end: number, tail?: Tail) {
    for (const [i, node] of list.entries()) {
      if (tail && node.type === 'IfStatement' && containsJump(node, 'ReturnStatement')) {
        const later = list.slice(i + 1)
        const following = [later, ...tail.following]
        if (!this.mustDecide(node, following))
          return this.translateReturn(node, later, end, tail, following)
      }
      this.visit(node)
    }
    if (tail?.then) this.edits.append(end, tail.then)
  }

  /** Returns whether an `if` with a return has effects that cannot be undone, so that JavaScript must decide it. */
  private mustDecide(node: Tree, following: Tree[][]): boolean {
    const { consequent, alternate } = node
    const afterConsequent = endsInReturn(consequent) ? [] : following.flat()
    const all = [[consequent], alternate ? [alternate] : [], ...following]
    return (
      containsSuspension(all.flat()) ||
      !!propertySetIn([consequent, ...afterConsequent]) ||
      namesSetIn(all).some((name) => !this.declaredHere.has(name)) ||
      !!this.escapingVar(node)
    )
  }

  /** Returns the name of a `var` that is declared in the node, but read outside of the node. */
  private escapingVar(node: Tree): string | undefined {
    return varsIn(node, false).find((name) => {
      let isFound = false
      walk(this.tree, (each, parent) => {
        isFound ||= each.type === 'Identifier' && each.name === name && !isProperty(each, parent)
        return each !== node
      })
      return isFound
    })
  }

  /** Translates `if (c) return a; rest`, where the condition may differ by vertex, so that both `a` and `rest` must yield values. */
  private translateReturn(node: Tree, later: Tree[], end: number, tail: Tail, following: Tree[][]) {
    const { test, consequent, alternate } = node
    const branches: Tree[] = [consequent, alternate].filter(Boolean)
    const runsRest = branches.length < 2 || !branches.every(endsInReturn)
    const name = `${this.restName}${++this.restCount}`
    const names = namesSetIn([...branches.map((branch) => [branch]), ...following])
    const translateWithRest = (each: Tree) => {
      const then = endsInReturn(each) ? '' : `; return ${name}();`
      this.translateBranch(each, { then, following: then ? following : [] })
    }
    this.operand(test)
    this.edits.open(node, test.start, `return ${this.op('returning')}`)
    this.edits.replace(test.end, consequent.start, `, (${name}) => `)
    translateWithRest(consequent)
    if (alternate) {
      this.edits.replace(consequent.end, alternate.start, `, (${name}) => `)
      translateWithRest(alternate)
    } else this.edits.append(node.end, `, (${name}) => ${name}()`)
    this.edits.append(
      node.end,
      names.length ? `, ${this.variables(names)}` : ', undefined, undefined',
    )
    if (runsRest) {
      this.edits.append(node.end, ', () => {')
      this.statements(later, end, tail)
      this.edits.append(end, '});')
    } else {
      this.edits.append(node.end, ');')
      // The rest is unreachable.
      if (node.end < end) this.edits.replace(node.end, end, '')
    }
  }

  /** Translates a branch of an `if` as a block. */
  private translateBranch(node: Tree, tail?: Tail) {
    if (node.type === 'BlockStatement' && tail) this.statements(node.body, node.end - 1, tail)
    else if (node.type === 'BlockStatement') this.visit(node)
    else {
      this.statements([node], node.end, tail)
      this.edits.wrap(node, '{', '}')
    }
  }

  private translateIf(node: Tree) {
    const { test, consequent, alternate } = node
    const branches: Tree[] = [consequent, alternate].filter(Boolean)
    const property = propertySetIn(branches)
    const name = property ? this.nameOf(property) : this.escapingVar(node)
    const isLeftByJump = ['BreakStatement', 'ContinueStatement', 'ReturnStatement'].some((type) =>
      containsJump(node, type),
    )
    if (isLeftByJump || name || containsSuspension(branches)) {
      this.decide(test, name ? this.setting(name) : "'Leaving a loop or a function here'")
      for (const branch of branches) this.translateBranch(branch)
      return
    }
    this.operand(test)
    this.edits.open(node, test.start, this.op('branch'))
    this.edits.replace(test.end, consequent.start, ', () => ')
    this.translateBranch(consequent)
    if (alternate) {
      this.edits.replace(consequent.end, alternate.start, ', () => ')
      this.translateBranch(alternate)
    } else this.edits.append(node.end, ', () => {}')
    const variables = this.variables(namesSetIn(branches.map((branch) => [branch])))
    this.edits.append(node.end, `, ${variables}${this.effectIn(branches)});`)
  }

  /** Returns code for two functions that get and set variables. */
  private variables(names: string[]) {
    const list = `[${names.join(', ')}]`
    return `() => ${list}, (${this.valueName}) => { ${list} = ${this.valueName} }`
  }

  /** Returns an argument that names the first call in the branches whose value is unused, and which must have side effects; else ''. */
  private effectIn(branches: Tree[]): string {
    let found: Tree | undefined
    for (const branch of branches)
      walk(branch, (node) => {
        if (node.type === 'ExpressionStatement' && node.expression.type === 'CallExpression')
          found ??= node.expression
        return !/Function/.test(node.type)
      })
    return found ? `, ${JSON.stringify(this.nameOf(found))}` : ''
  }
}

const namesSetIn = (groups: Tree[][]) => [
  ...new Set(groups.flatMap((group) => [...assignedIn(group)])),
]
