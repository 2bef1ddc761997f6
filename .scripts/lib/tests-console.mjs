// Imported before each test file: redirects console output to stderr. Node's runner reads the reports of a file from stdout, sometimes takes
// printed text for a part of them, and fails the file with "Unable to deserialize cloned data".
import { Console } from 'node:console'

globalThis.console = new Console({ stdout: process.stderr, stderr: process.stderr })
