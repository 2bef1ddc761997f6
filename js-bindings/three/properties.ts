// Properties of an object that are replaced while it is warped, and restored afterwards.

/** Defines properties; the returned function restores the previous ones. */
export function replaceProperties(object: object, properties: PropertyDescriptorMap): () => void {
  const before = Object.keys(properties).map(
    (name) => [name, Object.getOwnPropertyDescriptor(object, name)] as const,
  )
  for (const [name, earlier] of before)
    Object.defineProperty(object, name, {
      configurable: true,
      enumerable: earlier?.enumerable ?? false,
      ...properties[name],
    })
  return () => {
    for (const [name, property] of before) {
      if (property) Object.defineProperty(object, name, property)
      else Reflect.deleteProperty(object, name)
    }
  }
}

type Method = (...given: never[]) => unknown

/**
 * Wraps a method of an object, and any method that is assigned to it later; the returned function ends that. Reading the property gives a
 * wrapper of the current method, which keeps wrapping that method, so that a method that is assigned later may call it.
 */
export function wrapMethod<Wrapped extends Method>(
  object: object,
  name: string,
  wrap: (method: Wrapped) => Wrapped,
): () => void {
  let method = (object as Record<string, Wrapped>)[name]!
  let wrapper = wrap(method)
  let isAssigned = false
  const restore = replaceProperties(object, {
    [name]: {
      get: () => wrapper,
      set(assigned: Wrapped) {
        isAssigned = true
        method = assigned
        wrapper = wrap(assigned)
      },
    },
  })
  return () => {
    restore()
    if (isAssigned) (object as Record<string, Wrapped>)[name] = method
  }
}

/** Returns a property that is computed when it is read. It ignores assignments, since three.js assigns the value without a warp. */
export const computedProperty = <Value>(value: () => Value): PropertyDescriptor => ({
  get: value,
  set: () => {},
})

export const asProperties = (values: object): PropertyDescriptorMap =>
  Object.fromEntries(
    Object.entries(values).map(([name, value]) => [name, { value, writable: true }]),
  )
