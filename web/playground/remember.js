/** An asynchronous function that works out each result once, by its first argument; what fails is tried again. */
export function remember(make) {
  const made = new Map()
  return (key, ...rest) => {
    if (!made.has(key)) {
      const result = make(key, ...rest)
      made.set(key, result)
      result.catch(() => made.delete(key))
    }
    return made.get(key)
  }
}
