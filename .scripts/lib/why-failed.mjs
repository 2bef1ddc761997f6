// A reporter for Node's test runner. At the end it reports why a file failed although all its tests passed; `spec` only prints "test failed".
export default async function* (events) {
  const reasons = []
  for await (const { type, data } of events) {
    const { exitCode, signal } = data?.details?.error ?? {}
    if (type === 'test:diagnostic' && /^(Error|Warning): /.test(data.message))
      reasons.push(data.message)
    else if (type === 'test:fail' && (signal ?? exitCode) != null)
      reasons.push(`${data.name} ended with ${signal ?? exitCode}.`)
  }
  if (reasons.length) yield `\nOutside of the tests:\n${reasons.join('\n')}\n`
}
