// Imported before each file of tests: what they print goes to stderr. On stdout Node's runner hears what a file reports, and now and
// then it takes what is printed between for a part of that, and fails the file: "Unable to deserialize cloned data".
import { Console } from 'node:console'

globalThis.console = new Console({ stdout: process.stderr, stderr: process.stderr })
