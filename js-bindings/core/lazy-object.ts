// Objects whose values are made when they are first read: `glsl` has hundreds, of which a function reads a few.

interface Lazy {
  /** Maps each name, in order → whether it is enumerable. */
  names: ReadonlyMap<string, boolean>
  make: (name: string) => unknown
}

/** Makes every value appear to exist, however it is accessed. A value that was assigned or deleted is not made again. */
class Handler implements ProxyHandler<object> {
  private readonly made = new Set<PropertyKey>()

  constructor(private readonly lazy: Lazy) {}

  private makeOn(target: object, name: PropertyKey) {
    const { names, make } = this.lazy
    if (typeof name !== 'string' || this.made.has(name) || !names.has(name)) return
    this.made.add(name)
    Object.defineProperty(target, name, {
      value: make(name),
      configurable: true,
      enumerable: names.get(name)!,
      writable: true,
    })
  }

  get(target: object, name: PropertyKey, receiver: unknown): unknown {
    this.makeOn(target, name)
    return Reflect.get(target, name, receiver)
  }

  has(target: object, name: PropertyKey) {
    this.makeOn(target, name)
    return Reflect.has(target, name)
  }

  getOwnPropertyDescriptor(target: object, name: PropertyKey) {
    this.makeOn(target, name)
    return Reflect.getOwnPropertyDescriptor(target, name)
  }

  defineProperty(target: object, name: PropertyKey, descriptor: PropertyDescriptor) {
    this.makeOn(target, name)
    return Reflect.defineProperty(target, name, descriptor)
  }

  deleteProperty(target: object, name: PropertyKey) {
    this.makeOn(target, name)
    return Reflect.deleteProperty(target, name)
  }

  ownKeys(target: object) {
    const { names } = this.lazy
    const exists = (name: string) => !this.made.has(name) || Object.hasOwn(target, name)
    return [...new Set([...[...names.keys()].filter(exists), ...Reflect.ownKeys(target)])]
  }
}

/** Makes a lazy object. The prototype may be a `throwingPrototype`. `Reflect.ownKeys` makes no value. */
export const lazyObject = (prototype: object, lazy: Lazy): object =>
  new Proxy(Object.create(prototype) as object, new Handler(lazy))
