/** Memoizes an asynchronous function by its first argument. Failures are not remembered. */
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
