// Translates expressions: operators, assignments and calls.
import { shorten } from '../errors/describe.js'
import type { Edits } from './edits.js'
import { canRepeat, containsSuspension, functionNamesIn } from './flow.js'
import { isKnown } from './functions.js'
import { assignedIn, propertySetIn } from './scopes.js'
import { binary, bits, logical, unary, unusedName } from './symbols.js'
import { childrenOf, type Tree } from './tree.js'

export interface Translation {
  /** Returns whether an identifier is bound outside of the function. */
  isFree: (node: Tree) => boolean
  /** The name of the object of operators in the translated code. */
  operatorsName: string
  /** True if other functions are translated when they are called. */
  readsHelpers: boolean
  /** Variables that hold functions of Math. */
  aliases?: ReadonlySet<string>
}

const suspensionMessage = "'yield or await here'"

export abstract class ExpressionTranslator {
  /** Name of the parameter of generated setter functions. */
  protected readonly valueName: string
  private readonly functionsHere: ReadonlySet<string>
  /** Nodes of chains such as `a?.b.c()`, whose calls may be skipped. */
  private readonly optional = new Set<Tree>()

  constructor(
    protected readonly edits: Edits,
    protected readonly tree: Tree,
    private readonly translation: Translation,
  ) {
    this.valueName = unusedName('warpjetValue', edits.source)
    this.functionsHere = functionNamesIn(tree)
  }

  /** Translates a node and its children. */
  abstract visit(node: Tree): void

  protected visitChildren(node: Tree) {
    for (const child of childrenOf(node)) this.visit(child)
  }

  /** Returns the beginning of a call of an operator. */
  protected op(name: string) {
    return `${this.translation.operatorsName}.${name}(`
  }

  /**
   * Translates a node that becomes an argument, or follows `=>`; adds parentheses if it needs them, since a node's own are not part of it.
   */
  protected operand(node: Tree) {
    this.visit(node)
    if (node.type === 'SequenceExpression' || this.edits.source[node.start] === '{')
      this.edits.wrap(node, '(', ')')
  }

  /** Translates a condition that JavaScript itself must decide; `what` is a JavaScript expression for the message. */
  protected decide(condition: Tree, what: string) {
    this.operand(condition)
    this.edits.wrap(condition, this.op('decided'), `, ${what})`)
  }

  protected nameOf({ start, end }: Tree) {
    return shorten(this.edits.source.slice(start, end))
  }

  /** Returns a JavaScript string for the argument `what` of `decided`. */
  protected setting(name: string) {
    return JSON.stringify(`Setting ${name} here`)
  }

  /** Returns the code around a condition that selects one of `operands`: if these assign something, JavaScript must decide it. */
  private aroundCondition(operands: Tree[]): [before: string, after: string] {
    const property = propertySetIn(operands)
    const [name] = property ? [this.nameOf(property)] : assignedIn(operands)
    return name ? [this.op('decided'), `, ${this.setting(name)})`] : ['', '']
  }

  /** Translates an expression; returns false if only its children need translation. */
  protected rewriteExpression(node: Tree): boolean {
    switch (node.type) {
      case 'BinaryExpression':
        return this.binary(node)
      case 'UnaryExpression':
        return this.unary(node)
      case 'LogicalExpression':
        return this.logical(node)
      case 'ConditionalExpression':
        return this.conditional(node)
      case 'AssignmentExpression':
        if (!this.assign(node)) return false
        this.edits.wrap(node, '(', ')')
        return true
      case 'UpdateExpression':
        return this.update(node, false)
      case 'ChainExpression':
        for (let each: Tree = node.expression; each; each = each.callee ?? each.object)
          this.optional.add(each)
        return false
      case 'CallExpression':
        return !this.optional.has(node) && this.call(node)
      case 'NewExpression':
        return this.construct(node)
      default:
        return false
    }
  }

  /** Returns the beginning of a call for a binary operator; `undefined` if it is not overloaded. */
  private binaryOp(operator: string): string | undefined {
    if (binary[operator]) return this.op(binary[operator])
    return bits.has(operator) ? `${this.op('bits')}'${operator}', ` : undefined
  }

  private binary(node: Tree): boolean {
    const { operator, left, right } = node
    const op = this.binaryOp(operator)
    if (!op) return false
    this.operand(left)
    this.operand(right)
    this.edits.open(node, left.start, op)
    this.edits.replace(left.end, right.start, ', ')
    this.edits.close(node, right.end, ')')
    return true
  }

  private unary(node: Tree): boolean {
    const { operator, argument } = node
    if (argument.type === 'Literal') return false
    // ~~x, which truncates.
    const isTwice =
      operator === '~' && argument.type === 'UnaryExpression' && argument.operator === '~'
    const operand: Tree = isTwice ? argument.argument : argument
    const name = operator === '~' ? 'bits' : unary[operator]
    if (!name) return false
    const [symbol, end] = isTwice ? ["'|', ", ', 0)'] : ["'^', ", ', -1)']
    const isBits = operator === '~'
    this.operand(operand)
    this.edits.open(node, operand.start, this.op(name) + (isBits ? symbol : ''))
    this.edits.close(node, operand.end, isBits ? end : ')')
    return true
  }

  private logical(node: Tree): boolean {
    const { operator, left, right } = node
    if (!logical[operator]) return false
    this.operand(left)
    this.operand(right)
    if (containsSuspension([right])) {
      this.edits.open(node, left.start, `(${this.op('decided')}`)
      this.edits.replace(left.end, right.start, `, ${suspensionMessage}) ${operator} `)
    } else {
      const [before, after] = this.aroundCondition([right])
      this.edits.open(node, left.start, this.op(logical[operator]) + before)
      this.edits.replace(left.end, right.start, `${after}, () => `)
    }
    this.edits.close(node, right.end, ')')
    return true
  }

