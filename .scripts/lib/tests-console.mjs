// Imported before each test file: redirects console output to stderr. Node's runner reads the reports of a file from stdout, sometimes
// mistakes printed text for a part of a report, and fails the file with "Unable to deserialize cloned data".
import { Console } from 'node:console'

globalThis.console = new Console({ stdout: process.stderr, stderr: process.stderr })