  private conditional(node: Tree): boolean {
    const { test, consequent, alternate } = node
    for (const each of [test, consequent, alternate]) this.operand(each)
    if (containsSuspension([consequent, alternate])) {
      this.edits.open(node, test.start, `(${this.op('decided')}`)
      this.edits.replace(test.end, consequent.start, `, ${suspensionMessage}) ? `)
      this.edits.replace(consequent.end, alternate.start, ' : ')
    } else {
      const [before, after] = this.aroundCondition([consequent, alternate])
      this.edits.open(node, test.start, this.op('choose') + before)
      this.edits.replace(test.end, consequent.start, `${after}, () => `)
      this.edits.replace(consequent.end, alternate.start, ', () => ')
    }
    this.edits.close(node, alternate.end, ')')
    return true
  }

  /** Translates `x += y` and similar assignments, without parentheses. */
  protected assign(node: Tree): boolean {
    const { operator, left, right } = node
    const symbol = operator.slice(0, -1)
    const op = logical[symbol] ? this.op(logical[symbol]) : this.binaryOp(symbol)
    if (operator === '=' || !op || containsSuspension([right])) return false
    const changeCode = (target: string) => {
      if (!logical[symbol]) return `${op}${target}, `
      const [before, after] = this.aroundCondition([right])
      return `${op}${before}${target}${after}, () => `
    }
    if (canRepeat(left)) {
      const target = this.edits.source.slice(left.start, left.end).replace(/\s*\n\s*/g, ' ')
      this.operand(right)
      this.edits.open(node, left.start, '')
      this.edits.replace(left.end, right.start, ` = ${changeCode(target)}`)
      this.edits.close(node, right.end, ')')
      return true
    }
    const end = `(${this.valueName}) => ${changeCode(this.valueName)}`
    if (!this.changeMember(node, left, right.start, end)) return false
    this.operand(right)
    this.edits.close(node, right.end, '))')
    return true
  }

  /** Writes `object[key] = …` as a call with a function of the old value; `end` replaces the code after the key, up to position `to`. */
  private changeMember(node: Tree, member: Tree, to: number, end: string, name = 'change') {
    const { object, property, computed } = member
    if (property.type === 'PrivateIdentifier' || object.type === 'Super') return false
    this.operand(object)
    this.edits.open(node, object.start, this.op(name))
    if (computed) {
      this.operand(property)
      this.edits.replace(object.end, property.start, ', ')
      this.edits.replace(property.end, to, `, ${end}`)
    } else this.edits.replace(object.end, to, `, '${property.name}', ${end}`)
    return true
  }

  /** Translates `x++`, `--x` and so on. */
  protected update(node: Tree, isUnused: boolean): boolean {
    const { argument, operator, prefix } = node
    const by = operator === '++' ? '1' : '-1'
    const moveCode = (target: string) => `${this.op('move')}${target}, ${by})`
    if (argument.type === 'Identifier') {
      const set = `${argument.name} = ${moveCode(argument.name)}`
      const value = prefix ? `(${set})` : `${this.op('first')}${argument.name}, ${set})`
      this.edits.replace(node.start, node.end, isUnused ? set : value)
      return true
    }
    const end = `(${this.valueName}) => ${moveCode(this.valueName)})`
    const name = prefix || isUnused ? 'change' : 'changeAfter'
    // At least the operator or the key follows the object.
    return this.changeMember(node, argument, node.end, end, name)
  }

  /** Translates the arguments of a call. `head` replaces the code between `from` and the first argument. */
  private translateArguments(node: Tree, from: number, head: string) {
    const values = node.arguments as Tree[]
    for (const each of values) this.operand(each)
    const [first] = values
    if (!first) return this.edits.close(node, from, `${head})`)
    this.edits.replace(from, first.start, `${head}, `)
    values.slice(1).forEach((each, i) => this.edits.replace(values[i]!.end, each.start, ', '))
    this.edits.close(node, values.at(-1)!.end, ')')
  }

  private call(node: Tree): boolean {
    const { callee } = node
    const { isFree, readsHelpers, aliases } = this.translation
    const translateCall = (head: string) => {
      this.translateArguments(node, node.start, head)
      return true
    }
    if (callee.type === 'Identifier') {
      const { name } = callee
      if (name === 'eval') return false
      if (isFree(callee) && (readsHelpers || isKnown(name)))
        return translateCall(`${this.op('call')}'${name}', () => ${name}`)
      const isVariable = !isFree(callee) && !this.functionsHere.has(name)
      return (
        (readsHelpers || !!aliases?.has(name)) &&
        isVariable &&
        translateCall(`${this.op('invoke')}${name}, undefined`)
      )
    }
    if (callee.type !== 'MemberExpression') return false
    const { object, property, computed } = callee
    if (object.type === 'Super' || property.type === 'PrivateIdentifier') return false
    if (!readsHelpers && (computed || !isKnown(property.name))) return false
    if (object.name === 'Math' && !computed && isKnown(property.name) && isFree(object))
      return translateCall(`${this.op('call')}'${property.name}', () => Math.${property.name}`)
    this.operand(object)
    this.edits.open(node, object.start, this.op('method'))
    if (computed) {
      this.operand(property)
      this.edits.replace(object.end, property.start, ', ')
      this.translateArguments(node, property.end, '')
    } else this.translateArguments(node, object.end, `, '${property.name}'`)
    return true
  }

  private construct(node: Tree): boolean {
    const { callee } = node
    if (!this.translation.readsHelpers || callee.type !== 'Identifier') return false
    this.translateArguments(node, node.start, `${this.op('construct')}${callee.name}`)
    return true
  }
}
